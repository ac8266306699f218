// Atlases read back from their text: islands apart, triangles turning left, each there once.
#include "io/atlas.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "catch.h"
#include "geometry/predicates.h"
#include "support/surface_meshes.h"
#include "support/surface_shapes.h"
#include "surface/charts/layout.h"

using namespace lpq;
using namespace lpq_test;

namespace {

struct AtlasFile {
  std::vector<Vec3> points;
  std::vector<Vec2> places;
  std::vector<std::string> islands;
  std::vector<Tri> corners, uv;
  std::vector<std::size_t> island;  // #T
  double side = 0;
};

AtlasFile read(const std::string& text) {
  AtlasFile file;
  std::istringstream lines(text);
  std::string line, word;
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    words >> word;
    if (word == "#") file.side = std::stod(line.substr(line.find(" is ") + 4));
    if (word == "v")
      words >> file.points.emplace_back().x >> file.points.back().y >> file.points.back().z;
    if (word == "vt") words >> file.places.emplace_back().x >> file.places.back().y;
    if (word == "g") file.islands.push_back(line.substr(2));
    if (word != "f") continue;
    char slash = 0;
    Tri& corners = file.corners.emplace_back();
    Tri& uv = file.uv.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      words >> corners[k] >> slash >> uv[k];
      --corners[k];
      --uv[k];
    }
    file.island.push_back(file.islands.size() - 1);
  }
  return file;
}

Tri sorted(Tri t) {
  std::sort(t.begin(), t.end());
  return t;
}

struct Bounds {
  Vec2 low{1e300, 1e300}, high{-1e300, -1e300};
  void add(Vec2 p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
};

void check_apart(const AtlasFile& file) {
  std::vector<Bounds> bounds(file.islands.size());
  for (std::size_t t = 0; t < file.uv.size(); ++t)
    for (const Index p : file.uv[t]) bounds[file.island[t]].add(file.places[p]);
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    CHECK(bounds[i].low.x > 0);
    CHECK(bounds[i].low.y > 0);
    CHECK(bounds[i].high.x < 1);
    CHECK(bounds[i].high.y < 1);
    for (std::size_t j = 0; j < i; ++j) {
      const bool apart = bounds[i].high.x < bounds[j].low.x || bounds[j].high.x < bounds[i].low.x ||
                         bounds[i].high.y < bounds[j].low.y || bounds[j].high.y < bounds[i].low.y;
      CHECK(apart);
    }
  }
}

/// Nearly the same shape and the same size everywhere, up to what the charts allow.
void check_scale(const AtlasFile& file) {
  double plane = 0, space = 0;
  for (std::size_t t = 0; t < file.uv.size(); ++t) {
    const auto [a, b, c] = file.uv[t];
    const auto [i, j, k] = file.corners[t];
    plane += 0.5 * cross(file.places[b] - file.places[a], file.places[c] - file.places[a]);
    space += 0.5 * length(cross(file.points[j] - file.points[i], file.points[k] - file.points[i]));
  }
  const double ratio = plane * file.side * file.side / space;
  CHECK(ratio > 0.3);
  CHECK(ratio < 3);
  CHECK(plane > 0.2);  // of the square is used
}

AtlasFile checked_atlas(const SurfaceSoup& soup, double size) {
  const auto outcome = mesh_surface(soup, {.size = size});
  REQUIRE(outcome.has_value());
  const AtlasFile file = read(write_atlas_obj(*outcome));
  CHECK(file.points == outcome->surface.points);
  CHECK(file.islands.size() == outcome->atlas.charts.size());
  std::vector<Tri> written, given;
  for (const Tri& t : file.corners) written.push_back(sorted(t));
  for (const Tri& t : outcome->surface.triangles) given.push_back(sorted(t));
  std::sort(written.begin(), written.end());
  std::sort(given.begin(), given.end());
  CHECK(written == given);
  Index turned = 0;
  for (const auto& [a, b, c] : file.uv)
    turned += orient2d(file.places[a], file.places[b], file.places[c]) <= 0;
  CHECK(turned == 0);
  check_apart(file);
  check_scale(file);
  return file;
}

}  // namespace

TEST_CASE("a box has six islands of true shape, named after its faces") {
  SurfaceSoup soup = box_soup({1, 2, 1}, 2);
  soup.group_names = {"", "the lid"};
  soup.group.assign(soup.triangles.size(), 0);
  std::fill(soup.group.end() - 8, soup.group.end(), 1);
  const AtlasFile file = checked_atlas(soup, 0.5);
  REQUIRE(file.islands.size() == 6);
  CHECK(file.islands.front() == "face_1 chart_1");
  CHECK(std::count_if(file.islands.begin(), file.islands.end(), [](const std::string& name) {
          return name.substr(0, 14) == "the_lid chart_";
        }) == 1);
  for (std::size_t t = 0; t < file.uv.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const double there =
          distance(file.points[file.corners[t][k]], file.points[file.corners[t][(k + 1) % 3]]);
      const Vec2 side = file.places[file.uv[t][(k + 1) % 3]] - file.places[file.uv[t][k]];
      CHECK(std::abs(file.side * std::sqrt(dot(side, side)) - there) < 1e-9);
    }
}

TEST_CASE("closed and bent surfaces have islands that lie apart") {
  checked_atlas(soup_of(sphere(8)), 0.3);
  checked_atlas(soup_of(torus(32, 16, 1, 0.4)), 0.2);
  checked_atlas(soup_of(cylinder(24, 12, 0.5, 3)), 0.3);
}

TEST_CASE("islands of every size find a place") {
  std::vector<Chart> charts(50);
  for (std::size_t c = 0; c < charts.size(); ++c) {
    const double w = c % 7 == 0 ? 40 : 0.5 + static_cast<double>(c % 5),
                 h = 20.0 / (1.0 + static_cast<double>(c));
    charts[c].plane.points = {{-w, 3}, {w, 3}, {w, 3 + h}, {-w, 3 + h}};
  }
  charts[9].plane.points = {{0, 0}, {0, 0}, {0, 0}};  // without a map
  const AtlasLayout layout = lay_out(charts);
  std::vector<Bounds> bounds(charts.size());
  for (std::size_t c = 0; c < charts.size(); ++c)
    for (const Vec2 p : charts[c].plane.points)
      bounds[c].add(layout.place(static_cast<Index>(c), p));
  for (std::size_t i = 0; i < charts.size(); ++i) {
    CHECK(std::min(bounds[i].low.x, bounds[i].low.y) > 0);
    CHECK(std::max(bounds[i].high.x, bounds[i].high.y) < 1);
    for (std::size_t j = 0; j < i; ++j)
      CHECK((bounds[i].high.x < bounds[j].low.x || bounds[j].high.x < bounds[i].low.x ||
             bounds[i].high.y < bounds[j].low.y || bounds[j].high.y < bounds[i].low.y));
  }
  CHECK(lay_out({}).side > 0);
}
