// Boundaries whose counts are those of a grid.
#include "grids/balanced_pieces.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "catch.h"
#include "domain/domain.h"
#include "grids/ring_pieces.h"
#include "support/shapes.h"

using namespace lpq;
using namespace lpq_test;

namespace {

struct Refined {
  Domain domain;
  BoundaryOptions options;
  BoundaryMesh mesh;
};

Refined refined(const DomainInput& input, double h) {
  auto domain = make_domain(input);
  REQUIRE(domain);
  Refined all{std::move(*domain), {}, {}};
  all.options.keep = false;
  all.options.size = all.domain.frame.length_to_frame(h);
  auto mesh = sample_boundary(all.domain, all.options);
  REQUIRE(mesh);
  all.mesh = std::move(*mesh);
  return all;
}

/// With the counts that are found for it.
BoundaryMesh balanced(Refined& all) {
  all.options.pieces = balanced_pieces(all.mesh);
  if (all.options.pieces.empty()) return all.mesh;
  REQUIRE(all.options.pieces.size() == all.mesh.pieces.count.size());
  auto mesh = sample_boundary(all.domain, all.options);
  REQUIRE(mesh);
  CHECK(mesh->pieces.count == all.options.pieces);
  return std::move(*mesh);
}

Vec2 turned(Vec2 p, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * p.x - s * p.y, s * p.x + c * p.y};
}

/// Edges of a loop one way less edges the other way, along both axes, which are turned.
std::array<Index, 2> difference(const BoundaryMesh& mesh, Index loop, double angle) {
  std::array<Index, 2> sum{0, 0};
  for (const Segment& edge : mesh.edges) {
    if (edge.loop != loop) continue;
    Vec2 d = turned(mesh.points[edge.b] - mesh.points[edge.a], -angle);
    if (edge.left == none) d = -d;
    if (std::abs(d.x) > std::abs(d.y)) {
      sum[0] += d.x > 0 ? 1 : -1;
    } else {
      sum[1] += d.y > 0 ? 1 : -1;
    }
  }
  return sum;
}

Index edges_of(const BoundaryMesh& mesh, Index loop) {
  return static_cast<Index>(std::count_if(mesh.edges.begin(), mesh.edges.end(),
                                          [&](const Segment& edge) { return edge.loop == loop; }));
}

Loop polygon(Vec2 centre, double radius, int corners) {
  Loop loop;
  for (int k = 0; k < corners; ++k) {
    const double angle = 2 * std::numbers::pi * k / corners;
    loop.push_back(centre + radius * Vec2{std::cos(angle), std::sin(angle)});
  }
  return loop;
}

const std::vector<Vec2> tee{{0, 0},      {1.03, 0},  {1.03, 2}, {2.1, 2},
                            {2.1, 3.17}, {-1, 3.17}, {-1, 2},   {0, 2}};
const std::vector<Vec2> comb{{0, 0},   {7, 0},   {7, 3},     {5.6, 3},   {5.6, 1.1}, {4.2, 1.1},
                             {4.2, 3}, {2.9, 3}, {2.9, 1.1}, {1.3, 1.1}, {1.3, 3},   {0, 3}};

}  // namespace

TEST_CASE("opposite sides of right-angled outlines get the same number of edges", "[grids]") {
  const double angle = GENERATE(0.0, 0.3, 1.1, 2.9);
  int uneven = 0;
  for (const std::vector<Vec2>& outline : {tee, comb})
    for (double h = 0.07; h < 0.6; h += 0.013) {
      INFO(outline.size() << " corners, h " << h << ", turned by " << angle);
      std::vector<Loop> loops{outline, {{0.3, 0.2}, {0.7, 0.2}, {0.7, 0.7}, {0.3, 0.7}}};
      for (Loop& loop : loops)
        for (Vec2& p : loop) p = turned(p, angle);
      Refined all = refined(domain_of(loops), h);
      const BoundaryMesh mesh = balanced(all);
      for (const Index loop : {0, 1}) {
        uneven += difference(all.mesh, loop, angle) != std::array<Index, 2>{0, 0};
        CHECK(difference(mesh, loop, angle) == std::array<Index, 2>{0, 0});
      }
      for (std::size_t s = 0; s < mesh.pieces.count.size(); ++s)
        CHECK(std::abs(mesh.pieces.count[s] - mesh.pieces.wanted[s]) < 1.6);
    }
  CHECK(uneven > 10);
}

TEST_CASE("outlines without a lattice of their own keep their counts", "[grids]") {
  CHECK(balanced_pieces(refined(domain_of({polygon({}, 1, 9)}), 0.11).mesh).empty());
  CHECK(balanced_pieces(refined(domain_of({{{0, 0}, {3, 0}, {1.1, 2}}}), 0.2).mesh).empty());
  // the hole is half as long only
  CHECK(balanced_pieces(refined(domain_of({polygon({}, 1, 16), polygon({}, 0.5, 16)}), 0.09).mesh)
            .empty());
}

TEST_CASE("sides too different to have the same number of edges keep theirs", "[grids]") {
  const auto mesh = refined(domain_of({{{0, 0}, {4, 0}, {2.6, 2}, {1.2, 2}}}), 0.1).mesh;
  const std::vector<Index> pieces = balanced_pieces(mesh);
  if (!pieces.empty()) CHECK(pieces[0] > pieces[2] + 20);
}

TEST_CASE("what divides the inside leaves counts alone", "[grids]") {
  DomainInput input = domain_of({tee});
  input.polylines.push_back({{{0.3, 0.5}, {0.7, 0.9}}, {}});
  CHECK(balanced_pieces(refined(input, 0.17).mesh).empty());
}

TEST_CASE("a kept boundary has no pieces to balance", "[grids]") {
  auto domain = make_domain(domain_of({tee}));
  REQUIRE(domain);
  const auto mesh = sample_boundary(*domain, {.keep = true});
  REQUIRE(mesh);
  CHECK(balanced_pieces(*mesh).empty());
}

TEST_CASE("both borders of a ring get the same number of edges", "[grids]") {
  for (const auto& [outer, inner] : {std::pair{32, 24}, {16, 16}, {7, 30}})
    for (double h = 0.05; h < 0.2; h += 0.011) {
      INFO(outer << " and " << inner << " corners, h " << h);
      Refined all = refined(domain_of({polygon({}, 1, outer), polygon({}, 0.75, inner)}), h);
      const BoundaryMesh mesh = balanced(all);
      CHECK(edges_of(mesh, 0) == edges_of(mesh, 1));
      // each is within a quarter of its size, where the caller's points leave it the choice
      double wanted = 0;
      for (const double w : all.mesh.pieces.wanted) wanted += std::max(1.0, w);
      CHECK(std::abs(static_cast<double>(mesh.edges.size()) - wanted) < 0.25 * wanted);
    }
}

TEST_CASE("nodes of a ring lie opposite each other", "[grids]") {
  SegmentPieces pieces;
  pieces.wanted.assign(28, 3.4);
  pieces.wanted.insert(pieces.wanted.end(), 20, 3.9);
  pieces.is_whole.assign(48, 0);
  std::vector<Index> outer(28), inner(20);
  std::iota(outer.begin(), outer.end(), 0);
  std::iota(inner.begin(), inner.end(), 28);
  const RingPieces ring = ring_pieces(pieces, outer, inner);
  const auto check = [](const std::vector<Index>& shares, Index edges) {
    Index passed = 0;
    for (std::size_t k = 0; k < shares.size(); ++k) {
      CHECK(shares[k] >= 1);
      passed += shares[k];
      const double even = edges * static_cast<double>(k + 1) / static_cast<double>(shares.size());
      CHECK(std::abs(passed - even) < 1);
    }
    CHECK(passed == edges);
  };
  const Index edges = std::accumulate(ring.outer.begin(), ring.outer.end(), 0);
  REQUIRE(ring.outer.size() == 28);
  REQUIRE(ring.inner.size() == 20);
  CHECK(edges > 78);
  CHECK(edges < 95);
  check(ring.outer, edges);
  check(ring.inner, edges);
  pieces.is_whole[30] = 1;
  CHECK(ring_pieces(pieces, outer, inner).outer.empty());
}

TEST_CASE("regions apart from each other are no ring", "[grids]") {
  DomainInput input = domain_of({polygon({}, 1, 24)});
  input.regions.push_back({"", {polygon({3, 0}, 0.8, 24)}, {}});
  CHECK(balanced_pieces(refined(input, 0.1).mesh).empty());
}

TEST_CASE("a ring whose sizes vary keeps its counts", "[grids]") {
  const DomainInput input = domain_of({polygon({}, 1, 24), polygon({}, 0.75, 24)});
  CHECK_FALSE(balanced_pieces(refined(input, 0.1).mesh).empty());
  Refined all = refined(input, 0.1);
  all.options.sizes = {{all.domain.frame.to_frame({0, 1}), all.domain.frame.length_to_frame(0.04)}};
  const auto mesh = sample_boundary(all.domain, all.options);
  REQUIRE(mesh);
  CHECK(balanced_pieces(*mesh).empty());
}

TEST_CASE("a hole beside the middle of the outline is no ring's", "[grids]") {
  // A bean: its centre is outside of it.
  Loop bean;
  for (int k = 0; k <= 12; ++k) {
    const double angle = 0.4 + 2.3 * k / 12;
    bean.push_back(0.8 * Vec2{std::cos(angle), std::sin(angle)});
  }
  for (int k = 12; k >= 0; --k) {
    const double angle = 0.4 + 2.3 * k / 12;
    bean.push_back(0.6 * Vec2{std::cos(angle), std::sin(angle)});
  }
  CHECK(balanced_pieces(refined(domain_of({polygon({}, 1, 24), bean}), 0.12).mesh).empty());
}
