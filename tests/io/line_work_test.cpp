// Joining, faces and nesting against brute force and against areas known beforehand.
#include "base/rng.h"
#include "catch.h"
#include "geometry/polygon.h"
#include "io/domain/drawing.h"

using namespace lpq;

namespace {

using Square = std::vector<Vec2>;

Square square(double x, double y, double side) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

/// Squares in squares, some of which share corners, edges or all of their outline.
void fill(Rng& rng, double x, double y, double side, int depth, std::vector<Square>& squares) {
  squares.push_back(square(x, y, side));
  if (rng.below(2) == 0) std::reverse(squares.back().begin(), squares.back().end());
  if (depth == 0) return;
  const double quarter = side / 4;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      if (rng.below(3) == 0)
        fill(rng, x + i * quarter, y + j * quarter, quarter, depth - 1, squares);
}

double area_of(const Walk& walk, const LineWork& lines) {
  std::vector<Vec2> polygon;
  for (const Index p : walk.points) polygon.push_back(lines.points[p]);
  return signed_area(polygon);
}

}  // namespace

TEST_CASE("loops are nested as brute force finds") {
  Rng rng(5);
  for (int round = 0; round < 30; ++round) {
    std::vector<Square> squares;
    fill(rng, 0, 0, 64, 2, squares);
    fill(rng, 64, 0, 64, 2, squares);
    for (std::size_t i = squares.size(); i > 1; --i)
      std::swap(squares[i - 1], squares[rng.below(i)]);
    std::vector<Vec2> probes;
    for (int i = 0; i < 100; ++i)
      probes.push_back({0.37 + 0.5 * static_cast<double>(rng.below(300)),
                        0.21 + 0.5 * static_cast<double>(rng.below(160))});
    const LoopTree tree = nest_loops(squares, probes);
    const auto smallest_around = [&](Vec2 p, double larger_than) {
      Index found = none;
      for (std::size_t j = 0; j < squares.size(); ++j) {
        const double area = std::abs(signed_area(squares[j]));
        if (area <= larger_than || locate(p, squares[j]) != Side::inside) continue;
        if (found == none || area < std::abs(signed_area(squares[found])))
          found = static_cast<Index>(j);
      }
      return found;
    };
    for (std::size_t i = 0; i < squares.size(); ++i) {
      const Vec2 inside = midpoint(midpoint(squares[i][0], squares[i][2]), squares[i][0]);
      CHECK(tree.parent[i] == smallest_around(inside, std::abs(signed_area(squares[i]))));
    }
    for (std::size_t i = 0; i < probes.size(); ++i)
      CHECK(tree.around[i] == smallest_around(probes[i], 0));
  }
}

TEST_CASE("deep nesting takes no longer than many loops") {
  std::vector<Square> squares;
  const int n = 20'000;
  for (int i = 0; i < n; ++i) squares.push_back(square(i, i, 2.0 * (n - i)));
  const LoopTree tree = nest_loops(squares);
  for (int i = 0; i < n; ++i) CHECK_FALSE(tree.parent[i] != i - 1);
}

TEST_CASE("of two equal loops the first is the outer one") {
  const std::vector<Square> twice{square(0, 0, 1), square(0, 0, 1)};
  CHECK(nest_loops(twice).parent == std::vector<Index>{none, 0});
}

TEST_CASE("a divided square has neighbouring faces, bridges and spikes are chains") {
  LineWork lines;
  lines.add(square(0, 0, 4), true, 0);
  lines.add(std::vector<Vec2>{{4, 0}, {2, 3}, {0, 4}}, false, 0);         // divides
  lines.add(square(0.5, 0.5, 0.5), true, 0);                              // apart from the rest
  lines.add(std::vector<Vec2>{{0, 0}, {0.5, 0.5}}, false, 0);             // a bridge
  lines.add(std::vector<Vec2>{{3.5, 3.75}, {3, 3}, {3, 3.5}}, false, 0);  // loose
  lines.add(std::vector<Vec2>{{4, 4}, {5, 5}}, false, 0);                 // a spike
  join_points(lines, 0);
  const PlanarFaces planar = find_faces(lines);
  REQUIRE(planar.faces.size() == 3);
  REQUIRE(planar.outers.size() == 2);
  REQUIRE(planar.chains.size() == 3);
  double faces = 0, outers = 0;
  for (const Walk& walk : planar.faces) faces += area_of(walk, lines);
  for (const Walk& walk : planar.outers) outers += area_of(walk, lines);
  CHECK(faces == 16.25);
  CHECK(outers == -faces);
  CHECK(planar.chains[1].points.size() == 3);
}

TEST_CASE("ends within the tolerance meet, short edges and closed outlines stay") {
  const double tolerance = 1e-3;
  LineWork lines;
  lines.add(std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1e-4}, {1, 1}}, false, 0);
  lines.add(std::vector<Vec2>{{1, 1.0005}, {0, 1}, {0.0004, 0.0004}}, false, 1);
  lines.add(square(2, 0, 1e-4), true, 2);
  const Joined joined = join_points(lines, tolerance);
  CHECK(joined.moved == 2);
  CHECK(joined.farthest < tolerance);
  const PlanarFaces planar = find_faces(lines);
  CHECK(planar.chains.empty());
  REQUIRE(planar.faces.size() == 2);
  CHECK(planar.faces[0].points.size() == 5);  // with the edge of 1e-4
  CHECK(planar.faces[1].points.size() == 4);
}

TEST_CASE("lines are divided where others end on them") {
  const auto joined_faces = [](const std::vector<std::vector<Vec2>>& open, double tolerance,
                               Joined& joined) {
    LineWork lines;
    lines.add(square(0, 0, 4), true, 0);
    for (const auto& line : open) lines.add(line, false, 1);
    joined = join_points(lines, tolerance);
    const PlanarFaces planar = find_faces(lines);
    double sum = 0;
    for (const Walk& walk : planar.faces) sum += area_of(walk, lines);
    CHECK(std::abs(sum - 16) < 1e-2);
    return std::pair(planar.faces.size(), planar.chains.size());
  };
  using Counts = std::pair<std::size_t, std::size_t>;
  Joined joined;
  // Two lines from wall to wall, one of them also the end of a third; a fourth ends in the air.
  const std::vector<std::vector<Vec2>> ribs{
      {{1, 0}, {1, 4}}, {{4, 3}, {1, 3}}, {{3, 3}, {3, 4}}, {{2, 0}, {2, 1}}};
  CHECK(joined_faces(ribs, 1e-4, joined) == Counts{4, 1});
  CHECK(joined.landed == 7);
  CHECK(joined.farthest_landed == 0);
  // Two lines that end at one point of a third, from both sides.
  CHECK(joined_faces({{{0, 2}, {4, 2}}, {{2, 0}, {2, 2}}, {{2, 4}, {2, 2}}}, 1e-4, joined) ==
        Counts{4, 0});
  CHECK(joined_faces({{{1, 5e-5}, {1, 3.99995}}}, 1e-4, joined) == Counts{2, 0});
  CHECK(joined.farthest_landed > 4e-5);
  CHECK(joined.landed_at.x == 1);
  CHECK(joined_faces({{{1, 2e-4}, {1, 4}}}, 1e-4, joined) == Counts{1, 1});
  CHECK(joined_faces({{{1, 0}, {1, 4}}}, 0, joined) == Counts{1, 1});
  // What runs along an edge is not taken apart, nor what hangs on its end.
  CHECK(joined_faces({{{1, 0}, {2, 0}, {2, 1}}}, 1e-4, joined).first == 1);
  CHECK(joined.landed == 0);
  CHECK(joined_faces({{{4, 0}, {3.5, 5e-5}}}, 1e-4, joined) == Counts{1, 1});
}

TEST_CASE("a curve drawn twice with rounding is one") {
  LineWork lines;
  std::vector<Vec2> arc, again;
  for (int i = 0; i <= 8; ++i) {
    arc.push_back({i / 8.0, i * (8 - i) / 32.0});
    again.push_back({i / 8.0 + 1e-7, i * (8 - i) / 32.0 - 1e-7});
  }
  lines.add(arc, false, 0);
  lines.add(again, false, 1);
  lines.add(std::vector<Vec2>{{0, 0}, {1, 0}}, false, 2);
  const Joined joined = join_points(lines, 1e-5);
  CHECK(joined.doubled == 8);
  CHECK(find_faces(lines).faces.size() == 1);
}
