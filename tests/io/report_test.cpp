// Reports, errors and stage files.
#include "io/report.h"

#include <algorithm>

#include "catch.h"
#include "io/error_text.h"
#include "io/iterates.h"
#include "io/stages.h"
#include "support/output_meshes.h"

using namespace lpq;

TEST_CASE("errors name their code, sentence and place") {
  Error error{ErrorCode::self_intersection, "Two edges cross.", {}};
  CHECK(error_text(error) == "SELF_INTERSECTION: Two edges cross.");
  error.where.loop = 0;
  error.where.edge = 3;
  error.where.other_loop = 1;
  error.where.other_edge = 7;
  error.where.has_point = true;
  error.where.x = 0.5;
  CHECK(error_text(error) ==
        "SELF_INTERSECTION: Two edges cross. (loop 0 edge 3, loop 1 edge 7, at 0.5 0)");
  CHECK(write_error_json(error) ==
        "{\"error\":{\"code\":\"SELF_INTERSECTION\",\"message\":\"Two edges cross.\",\"where\":"
        "{\"loop\":0,\"edge\":3,\"otherLoop\":1,\"otherEdge\":7,\"x\":0.5,\"y\":0}}}\n");
}

TEST_CASE("an edge of a polyline is no edge of the loop before it") {
  Error error{ErrorCode::touching, "No.", {}};
  error.where.region = 1;
  error.where.loop = 0;
  error.where.edge = 4;
  error.where.other_edge = 2;
  CHECK(error_text(error) == "TOUCHING: No. (region 1, loop 0 edge 4, polyline edge 2)");
}

TEST_CASE("a parse error shows line and byte") {
  Error error{ErrorCode::parse_error, "No.", {}};
  error.where.line = 2;
  error.where.byte = 17;
  CHECK(error_text(error) == "PARSE_ERROR: No. (line 2 byte 17)");
}

TEST_CASE("a report holds every option by name, and without times the same bytes") {
  Report report;
  report.hash = 0x0123456789abcdefu;
  report.energy_history = {2, 1};
  report.lp_rounds = {{3, 1, true, 0.5}, {2, 0, false, 0.7}};
  report.times = {{"match", 0.25}};
  report.warnings.push_back({ErrorCode::duplicate_point, "Merged.", {}});
  const OutputMesh mesh = lpq_test::grid_mesh(2);
  const Options options;
  const std::string json = write_report_json(report, mesh, options);
  CHECK(json.find("\"hash\":\"0123456789abcdef\"") != std::string::npos);
  CHECK(json.find("\"cpuSeconds\":{\"match\":0.25}") != std::string::npos);
  CHECK(json.find("\"code\":\"DUPLICATE_POINT\"") != std::string::npos);
  each_field(options, [&](const char* name, const auto&, const OptionInfo&) {
    INFO(name);
    CHECK(json.find("\"" + std::string(name) + "\":") != std::string::npos);
  });
  Report slower = report;
  slower.times[0].cpu_seconds = 3;
  CHECK(write_report_json(report, mesh, options, {.times = false}) ==
        write_report_json(slower, mesh, options, {.times = false}));
  CHECK(report_text(report, mesh).find("warning") != std::string::npos);
}

TEST_CASE("a matching is written with its certificate in whole units") {
  const std::vector<CostEdge> graph{{0, 1, 3}, {1, 2, 5}, {2, 3, 4}, {3, 0, 9}};
  const Matching matching = min_cost_perfect_matching(4, graph);
  const std::string json = write_matching_json(graph, matching);
  CHECK(json.find("\"n\":4,\"cost\":7,") != std::string::npos);
  CHECK(json.find("\"matching\":[[0,1],[2,3]],") != std::string::npos);
  CHECK(json.find("\"y\":[\"") != std::string::npos);
}

TEST_CASE("the bytes of the iterations are as many as their index says") {
  // Two triangles, and the cells of their four corners: one piece each.
  Trace trace;
  trace.start = {
      .points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, .triangles = {{0, 1, 2}, {0, 2, 3}}, .fixed = 4};
  trace.start.twins = {none, none, 3, 2, none, none};
  trace.start.region = {0, 0};
  Fields fields;
  fields.background = trace.start;
  fields.h = {1, 1, 1, 1};
  fields.z = {{1, 0}, {1, 0}, {1, 0}, {1, 0}};
  fields.attach();
  trace.fields = std::make_shared<const Fields>(std::move(fields));
  for (const int k : {1, 2}) trace.iterates.push_back({k, trace.start});
  std::string index, bytes;
  write_iterates(trace, [&](std::string_view name, const std::string& content) {
    (name == "iterates.json" ? index : bytes) = content;
  });
  CHECK(index.find("\"boundaryNodes\":4") != std::string::npos);
  CHECK(index.find("\"iteration\":2,\"points\":4,\"triangles\":2,\"pieces\":4,\"corners\":") !=
        std::string::npos);
  const std::size_t corners = std::stoul(index.substr(index.rfind(':') + 1));
  const std::size_t words = 2 * (8 + 4 + 2 * corners) + 6 + 4 + 5;
  CHECK(bytes.size() == 2 * 4 * (words + words % 2));
  CHECK(bytes.substr(16, 8) == std::string("\0\0\0\0\0\0\xF0\x3F", 8));  // x of the second point
}

TEST_CASE("every stage becomes a file with a plain name, even of an empty run") {
  std::vector<std::string> names;
  Trace trace;
  trace.quads.push_back({"clean up/2", {}});
  write_stages(trace, {}, [&](std::string_view name, const std::string& content) {
    names.emplace_back(name);
    CHECK_FALSE(content.empty());
    CHECK(name.find_first_of("/\\ ") == std::string_view::npos);
  });
  for (const char* name :
       {"background.obj", "crosses.json", "sizes.json", "triangles.obj", "cells.json",
        "energy.json", "matching.json", "quads-1-clean-up-2.obj"}) {
    INFO(name);
    CHECK(std::count(names.begin(), names.end(), name) == 1);
  }
}
