// Domain readers against files that are cut, damaged or absurd, and on files of other programs.
#include <filesystem>

#include "base/rng.h"
#include "catch.h"
#include "support/domain_data.h"
#include "support/domain_files.h"

using namespace lpq;
using namespace lpq_test;

namespace {

void require_sound(const Result<DomainFile>& file) {
  if (file) {
    REQUIRE(is_well_formed(file->domain));
  } else {
    REQUIRE_FALSE(file.error().message.empty());
  }
}

/// A file of the shared data, "" with a warning where there is none.
std::string shared_file(const std::string& name) {
  const auto path = std::filesystem::path(LPQ_SHARED_DATA) / "data" / "formats" / name;
  const std::string text = read_text(path);
  if (text.empty()) WARN("SKIPPED: nothing tested here because " << path << " is absent");
  return text;
}

struct Found {
  std::size_t regions = 0, loops = 0;
  bool judged_good = false;
};

/// What the reader makes of a shared file, judged at the door.
Found found_in(const std::string& name) {
  const auto file = read_domain_file(name, shared_file(name));
  INFO(name << ": " << (file ? std::string() : file.error().message));
  REQUIRE(file.has_value());
  Found found;
  found.regions = file->domain.regions.size();
  for (const auto& region : file->domain.regions) found.loops += region.loops.size();
  found.judged_good = make_domain(file->domain).has_value();
  return found;
}

Error refused_in(const std::string& name) {
  const auto file = read_domain_file(name, shared_file(name));
  INFO(name);
  REQUIRE_FALSE(file.has_value());
  return file.error();
}

}  // namespace

TEST_CASE("a domain file cut anywhere is refused or sound") {
  for (const auto& [format, text] : sample_domain_files()) {
    for (std::size_t length = 0; length < text.size(); ++length) {
      INFO(static_cast<int>(format) << " cut at " << length);
      const auto cut = read_domain(std::string_view(text).substr(0, length), format);
      require_sound(cut);
      // Where the last number may lose its last digit, and line ends may go, a cut can go unseen.
      const bool ends_itself = format != DomainFormat::poly;
      if (ends_itself && length + 1 < text.size() && format != DomainFormat::dxf)
        REQUIRE_FALSE(cut.has_value());
      if (!cut) REQUIRE(cut.error().code != ErrorCode::io_error);
    }
  }
}

TEST_CASE("random damage of domain files never makes an unsound domain") {
  Rng rng(3);
  for (const auto& [format, text] : sample_domain_files()) {
    for (int round = 0; round < 2000; ++round) {
      std::string damaged = text;
      for (std::uint64_t k = 1 + rng.below(3); k > 0; --k) {
        const std::size_t at = rng.below(damaged.size());
        constexpr std::string_view pieces = "0123456789-+.eE $\"'\n<>/[]{},MLAZz#&\xFF\xEF";
        switch (rng.below(4)) {
          case 0: damaged[at] = static_cast<char>(damaged[at] ^ (1 << rng.below(8))); break;
          case 1: damaged.erase(at, 1 + rng.below(4)); break;
          case 2: damaged.insert(at, damaged.substr(rng.below(damaged.size()), 8)); break;
          default: damaged[at] = pieces[rng.below(pieces.size())];
        }
        if (damaged.empty()) break;
      }
      const auto file = read_domain(damaged, format);
      require_sound(file);
      if (file) (void)make_domain(file->domain);
    }
  }
}

TEST_CASE("long lines, long names and many small things") {
  const std::string million(1'000'000, 'x');
  for (const auto& [format, text] : sample_domain_files()) {
    require_sound(read_domain(million, format));
    require_sound(read_domain(text + million, format));
    require_sound(read_domain(std::string(1'000'000, '0'), format));
    require_sound(read_domain(std::string(1'000'000, '\n'), format));
    require_sound(read_domain(std::string(100'000, '<'), format));
  }
  // A long layer name is kept once per edge, so it is cut; between characters.
  std::string name = "\xC3\xA4";
  for (int i = 0; i < 14; ++i) name += name;
  const auto named =
      lpq_test::read_file(dxf("0 CIRCLE 8 x" + name + " 10 0 20 0 40 1"), DomainFormat::dxf);
  CHECK(named.domain.regions[0].name.size() == 127);
  std::string path = "<path d='M0 0";
  for (int i = 0; i < 200'000; ++i) path += "h1v1";
  const auto stairs = lpq_test::read_file(svg(path + "h1V-1z'/>"), DomainFormat::svg);
  CHECK(stairs.domain.regions[0].loops[0].size() == 400'003);
  std::string circles;
  for (int i = 0; i < 20'000; ++i) circles += "<circle r='9'/>";
  CHECK(refusal(svg(circles), DomainFormat::svg).code == ErrorCode::too_large);
  std::string rects;
  for (int i = 0; i < 20'000; ++i)
    rects.append("<rect x='").append(std::to_string(2 * i)).append("' width='1' height='1'/>");
  CHECK(lpq_test::read_file(svg(rects), DomainFormat::svg).domain.regions.size() == 20'000);
}

TEST_CASE("files of other programs: those that have closed outlines become domains") {
  if (shared_file("wrench.dxf").empty()) return;
  struct Expected {
    const char* name;
    std::size_t regions, loops;
  };
  // From looking at each of them: wrench: outline and jaw; tray: plate, slot and 22 round holes;
  // MIL: plate with a slotted and a round hole and eight windows, drawn as loose pieces, the
  // corners twice; A: the letter; face: mouth and eyes are holes; la: a vertical cut through
  // layers.
  for (const Expected& e : {Expected{"wrench.dxf", 1, 2},
                            {"1002_tray_bottom.DXF", 1, 24},
                            {"polygon.svg", 1, 1},
                            {"A.poly", 1, 2},
                            {"face.poly", 1, 4},
                            {"hybrid_part.msh", 1, 1},
                            {"unstructured_quad.v22.msh", 1, 1}}) {
    const Found found = found_in(e.name);
    INFO(e.name);
    CHECK(found.regions == e.regions);
    CHECK(found.loops == e.loops);
    CHECK(found.judged_good);
  }
  for (const char* name : {"MIL.svg", "la.poly", "partitions.msh"}) {
    INFO(name);
    CHECK(found_in(name).judged_good);
  }
  const auto face = read_domain_file("face.poly", shared_file("face.poly"));
  CHECK(face->domain.polylines.size() == 2);  // nostrils
  CHECK(face->domain.points.size() == 2);     // dimples
  const auto plate = read_domain_file("MIL.svg", shared_file("MIL.svg"));
  CHECK(plate->domain.regions.size() == 1);
  CHECK(plate->warnings.size() == 2);  // points joined, edges drawn twice
}

TEST_CASE("files of other programs: the others are refused for what they are") {
  if (shared_file("broken_loop.dxf").empty()) return;
  const Error broken = refused_in("broken_loop.dxf");  // ends at (1, 0) and (1.1, 0)
  CHECK(broken.code == ErrorCode::parse_error);
  REQUIRE(broken.where.has_point);
  CHECK(std::abs(broken.where.x - 1.05) < 0.051);
  CHECK(broken.where.y == 0);
  CHECK(refused_in("text.dxf").code == ErrorCode::empty);
  CHECK(refused_in("box.poly").code == ErrorCode::empty);  // its outline is the convex hull
  for (const char* name : {"surfaces_in_3d.asc.v22.msh", "surfaces_in_3d.asc.v41.msh",
                           "surfaces_in_3d.bin.v40.msh", "t1.geo", "t4.geo", "bbox.1.node"})
    CHECK(refused_in(name).code == ErrorCode::parse_error);
}
