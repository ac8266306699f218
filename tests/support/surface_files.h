// Small surface files, written by hand or byte by byte.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>

#include "surface/soup.h"

namespace lpq_test {

/// The bytes of a number in the chosen order, on a machine of either.
template <class Bits>
void append_bits(std::string& out, Bits bits, bool big) {
  for (std::size_t k = 0; k < sizeof bits; ++k) {
    const std::size_t place = big ? sizeof bits - 1 - k : k;
    out += static_cast<char>((std::uint64_t{bits} >> (8 * place)) & 0xff);
  }
}
inline void append_float(std::string& out, double value, bool big = false) {
  const auto number = static_cast<float>(value);
  std::uint32_t bits = 0;
  std::memcpy(&bits, &number, sizeof bits);
  append_bits(out, bits, big);
}
inline void append_double(std::string& out, double value, bool big = false) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  append_bits(out, bits, big);
}

inline std::string binary_stl(const lpq::SurfaceSoup& soup, std::string header = {}) {
  header.resize(80, ' ');
  append_bits(header, static_cast<std::uint32_t>(soup.triangles.size()), false);
  for (const lpq::Tri& t : soup.triangles) {
    for (int k = 0; k < 3; ++k) append_float(header, 0);
    for (const lpq::Index v : t)
      for (const double x : {soup.points[v].x, soup.points[v].y, soup.points[v].z})
        append_float(header, x);
    append_bits(header, std::uint16_t{0}, false);
  }
  return header;
}

inline std::string point_text(lpq::Vec3 p) {
  return std::to_string(p.x) + ' ' + std::to_string(p.y) + ' ' + std::to_string(p.z);
}

inline std::string text_stl(const lpq::SurfaceSoup& soup) {
  std::string out = "solid a box\n";
  for (const lpq::Tri& t : soup.triangles) {
    out += "facet normal 0 0 nan\n outer loop\n";
    for (const lpq::Index v : t) out += "  vertex " + point_text(soup.points[v]) + '\n';
    out += " endloop\nendfacet\n";
  }
  return out + "endsolid a box\n";
}

inline std::string obj_text(const lpq::SurfaceSoup& soup) {
  std::string out = "# a box\n";
  for (const lpq::Vec3 p : soup.points) out += "v " + point_text(p) + '\n';
  for (const lpq::Tri& t : soup.triangles) {
    out += 'f';
    for (const lpq::Index v : t) out += ' ' + std::to_string(v + 1);
    out += '\n';
  }
  return out;
}

}  // namespace lpq_test
