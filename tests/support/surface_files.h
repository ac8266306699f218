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

inline std::string off_text(const lpq::SurfaceSoup& soup) {
  std::string out = "OFF\n" + std::to_string(soup.points.size()) + ' ' +
                    std::to_string(soup.triangles.size()) + " 0\n";
  for (const lpq::Vec3 p : soup.points) out += point_text(p) + '\n';
  for (const lpq::Tri& t : soup.triangles) {
    out += '3';
    for (const lpq::Index v : t) out += ' ' + std::to_string(v);
    out += '\n';
  }
  return out;
}

inline std::string ply_header(const lpq::SurfaceSoup& soup, const std::string& format) {
  return "ply\nformat " + format + " 1.0\ncomment a box\nelement vertex " +
         std::to_string(soup.points.size()) +
         "\nproperty uchar red\nproperty double x\nproperty float y\nproperty double z\n" +
         "element edge 1\nproperty list uchar short ends\nelement face " +
         std::to_string(soup.triangles.size()) +
         "\nproperty list uchar int vertex_indices\nproperty short region\nend_header\n";
}

/// Every triangle in region t % 2.
inline std::string text_ply(const lpq::SurfaceSoup& soup) {
  std::string out = ply_header(soup, "ascii");
  for (const lpq::Vec3 p : soup.points) out += "255 " + point_text(p) + '\n';
  out += "2 0 -1\n";
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    out += '3';
    for (const lpq::Index v : soup.triangles[t]) out += ' ' + std::to_string(v);
    out += ' ' + std::to_string(t % 2) + '\n';
  }
  return out;
}

inline std::string binary_ply(const lpq::SurfaceSoup& soup, bool big) {
  std::string out = ply_header(soup, big ? "binary_big_endian" : "binary_little_endian");
  for (const lpq::Vec3 p : soup.points) {
    out += '\xff';
    append_double(out, p.x, big);
    append_float(out, p.y, big);
    append_double(out, p.z, big);
  }
  out += '\2';
  append_bits(out, std::uint16_t{0}, big);
  append_bits(out, std::uint16_t{0xffff}, big);
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    out += '\3';
    for (const lpq::Index v : soup.triangles[t])
      append_bits(out, static_cast<std::uint32_t>(v), big);
    append_bits(out, static_cast<std::uint16_t>(t % 2), big);
  }
  return out;
}

/// Version 2.2, triangle t with physical tag 1 + t % 2 in entity 7.
inline std::string msh_text(const lpq::SurfaceSoup& soup) {
  std::string out = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n1\n2 1 \"even\"\n" +
                    std::string("$EndPhysicalNames\n$Nodes\n") +
                    std::to_string(soup.points.size()) + '\n';
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    out += std::to_string(v + 1) + ' ' + point_text(soup.points[v]) + '\n';
  out += "$EndNodes\n$Elements\n" + std::to_string(soup.triangles.size() + 1) + "\n1 15 2 0 7 1\n";
  for (std::size_t t = 0; t < soup.triangles.size(); ++t) {
    out += std::to_string(t + 2) + " 2 2 " + std::to_string(1 + t % 2) + " 7";
    for (const lpq::Index v : soup.triangles[t]) out += ' ' + std::to_string(v + 1);
    out += '\n';
  }
  return out + "$EndElements\n";
}

}  // namespace lpq_test
