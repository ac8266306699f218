// See report.h.
#include "io/report.h"

#include <cmath>

#include "io/error_text.h"
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

/// 16 hexadecimal digits: a 64-bit number does not fit JavaScript's.
std::string hash_text(std::uint64_t hash) {
  constexpr char hex[] = "0123456789abcdef";
  std::string text;
  for (int shift = 60; shift >= 0; shift -= 4) text += hex[(hash >> shift) & 15];
  return text;
}

void append_options(JsonWriter& json, const Options& options) {
  json.key("options");
  json.begin_object();
  each_field(options, [&](const char* name, const auto& value, const FieldInfo&) {
    using T = std::remove_cvref_t<decltype(value)>;
    if constexpr (std::is_enum_v<T>) {
      json.member(name, choice_name(value));
    } else {
      json.member(name, value);
    }
  });
  json.end_object();
}

void append_quality(JsonWriter& json, const QuadQuality& quality) {
  json.key("quality");
  json.begin_object();
  json.member("etaMean", quality.eta_mean);
  json.member("etaMin", quality.eta_min);
  json.member("etaP5", quality.eta_p5);
  json.member("interiorVertices", quality.interior_vertices);
  json.member("fourValentPercent", quality.four_valent_percent);
  json.member("inverted", quality.inverted);
  json.member("nonconvex", quality.nonconvex);
  json.array("valenceHistogram", quality.valence_histogram);
  json.array("etaHistogram", quality.eta_histogram);
  json.end_object();
}

void append_lp(JsonWriter& json, const Report& report) {
  json.key("lp");
  json.begin_object();
  const bool ran = !report.energy_history.empty();
  json.member("ran", ran);
  if (ran) {
    json.member("status", status_name(report.lp_status));
    json.array("energy", report.energy_history);
    json.array("gradientNorm", report.gradient_norm_history);
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

void append_short_number(std::string& out, double value) {
  const double magnitude = std::fabs(value);
  const int decimals = magnitude >= 100 ? 1 : magnitude >= 10 ? 2 : 3;
  append_fixed(out, value, decimals);
}

/// "name      text\n" with the texts in one column.
void append_row(std::string& out, std::string_view name, std::string_view text) {
  constexpr std::size_t column = 14;
  out += name;
  out.append(name.size() < column ? column - name.size() : 1, ' ');
  out += text;
  out += '\n';
}

/// "label value, label value"
class Facts {
 public:
  Facts& add(std::string_view label, double value) {
    next(label);
    append_short_number(text_, value);
    return *this;
  }
  Facts& count(std::string_view label, std::int64_t value) {
    next(label);
    append_integer(text_, value);
    return *this;
  }
  Facts& unit(std::string_view unit) {
    text_ += unit;
    return *this;
  }
  const std::string& text() const { return text_; }

 private:
  void next(std::string_view label) {
    if (!text_.empty()) text_ += ", ";
    text_ += label;
    if (!label.empty()) text_ += ' ';
  }
  std::string text_;
};

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
  json.key("size");
  json.begin_object();
  json.member("p10", report.size.p10);
  json.member("p50", report.size.p50);
  json.member("p90", report.size.p90);
  json.member("min", report.size.min);
  json.member("max", report.size.max);
  json.end_object();
  json.new_line();
  append_lp(json, report);
  json.new_line();
  append_options(json, options);
  json.new_line();
  if (format.times) {
    json.key("cpuSeconds");
    json.begin_object();
    for (const StageTime& time : report.times) json.member(time.stage, time.cpu_seconds);
    json.end_object();
    json.new_line();
  }
  json.key("warnings");
  json.begin_array();
  for (const Warning& warning : report.warnings) append_error(json, warning);
  json.end_array();
  json.end_object();
  out += '\n';
  return out;
}

std::string quality_text(const QuadQuality& quality) {
  std::string out;
  append_row(out, "faces",
             Facts().count("quads", quality.quads).count("triangles", quality.triangles).text());
  append_row(out, "shape eta",
             Facts()
                 .add("mean", quality.eta_mean)
                 .add("5th percentile", quality.eta_p5)
                 .add("least", quality.eta_min)
                 .text());
  append_row(out, "interior",
             Facts()
                 .count("vertices", quality.interior_vertices)
                 .add("four-valent", quality.four_valent_percent)
                 .unit(" %")
                 .text());
  if (quality.inverted + quality.nonconvex > 0) {
    append_row(
        out, "invalid",
        Facts().count("inverted", quality.inverted).count("nonconvex", quality.nonconvex).text());
  }
  return out;
}

std::string report_text(const Report& report, const OutputMesh& mesh) {
  std::string out = quality_text(report.quality);
  append_row(out, "size / target",
             Facts()
                 .add("p10", report.size.p10)
                 .add("p50", report.size.p50)
                 .add("p90", report.size.p90)
                 .add("least", report.size.min)
                 .add("largest", report.size.max)
                 .text());
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
  }
  Facts times;
  double total = 0;
  for (const StageTime& time : report.times) {
    times.add(time.stage, time.cpu_seconds).unit(" s");
    total += time.cpu_seconds;
  }
  append_row(out, "CPU time", times.add("total", total).unit(" s").text());
  for (const Warning& warning : report.warnings) append_row(out, "warning", error_text(warning));
  return out;
}

}  // namespace lpq
