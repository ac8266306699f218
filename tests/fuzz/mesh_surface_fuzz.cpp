// Small soups from bytes, meshed from end to end: an error in a sentence, or a mesh that passes the
// final check. Byte 0: scale and shape of the coordinates; byte 1: mesh size; byte 2: options; byte
// 3: number of points; then points (three bytes each) and triangles (three bytes each).
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "shell/check.h"
#include "shell/mesh_surface.h"

namespace {

using namespace lpq;

void require(bool condition, const char* what) {
  if (condition) return;
  std::fprintf(stderr, "surface mesher: %s\n", what);
  std::abort();
}

class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}
  std::size_t left() const { return left_; }
  unsigned next() {
    if (left_ == 0) return 0;
    --left_;
    return *data_++;
  }

 private:
  const std::uint8_t* data_;
  std::size_t left_;
};

constexpr double scales[] = {1, 1e-9, 1e9, 1e-3, 1e100, 1e-150, 1e6, 1e90};

/// On a coarse lattice points often coincide and lie on lines; the last value is not a number.
double coordinate(unsigned byte, unsigned shape, double scale) {
  if (byte == 255 && (shape & 16)) return std::numeric_limits<double>::quiet_NaN();
  const double x = (shape & 8) ? byte % 4 : byte / 16.0;
  return scale * ((shape & 32) ? x + 1e6 : x);
}

SurfaceSoup soup_from(Bytes& bytes, unsigned shape) {
  const double scale = scales[shape % 8];
  SurfaceSoup soup;
  const unsigned points = 3 + bytes.next() % 22;
  for (unsigned i = 0; i < points; ++i) {
    const double x = coordinate(bytes.next(), shape, scale);
    const double y = coordinate(bytes.next(), shape, scale);
    const double z = coordinate(bytes.next(), shape, (shape & 64) ? 1e-7 * scale : scale);
    soup.points.push_back({x, y, z});
  }
  constexpr std::size_t most_triangles = 40;
  while (bytes.left() >= 3 && soup.triangles.size() < most_triangles) {
    Tri t;
    for (Index& v : t) v = static_cast<Index>(bytes.next() % points);
    soup.triangles.push_back(t);
    soup.group.push_back((shape & 128) ? static_cast<Index>(soup.triangles.size() % 3) : 0);
  }
  soup.group_names = {"a", "b", "c"};
  return soup;
}

double area_of(const SurfaceSoup& soup) {
  double area = 0;
  for (const auto& [a, b, c] : soup.triangles)
    area += 0.5 * length(cross(soup.points[b] - soup.points[a], soup.points[c] - soup.points[a]));
  return area;
}

void judge(const ShellOutcome& outcome) {
  require(check_shell(outcome.surface, outcome.mesh).empty(), "a mesh that fails the check");
  require(!outcome.mesh.faces.empty(), "a mesh without faces");
  for (const Face& face : outcome.mesh.faces) require(face[3] != none, "a triangle");
  for (const SurfacePlace& place : outcome.mesh.places)
    require(place.triangle >= 0 && place.triangle < outcome.surface.triangle_count(),
            "a vertex off the surface");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, size);
  const unsigned shape = bytes.next(), fineness = bytes.next(), flags = bytes.next();
  const SurfaceSoup soup = soup_from(bytes, shape);
  SurfaceOptions options;
  const double quads = 1 + fineness % 64;
  options.size = std::sqrt(area_of(soup) / quads);
  if (!(options.size > 0 && options.size < 1e300)) options.size = 0;
  options.feature_angle = (flags & 1) ? 180 : 40;
  options.turn = (flags & 2) ? 45 : 0;
  options.weld = (flags & 4) ? 0 : 1e-10;
  options.max_elements = 5000;
  const auto outcome = mesh_surface(soup, options);
  if (outcome)
    judge(*outcome);
  else
    require(!outcome.error().message.empty(), "an error without a sentence");
  return 0;
}
