// See report.h.
#include "io/report.h"

#include "io/json_write.h"

namespace lpq {
namespace {

const char* status_name(LpStatus status) {
  switch (status) {
    case LpStatus::running: return "running";
    case LpStatus::converged: return "converged";
    case LpStatus::stagnated: return "stagnated";
    case LpStatus::stalled: return "stalled";
    case LpStatus::iteration_limit: return "iteration limit";
  }
  return "";
}

void append_rounds(JsonWriter& json, const std::vector<RestartRound>& rounds) {
  json.begin_array("rounds");
  for (const RestartRound& round : rounds) {
    json.begin_object();
    json.member("inserted", round.inserted);
    json.member("removed", round.removed);
    json.member("kept", round.kept);
    json.end_object();
  }
  json.end_array();
}

std::string rounds_text(const std::vector<RestartRound>& rounds) {
  std::int64_t kept = 0, inserted = 0, removed = 0;
  for (const RestartRound& round : rounds) {
    if (!round.kept) continue;
    ++kept;
    inserted += round.inserted;
    removed += round.removed;
  }
  return Facts()
      .count("tried", static_cast<std::int64_t>(rounds.size()))
      .count("kept", kept)
      .count("inserted", inserted)
      .count("removed", removed)
      .text();
}

void append_lp(JsonWriter& json, const Report& report) {
  json.begin_object("lp");
  const bool ran = !report.energy_history.empty();
  json.member("ran", ran);
  if (ran) {
    json.member("status", status_name(report.lp_status));
    json.array("energy", report.energy_history);
    json.array("gradientNorm", report.gradient_norm_history);
    append_rounds(json, report.lp_rounds);
  }
  json.end_object();
}

void append_counts(JsonWriter& json, const Report& report, const OutputMesh& mesh) {
  json.member("vertices", mesh.points.size());
  json.member("quads", report.quality.quads);
  json.member("triangles", report.quality.triangles);
  json.member("boundaryNodes", report.boundary_nodes);
  json.member("boundaryEdges", report.boundary_edges);
  json.member("seeds", report.seeds);
  json.member("expectedSeeds", report.expected_seeds);
  json.member("singularities", report.singularities.size());
  json.member("tau", report.tau);
  json.member("matchingCost", report.matching_cost);
  json.member("extraEdges", report.extra_edges);
  json.member("attempts", report.attempts);
  json.member("chain", report.chain);
  json.member("simplifyDeviation", report.simplify_deviation);
  json.member("hash", hash_text(report.hash));
}

}  // namespace

std::string write_report_json(const Report& report, const OutputMesh& mesh, const Options& options,
                              const ReportFormat& format) {
  std::string out;
  JsonWriter json(out);
  json.begin_object();
  append_counts(json, report, mesh);
  json.new_line();
  append_quality(json, report.quality);
  json.new_line();
  append_size(json, report.size);
  json.new_line();
  append_lp(json, report);
  json.new_line();
  append_options(json, options);
  json.new_line();
  if (format.times) append_times(json, report.times);
  append_warnings(json, report.warnings);
  json.end_object();
  out += '\n';
  return out;
}

std::string report_text(const Report& report, const OutputMesh& mesh) {
  std::string out = quality_text(report.quality) + size_text(report.size);
  append_row(out, "vertices",
             Facts()
                 .count("", static_cast<std::int64_t>(mesh.points.size()))
                 .count("on the boundary", report.boundary_nodes)
                 .count("singularities", static_cast<std::int64_t>(report.singularities.size()))
                 .text());
  append_row(out, "chain", report.chain);
  if (!report.energy_history.empty()) {
    std::string energy;
    append_number(energy, report.energy_history.front());
    energy += " -> ";
    append_number(energy, report.energy_history.back());
    energy += " (";
    energy += status_name(report.lp_status);
    energy += ')';
    append_row(out, "L_p energy", energy);
    if (!report.lp_rounds.empty()) append_row(out, "L_p restarts", rounds_text(report.lp_rounds));
  }
  return out + end_text(report.times, report.warnings);
}

}  // namespace lpq
