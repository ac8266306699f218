// DXF blocks: the maps of INSERT against coordinates worked out by hand, layers, limits.
#include "io/domain/dxf_blocks.h"

#include "catch.h"
#include "io/domain/dxf_domain.h"
#include "numerics/elementary.h"
#include "support/domain_files.h"

using namespace lpq;
using namespace lpq_test;

namespace {

DomainFile read_blocks(const std::string& blocks, const std::string& entities) {
  return lpq_test::read_file(dxf(entities, dxf_blocks(blocks)), DomainFormat::dxf);
}

/// Of a loop that is the same all round.
Vec2 middle_of(const Loop& loop) {
  Vec2 sum;
  for (const Vec2 p : loop) sum = sum + p;
  return (1 / static_cast<double>(loop.size())) * sum;
}

/// The corners of the first loop of the first region, from the least on.
std::vector<Vec2> corners(const DomainFile& file) {
  std::vector<Vec2> points = file.domain.regions.at(0).loops.at(0);
  std::sort(points.begin(), points.end());
  return points;
}

const std::string plate = "0 LWPOLYLINE 70 1 10 0 20 0 10 10 20 0 10 10 20 5 10 0 20 5 ";
const std::string disc = "0 BLOCK 2 Disc 10 1 20 1 0 CIRCLE 8 0 10 1 20 1 40 0.5 0 ENDBLK";
/// A triangle without symmetry, (0, 0) (2, 0) (0, 1), with (1, 0) as base point.
const std::string wedge =
    "0 BLOCK 2 wedge 10 1 20 0 0 LWPOLYLINE 8 0 70 1 10 0 20 0 10 2 20 0 10 0 20 1 0 ENDBLK";

void check_corners(const std::string& insert, std::vector<Vec2> expected) {
  INFO(insert);
  std::sort(expected.begin(), expected.end());
  const std::vector<Vec2> found = corners(read_blocks(wedge, "0 INSERT 2 wedge " + insert));
  REQUIRE(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) CHECK(distance(found[i], expected[i]) < 1e-12);
}

}  // namespace

TEST_CASE("an INSERT scales about the base point, turns and moves") {
  check_corners("10 5 20 6", {{4, 6}, {6, 6}, {4, 7}});
  check_corners("10 5 20 6 41 2 42 3", {{3, 6}, {7, 6}, {3, 9}});
  check_corners("10 5 20 6 41 -1", {{6, 6}, {4, 6}, {6, 7}});
  check_corners("10 5 20 6 42 -1", {{4, 6}, {6, 6}, {4, 5}});
  check_corners("10 5 20 6 50 90", {{5, 5}, {5, 7}, {4, 5}});
  check_corners("10 5 20 6 41 2 50 -90", {{5, 8}, {5, 4}, {6, 8}});
  // Seen from below, x points the other way, after everything else.
  check_corners("10 5 20 6 230 -1", {{-4, 6}, {-6, 6}, {-4, 7}});
  check_corners("10 5 20 6 50 90 230 -1", {{-5, 5}, {-5, 7}, {-4, 5}});
  const double h = std::sqrt(0.5);
  check_corners("10 0 20 0 50 45", {{-h, -h}, {h, h}, {-2 * h, 0}});
}

TEST_CASE("rows and columns are turned and not scaled") {
  const auto file = read_blocks(
      disc, plate + "0 INSERT 2 DISC 10 2 20 1 41 0.5 42 0.5 50 90 70 3 71 2 44 1.5 45 -4");
  const auto& loops = file.domain.regions.at(0).loops;
  REQUIRE(loops.size() == 7);
  CHECK(file.warnings.empty());
  std::vector<Vec2> centres;
  for (std::size_t l = 1; l < loops.size(); ++l) centres.push_back(middle_of(loops[l]));
  std::sort(centres.begin(), centres.end());
  const std::vector<Vec2> expected{{2, 1}, {2, 2.5}, {2, 4}, {6, 1}, {6, 2.5}, {6, 4}};
  for (std::size_t i = 0; i < 6; ++i) CHECK(distance(centres[i], expected[i]) < 1e-12);
  CHECK(std::abs(loop_area(loops[1]) - pi / 16) < 0.01);
}

TEST_CASE("arcs, bulges and splines of scaled blocks are what they then are") {
  const auto area = [](const std::string& curve, const std::string& insert) {
    const auto file =
        read_blocks("0 BLOCK 2 b 10 0 20 0 " + curve + " 0 ENDBLK", "0 INSERT 2 b " + insert);
    return total_area(file.domain);
  };
  const std::string wide = "10 7 20 7 41 3 42 -2 50 30";  // area by 6
  CHECK(std::abs(area("0 CIRCLE 10 1 20 0 40 1", wide) - 6 * pi) < 0.02);
  CHECK(std::abs(area("0 ARC 10 0 20 0 40 1 50 0 51 180 0 LINE 10 -1 20 0 11 1 21 0", wide) -
                 3 * pi) < 0.01);
  CHECK(std::abs(area("0 LWPOLYLINE 70 1 10 0 20 0 42 1 10 2 20 0", wide) - 3 * pi) < 0.01);
  CHECK(std::abs(area("0 ELLIPSE 10 1 20 1 11 0 21 3 40 0.5", wide) - 27 * pi) < 0.1);
  CHECK(std::abs(area("0 SPLINE 70 0 71 3 40 0 40 0 40 0 40 0 40 1 40 1 40 1 40 1 10 0 20 0 "
                      "10 0 20 1 10 1 20 1 10 1 20 0 0 LINE 10 1 20 0 11 0 21 0",
                      wide) -
                 3.6) < 0.01);
  // As fine as the size at which they are drawn asks for, not as their own.
  const auto small = read_blocks(disc, plate + "0 INSERT 2 disc 10 5 20 2.5 41 0.2 42 0.2");
  const auto large = read_blocks(disc, plate + "0 INSERT 2 disc 10 5 20 2.5 41 4 42 4");
  CHECK(small.domain.regions[0].loops[1].size() < large.domain.regions[0].loops[1].size());
}

TEST_CASE("blocks hold blocks, and layer 0 is the layer of the INSERT") {
  const std::string pair =
      disc +
      " 0 BLOCK 2 pair 10 0 20 0 0 INSERT 8 0 2 disc 10 0 20 0 "
      "0 INSERT 8 slot 2 disc 10 2 20 0 41 2 0 CIRCLE 8 own 10 5 20 0 40 0.5 0 ENDBLK";
  const auto file = read_blocks(pair, plate + "0 INSERT 8 bolt 2 pair 10 2 20 2.5");
  const auto& region = file.domain.regions.at(0);
  REQUIRE(region.loops.size() == 4);
  std::vector<std::string> tags;
  for (std::size_t l = 1; l < 4; ++l) tags.push_back(region.tags[l].at(0));
  CHECK(tags == std::vector<std::string>{"bolt", "slot", "own"});
  CHECK(distance(middle_of(region.loops[2]), {4, 2.5}) < 1e-12);
  // Lines of a block are joined with lines around it.
  const auto side = read_blocks("0 BLOCK 2 s 0 LINE 10 0 20 0 11 0 21 5 0 ENDBLK",
                                "0 INSERT 2 s 10 0 20 0 0 INSERT 2 s 10 4 20 0 "
                                "0 LINE 10 0 20 0 11 4 21 0 0 LINE 10 0 20 5 11 4 21 5");
  CHECK(total_area(side.domain) == 20);
}

TEST_CASE("what is invisible, off or frozen is left out with a word") {
  const std::string layers =
      "0 SECTION 2 TABLES 0 TABLE 2 LAYER 0 LAYER 2 Ice 70 1 62 7 0 LAYER 2 dark 70 0 62 -7 "
      "0 LAYER 2 seen 70 4 62 3 0 ENDTAB 0 ENDSEC ";
  const auto holes = [&](const std::string& entities) {
    const auto file = lpq_test::read_file(
        dxf(plate + entities,
            layers + dxf_blocks(disc + " 0 BLOCK 2 both 10 0 20 0 0 CIRCLE 8 0 10 0 20 0 40 0.5 "
                                       "0 CIRCLE 8 seen 10 2 20 0 40 0.5 0 ENDBLK")),
        DomainFormat::dxf);
    const bool told = !file.warnings.empty() &&
                      file.warnings[0].message.find("off or frozen: ") != std::string::npos;
    return std::pair(file.domain.regions.at(0).loops.size() - 1, told);
  };
  using Holes = std::pair<std::size_t, bool>;
  CHECK(holes("0 CIRCLE 8 seen 10 2 20 2 40 1") == Holes{1, false});
  CHECK(holes("0 CIRCLE 8 ice 10 2 20 2 40 1") == Holes{0, true});
  CHECK(holes("0 CIRCLE 8 dark 10 2 20 2 40 1") == Holes{0, true});
  CHECK(holes("0 CIRCLE 60 1 10 2 20 2 40 1") == Holes{0, true});
  CHECK(holes("0 CIRCLE 60 0 10 2 20 2 40 1") == Holes{1, false});
  CHECK(holes("0 INSERT 8 ice 2 both 10 2 20 2") == Holes{0, true});
  CHECK(holes("0 INSERT 8 dark 2 both 10 2 20 2") == Holes{1, true});
  CHECK(holes("0 INSERT 60 1 2 both 10 2 20 2") == Holes{0, true});
  const Error error = refusal(
      dxf("0 CIRCLE 8 ice 10 2 20 2 40 1", layers.substr(0, layers.size() - 1)), DomainFormat::dxf);
  CHECK(error.code == ErrorCode::empty);
  CHECK(error.message.find("1 CIRCLE") != std::string::npos);
}

TEST_CASE("blocks that cannot be drawn are counted or refused with their place") {
  const auto file = read_blocks(
      disc +
          " 0 BLOCK 2 *X1 10 0 20 0 0 LINE 10 1 20 1 11 2 21 2 0 ENDBLK 0 BLOCK 2 out 70 4 "
          "0 ENDBLK 0 BLOCK 2 wrong 0 CIRCLE 10 0 20 0 40 -1 0 ENDBLK",
      plate + "0 INSERT 2 none 10 0 20 0 0 INSERT 2 *x1 10 0 20 0 0 INSERT 2 out 10 0 20 0");
  REQUIRE(file.warnings.size() == 1);  // and the wrong circle harms nobody
  CHECK(file.warnings[0].message ==
        "Left out: 1 INSERT without its block, 1 INSERT of a hatch and 1 INSERT of another file.");
  const auto refused = [](const std::string& blocks, const std::string& entities) {
    const Error error = refusal(dxf(plate + entities, dxf_blocks(blocks)), DomainFormat::dxf);
    CHECK(error.where.line > 0);
    return error;
  };
  CHECK(refused("0 BLOCK 2 b 0 CIRCLE 10 0 20 0 40 -1 0 ENDBLK", "0 INSERT 2 b 10 0 20 0").code ==
        ErrorCode::parse_error);
  CHECK(refused(disc, "0 INSERT 2 disc 10 0 20 0 41 0").message.find("scale of 0") !=
        std::string::npos);
  CHECK(refused(disc, "0 INSERT 2 disc 20 0").code == ErrorCode::parse_error);
  CHECK(refused("0 BLOCK 2 a 0 INSERT 2 b 10 0 20 0 0 ENDBLK 0 BLOCK 2 b 0 INSERT 2 a 10 0 20 0 "
                "0 ENDBLK",
                "0 INSERT 2 a 10 0 20 0")
            .message.find("contains itself") != std::string::npos);
}

TEST_CASE("copies of blocks of many points are refused before they are made") {
  std::string wave = "0 BLOCK 2 wave 10 0 20 0 0 LWPOLYLINE 70 1";
  for (int i = 0; i < 20'000; ++i)
    wave += " 10 " + std::to_string(i) + " 20 " + std::to_string(i % 2);
  wave += " 10 20000 20 20000 0 ENDBLK";
  const auto copies = [&](const std::string& insert) {
    return dxf(plate + "0 INSERT 2 wave 10 0 20 0 " + insert, dxf_blocks(wave));
  };
  const Error error = refusal(copies("70 512 71 512 44 30000 45 30000"), DomainFormat::dxf);
  CHECK(error.code == ErrorCode::too_large);
  CHECK(error.where.line == 14);  // of the polyline
  CHECK(error.message.find("more than a million corners") != std::string::npos);
}

TEST_CASE("blocks that multiply are refused, not unfolded") {
  const auto level = [](int i, int copies) {
    std::string block = "0 BLOCK 2 b" + std::to_string(i);
    for (int c = 0; c < copies; ++c)
      block += " 0 INSERT 2 b" + std::to_string(i + 1) + " 10 0 20 0";
    return block + " 0 ENDBLK ";
  };
  const auto tower = [&](int height, int copies) {
    std::string blocks;
    for (int i = 0; i < height; ++i) blocks += level(i, copies);
    blocks += "0 BLOCK 2 b" + std::to_string(height) + " 0 CIRCLE 10 5 20 2 40 1 0 ENDBLK";
    return dxf(plate + "0 INSERT 2 b0 10 0 20 0", dxf_blocks(blocks));
  };
  CHECK(read_domain(tower(deepest_block - 1, 1), DomainFormat::dxf).has_value());
  CHECK(refusal(tower(deepest_block, 1), DomainFormat::dxf).code == ErrorCode::too_large);
  CHECK(refusal(tower(20, 2), DomainFormat::dxf).code == ErrorCode::too_large);
  CHECK(refusal(
            dxf(plate + "0 INSERT 2 disc 10 0 20 0 70 32767 71 32767 44 1 45 1", dxf_blocks(disc)),
            DomainFormat::dxf)
            .code == ErrorCode::too_large);
}
