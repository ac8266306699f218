// What the library says about itself is JSON, and covers every table.
#include "io/describe.h"

#include "catch.h"
#include "io/domain/domain_format.h"
#include "io/domain/json_domain.h"
#include "io/mesh/mesh_format.h"
#include "io/surface/surface_format.h"
#include "pipeline/options.h"
#include "shell/options.h"

using namespace lpq;

TEST_CASE("the description is JSON and names every option, code and format") {
  const std::string text = write_description();
  // The reader of domains passes over what it does not know, if it is well formed.
  const auto read = read_json_domain("{\"loops\":[],\"described\":" + text + "}");
  CHECK(read.has_value());
  const auto names = [&](std::string_view name) {
    return text.find('"' + std::string(name) + '"') != std::string::npos;
  };
  const Options options;
  each_field(options,
             [&](const char* name, const auto&, const OptionInfo&) { CHECK(names(name)); });
  for (const MeshFormatInfo& info : mesh_formats) CHECK(names(info.name));
  for (const DomainFormatInfo& info : domain_formats) CHECK(names(info.name));
  for (const SurfaceFormatInfo& info : surface_formats) CHECK(names(info.name));
  const SurfaceOptions surface;
  each_field(surface,
             [&](const char* name, const auto&, const OptionInfo&) { CHECK(names(name)); });
  CHECK(names(code_name(ErrorCode::parse_error)));
  CHECK(names(code_name(ErrorCode::io_error)));
  CHECK(names(version()));
}

TEST_CASE("a domain written as JSON reads back bit for bit") {
  DomainInput domain;
  domain.regions.push_back({"a \"b\"\n",
                            {{{0, 0}, {1.0 / 3, 1e-300}, {0.1, 2}}, {{5, 5}, {6, 5}, {5, 6}}},
                            {{"x", "", "y"}, {"", "", ""}}});
  domain.regions.push_back({"", {}, {}});
  domain.polylines.push_back({{{0.25, 0.5}, {0.75, 0.5}}, "crack"});
  domain.points.push_back({{1e17, -0.0}, "probe"});
  domain.h = 0.1;
  const auto file = read_json_domain(write_domain_json(domain));
  REQUIRE(file.has_value());
  const DomainInput* back = &file->domain;
  REQUIRE(back->regions.size() == 2);
  CHECK(back->regions[0].name == domain.regions[0].name);
  CHECK(back->regions[0].loops == domain.regions[0].loops);
  CHECK(back->regions[0].tags == domain.regions[0].tags);
  CHECK(back->polylines[0].points == domain.polylines[0].points);
  CHECK(back->polylines[0].tag == "crack");
  CHECK(back->points[0].position == domain.points[0].position);
  CHECK(back->points[0].tag == "probe");
  CHECK(back->h == 0.1);
  CHECK(write_domain_json(*back) == write_domain_json(domain));
}
