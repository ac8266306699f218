// Blocks, cuts and plans: what can be filled is filled with the promised valences.
#include "patches/block.h"

#include <cmath>
#include <numeric>

#include "catch.h"
#include "cleanup/quad_topology.h"
#include "numerics/elementary.h"
#include "patches/plan.h"
#include "support/cleanup_meshes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

// A regular n-gon whose sides have the given numbers of edges.
Polygon polygon_of(const std::vector<int>& lengths) {
  Polygon polygon;
  const int n = static_cast<int>(lengths.size());
  const double radius = std::accumulate(lengths.begin(), lengths.end(), 0) / (2 * pi);
  for (int i = 0; i < n; ++i) {
    polygon.corner.push_back(static_cast<Index>(polygon.points.size()));
    for (int k = 0; k < lengths[i]; ++k) {
      const double t = 2 * pi * (i + static_cast<double>(k) / lengths[i]) / n;
      polygon.points.push_back({radius * std::cos(t), radius * std::sin(t)});
      polygon.size.push_back(1);
    }
  }
  return polygon;
}

QuadMesh mesh_of(const Polygon& polygon, const Filling& filling) {
  QuadMesh mesh;
  mesh.points = filling.points;
  mesh.faces = filling.faces;
  mesh.fixed = static_cast<Index>(polygon.points.size());
  return mesh;
}

// One quad at every corner of the polygon, two at every other place of its rim, and inside as many
// irregular vertices as the plan says, each with 3 or 5 quads.
void check_filling(const Polygon& polygon, const Plan& plan) {
  const QuadMesh mesh = mesh_of(polygon, fill(polygon, plan));
  const Csr<Index> stars = faces_at_vertices(mesh);
  std::vector<Index> quads(mesh.points.size(), 2);
  for (const Index corner : polygon.corner) quads[corner] = 1;
  int irregular = 0;
  for (Index v = 0; v < stars.rows(); ++v) {
    const Index count = static_cast<Index>(stars.row(v).size());
    if (v < mesh.fixed) {
      CHECK(count == quads[v]);
    } else if (count != 4) {
      CHECK((count == 3 || count == 5));
      ++irregular;
    }
  }
  CHECK(irregular == plan.irregular);
  CHECK(border_of(mesh).size() == polygon.points.size());
  CHECK(area_of(mesh) > 0);
}

}  // namespace

//      /\            3 corners, one 3-valent vertex:
//     /  \           spokes r_j = S/2 - s_j
//    / \/ \  .
//   /__|___\ .
TEST_CASE("spokes of a triangle and a pentagon add up to the sides") {
  for (const std::vector<int>& s : {std::vector<int>{3, 4, 5}, {2, 2, 2}, {7, 4, 5}}) {
    const Spokes spokes = find_spokes(s);
    REQUIRE(spokes.fits);
    for (int i = 0; i < 3; ++i)
      CHECK(spokes.edges[(i + 2) % 3] + spokes.edges[(i + 1) % 3] == s[i]);
  }
  const std::vector<int> s{4, 5, 3, 4, 6};
  const Spokes spokes = find_spokes(s);
  REQUIRE(spokes.fits);
  for (int i = 0; i < 5; ++i) CHECK(spokes.edges[(i + 4) % 5] + spokes.edges[(i + 1) % 5] == s[i]);
}

TEST_CASE("what does not fit is refused") {
  CHECK(!find_spokes(std::vector<int>{3, 4, 4}).fits);        // odd sum
  CHECK(!find_spokes(std::vector<int>{8, 2, 2}).fits);        // no triangle
  CHECK(!find_spokes(std::vector<int>{3, 4, 3, 5}).fits);     // unequal opposite sides
  CHECK(!find_spokes(std::vector<int>{9, 1, 1, 1, 2}).fits);  // a spoke would be negative
  CHECK(!find_spokes(std::vector<int>{2, 2}).fits);
}

TEST_CASE("polygons that fit are filled as one block") {
  for (const std::vector<int>& lengths :
       {std::vector<int>{4, 3, 4, 3}, {3, 4, 5}, {4, 5, 3, 4, 6}}) {
    const Polygon polygon = polygon_of(lengths);
    const std::vector<Plan> plans = make_plans(polygon, {});
    REQUIRE(plans.size() == 1);
    CHECK(plans[0].first_side == none);
    check_filling(polygon, plans[0]);
  }
}

//   +--+--+--+--+         opposite sides differ by two: a pair of a 3-valent and a
//   |  |  |  |  |         5-valent vertex takes two columns out
//   +--+-(5)-+--+
//   |   \ | /   |
//   +----(3)----+
TEST_CASE("other polygons are cut in two, from two corners to six") {
  for (const std::vector<int>& lengths : {std::vector<int>{6, 6},
                                          {4, 6, 2, 6},
                                          {5, 5, 4},
                                          {6, 6, 5, 3},
                                          {4, 6, 4, 6, 4},
                                          {4, 4, 5, 4, 4, 5}}) {
    const Polygon polygon = polygon_of(lengths);
    const std::vector<Plan> plans = make_plans(polygon, {});
    CAPTURE(lengths);
    for (const Plan& plan : plans) check_filling(polygon, plan);
    CHECK(!plans.empty());
  }
}

TEST_CASE("no plan has more irregular vertices than allowed") {
  const Polygon polygon = polygon_of({4, 6, 2, 6});
  CHECK(make_plans(polygon, {.most_irregular = 1}).empty());
  for (const Plan& plan : make_plans(polygon, {.most_irregular = 2})) CHECK(plan.irregular == 2);
}
