// See surface_report.h.
#include "io/surface_report.h"

namespace lpq {
namespace {

void append_counts(JsonWriter& json, const ShellOutcome& outcome) {
  const ShellReport& report = outcome.report;
  json.member("vertices", outcome.mesh.points.size());
  json.member("quads", report.quality.quads);
  json.member("triangles", report.quality.triangles);
  json.member("faces", report.faces);
  json.member("curves", report.curves);
  json.member("corners", report.corners);
  json.member("featureEdges", report.feature_edges);
  json.member("charts", report.charts);
  json.member("singularities", report.singularities.size());
  json.member("rounds", report.rounds);
  json.member("windowsOpened", report.seams.windows);
  json.member("windowsAccepted", report.seams.accepted);
  json.member("shapeRefills", report.shape.refilled);
  json.member("tipsReached", report.shape.reached);
  json.member("cornersMoved", report.shape.eased);
  json.member("targetSize", report.target_size);
  json.member("hash", hash_text(report.hash));
}

void append_distance(JsonWriter& json, const SurfaceDistance& distance) {
  const auto one_way = [&](const char* name, const Distance& way) {
    json.begin_object(name);
    json.member("max", way.max);
    json.member("mean", way.mean);
    json.end_object();
  };
  json.begin_object("distance");
  one_way("toSurface", distance.to_surface);
  one_way("fromSurface", distance.from_surface);
  json.end_object();
}

void append_bodies(JsonWriter& json, const std::vector<BodyReport>& bodies) {
  json.begin_array("bodies");
  for (const BodyReport& body : bodies) {
    json.begin_object();
    json.member("name", body.name);
    json.member("vertices", body.vertices);
    json.member("quads", body.quads);
    json.member("triangles", body.triangles);
    json.member("parts", body.parts);
    json.member("borderEdges", body.border_edges);
    json.end_object();
  }
  json.end_array();
}

void append_repairs(JsonWriter& json, const RepairReport& repair) {
  json.begin_object("repairs");
  json.member("pointsGiven", repair.points_given);
  json.member("trianglesGiven", repair.triangles_given);
  json.member("weldedPoints", repair.welded_points);
  json.member("rounding", repair.rounding);
  json.member("slitPoints", repair.slit_points);
  json.member("hangingPoints", repair.hanging_points);
  json.member("unusedPoints", repair.unused_points);
  json.member("collapsedTriangles", repair.collapsed_triangles);
  json.member("duplicateTriangles", repair.duplicate_triangles);
  json.member("flatTriangles", repair.flat_triangles);
  json.member("dividedTriangles", repair.divided_triangles);
  json.member("flatLeft", repair.flat_left);
  json.member("turnedTriangles", repair.turned_triangles);
  json.member("components", repair.components);
  json.member("borderEdges", repair.border_edges);
  json.member("gapPoints", repair.gap.points);
  json.member("gapWidth", repair.gap.width);
  json.member("nonmanifoldEdges", repair.nonmanifold_edges);
  json.member("conflictEdges", repair.conflict_edges);
  json.member("nonmanifoldVertices", repair.nonmanifold_vertices);
  json.end_object();
}

}  // namespace

std::string distance_text(const SurfaceDistance& distance) {
  std::string out;
  append_row(out, "distance",
             "to the surface " + short_number(distance.to_surface.max) + " at most, " +
                 short_number(distance.to_surface.mean) + " in the mean; from it " +
                 short_number(distance.from_surface.max) + " and " +
                 short_number(distance.from_surface.mean));
  return out;
}

std::string write_surface_report_json(const ShellOutcome& outcome, const SurfaceOptions& options,
                                      const ReportFormat& format) {
  const ShellReport& report = outcome.report;
  std::string out;
  JsonWriter json(out);
  json.begin_object();
  append_counts(json, outcome);
  json.new_line();
  append_quality(json, report.quality);
  json.new_line();
  append_size(json, report.size);
  json.new_line();
  append_distance(json, report.distance);
  json.new_line();
  append_repairs(json, report.repair);
  json.new_line();
  append_bodies(json, report.bodies);
  json.new_line();
  append_options(json, options);
  json.new_line();
  if (format.times) append_times(json, report.times);
  append_warnings(json, report.warnings);
  json.end_object();
  out += '\n';
  return out;
}

std::string surface_report_text(const ShellOutcome& outcome) {
  const ShellReport& report = outcome.report;
  std::string out =
      quality_text(report.quality) + size_text(report.size) + distance_text(report.distance);
  append_row(out, "vertices",
             Facts()
                 .count("", static_cast<std::int64_t>(outcome.mesh.points.size()))
                 .count("singularities", static_cast<std::int64_t>(report.singularities.size()))
                 .text());
  Facts facts;
  facts.count("triangles", outcome.surface.triangle_count())
      .count("faces", report.faces)
      .count("curves", report.curves)
      .count("charts", report.charts)
      .count("border edges", report.repair.border_edges);
  if (!report.bodies.empty())
    facts.count("bodies", static_cast<std::int64_t>(report.bodies.size()));
  append_row(out, "surface", facts.text());
  return out + end_text(report.times, report.warnings);
}

}  // namespace lpq
