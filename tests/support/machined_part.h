// A machined part with hundreds of faces, as a CAD system would triangulate it: a plate with
// grooves round its sides, and a feature in every cell of a grid. Nothing is cut with anything:
// every cell is a stack of rings with as many points as the cell's border has.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "surface/soup.h"

namespace lpq_test {

class MachinedPart {
 public:
  /// Cells of side 1, `per_side` segments along each side: a multiple of 4. Faces are groups, as in
  /// a B-rep: walls of pockets change from planes to cylinders, and fillets are faces too.
  static lpq::SurfaceSoup make(int columns, int rows, int per_side) {
    MachinedPart part(columns, rows, per_side);
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column) part.add_cell(column, row);
    part.add_sides();
    return std::move(part.soup_);
  }

 private:
  using Ring = std::vector<lpq::Vec3>;
  /// Points core + r * out, counted from the direction (-1, -1); piece: plane or cylinder of a
  /// wall.
  struct Outline {
    std::vector<lpq::Vec2> core, out;
    std::vector<int> piece;
    int pieces = 1;
  };
  struct Step {
    double r, z;
    bool starts = true;  // a face, which ends at the next step that starts one
  };
  struct Cell {
    int column, row;
    bool below;  // seen from there
  };

  static constexpr double pi = 3.14159265358979323846;
  static constexpr double top = 1;  // the bottom is at 0

  MachinedPart(int columns, int rows, int per_side) : n_(per_side), size_{columns, rows} {
    top_ = new_face();
    bottom_ = new_face();
  }

  lpq::Index new_face() {
    soup_.group_names.push_back("face " + std::to_string(soup_.group_names.size() + 1));
    return static_cast<lpq::Index>(soup_.group_names.size()) - 1;
  }

  void triangle(lpq::Vec3 a, lpq::Vec3 b, lpq::Vec3 c, lpq::Index face, bool turned) {
    const auto first = static_cast<lpq::Index>(soup_.points.size());
    for (const lpq::Vec3 p : {a, b, c}) soup_.points.push_back(p);
    soup_.triangles.push_back(turned ? lpq::Tri{first, first + 2, first + 1}
                                     : lpq::Tri{first, first + 1, first + 2});
    soup_.group.push_back(face);
  }

  /// From one ring to the next, to the left of its way.
  template <class FaceOf>
  void strip(const Ring& a, const Ring& b, const FaceOf& face_of, bool turned) {
    for (std::size_t j = 0; j < a.size(); ++j) {
      const std::size_t k = (j + 1) % a.size();
      triangle(a[j], a[k], b[j], face_of(j), turned);
      triangle(a[k], b[k], b[j], face_of(j), turned);
    }
  }

  void fan(const Ring& a, lpq::Vec3 centre, lpq::Index face, bool turned) {
    for (std::size_t j = 0; j < a.size(); ++j)
      triangle(a[j], a[(j + 1) % a.size()], centre, face, turned);
  }

  Outline circle() const {
    Outline outline;
    for (int j = 0; j < 4 * n_; ++j) {
      outline.core.push_back({});
      outline.out.push_back(direction(0.625 + j / (4.0 * n_)));
      outline.piece.push_back(0);
    }
    return outline;
  }

  static lpq::Vec2 direction(double turns) {
    return {std::cos(2 * pi * turns), std::sin(2 * pi * turns)};
  }

  /// All points at the distance r from a rectangle with half sides a and b; b may be 0.
  Outline rounded(double a, double b) const {
    const int arc = n_ / 2, side = b > 0 ? n_ / 2 : n_;
    const lpq::Vec2 corner[] = {{-a, -b}, {a, -b}, {a, b}, {-a, b}};
    Outline outline;
    outline.pieces = b > 0 ? 8 : 4;
    const auto add = [&](lpq::Vec2 core, double turns, int piece) {
      outline.core.push_back(core);
      outline.out.push_back(direction(turns));
      outline.piece.push_back(piece % outline.pieces);
    };
    // The first corner's arc begins in its middle, and ends the ring.
    for (int c = 0; c < 5; ++c) {
      const lpq::Vec2 from = corner[c % 4], to = corner[(c + 1) % 4];
      const int piece = b > 0 ? 2 * c : 2 * ((c + 1) / 2);
      const int begin = c == 0 ? arc / 2 : 0, end = c == 4 ? arc / 2 : arc;
      for (int k = begin; k < end; ++k) add(from, 0.5 + (c + double(k) / arc) / 4, piece);
      if (c == 4 || (b == 0 && c % 2 == 1)) continue;
      for (int k = 0; k < side; ++k)
        add(from + (double(k) / side) * (to - from), 0.5 + (c + 1) / 4.0, piece + 1);
    }
    return outline;
  }

  Ring ring(Cell cell, const Outline& outline, double r, double z) const {
    Ring points;
    for (std::size_t j = 0; j < outline.core.size(); ++j) {
      const lpq::Vec2 p = outline.core[j] + r * outline.out[j];
      points.push_back({cell.column + 0.5 + p.x, cell.row + 0.5 + p.y, z});
    }
    return points;
  }

  Ring square(Cell cell, double z) const {
    Ring points;
    const double x = cell.column, y = cell.row;
    for (int k = 0; k < n_; ++k) points.push_back({x + double(k) / n_, y, z});
    for (int k = 0; k < n_; ++k) points.push_back({x + 1, y + double(k) / n_, z});
    for (int k = 0; k < n_; ++k) points.push_back({x + 1 - double(k) / n_, y + 1, z});
    for (int k = 0; k < n_; ++k) points.push_back({x, y + 1 - double(k) / n_, z});
    return points;
  }

  /// The plane inside a ring.
  void floor(Cell cell, const Ring& border, lpq::Index face) {
    const lpq::Vec3 centre{cell.column + 0.5, cell.row + 0.5, border[0].z};
    Ring inner = border;
    for (lpq::Vec3& p : inner) p = 0.5 * (p + centre);
    strip(
        border, inner, [face](std::size_t) { return face; }, cell.below);
    fan(inner, centre, face, cell.below);
  }

  /// From the cell's border to the last ring, which is returned.
  Ring walls(Cell cell, const Outline& outline, const std::vector<Step>& steps) {
    Ring last = square(cell, cell.below ? 0 : top);
    std::vector<lpq::Index> faces{cell.below ? bottom_ : top_};
    for (std::size_t i = 0; i < steps.size(); ++i) {
      Ring next = ring(cell, outline, steps[i].r, steps[i].z);
      strip(
          last, next, [&](std::size_t j) { return faces[outline.piece[j] % faces.size()]; },
          cell.below);
      if (steps[i].starts) {
        const bool plane = i + 1 == steps.size() || steps[i].z == steps[i + 1].z;
        faces.clear();
        for (int k = 0; k < (plane ? 1 : outline.pieces); ++k) faces.push_back(new_face());
      }
      last = std::move(next);
    }
    open_face_ = faces[0];
    return last;
  }

  void add_cell(int column, int row) {
    const Cell cell{column, row, false}, under{column, row, true};
    switch ((2 * column + 3 * row) % 5) {
      case 0: return add_boss(cell);
      case 1: return add_counterbore(cell);
      case 2: add_tapped_hole(cell); return add_pocket(under);
      case 3: return add_slot(cell);
      default: add_rib(cell); return floor(under, square(under, 0), bottom_);
    }
  }

  void through(Cell cell, const Outline& outline, const std::vector<Step>& steps) {
    const Ring last = walls(cell, outline, steps);
    strip(
        last, square(cell, 0), [this](std::size_t) { return bottom_; }, false);
  }

  void add_boss(Cell cell) {
    std::vector<Step> steps = foot(0.36, 0.06);
    steps.insert(steps.end(), {{0.36, 1.3},
                               {0.32, 1.34},
                               {0.24, 1.34},
                               {0.24, 1.1},
                               {0.14, 1.1},
                               {0.14, 0.04},
                               {0.18, 0, false}});
    through(cell, circle(), steps);
  }
  void add_counterbore(Cell cell) {
    through(cell, circle(),
            {{0.34, 1}, {0.3, 0.96}, {0.3, 0.6}, {0.16, 0.6}, {0.16, 0.04}, {0.2, 0, false}});
  }
  void add_slot(Cell cell) {
    through(cell, rounded(0.2, 0), {{0.19, 1}, {0.15, 0.96}, {0.15, 0.04}, {0.19, 0, false}});
  }
  void add_tapped_hole(Cell cell) {
    const Ring last = walls(cell, circle(), {{0.24, 1}, {0.2, 0.96}, {0.2, 0.6}});
    fan(last, {cell.column + 0.5, cell.row + 0.5, 0.48}, open_face_, false);
  }
  void add_pocket(Cell cell) {
    std::vector<Step> steps{{0.14, 0}, {0.14, 0.2}};
    for (int k = 1; k <= 6; ++k) {
      const lpq::Vec2 d = direction(k / 24.0);
      steps.push_back({0.06 + 0.08 * d.x, 0.2 + 0.08 * d.y, k == 6});
    }
    const Ring last = walls(cell, rounded(0.22, 0.22), steps);
    floor(cell, last, open_face_);
  }
  void add_rib(Cell cell) {
    std::vector<Step> steps = foot(0.1, 0.06);
    steps.insert(steps.end(), {{0.1, 1.4}, {0.06, 1.44}});
    const Ring last = walls(cell, rounded(0.24, 0.06), steps);
    floor(cell, last, open_face_);
  }

  /// A fillet up from the top to a wall at r.
  static std::vector<Step> foot(double r, double radius) {
    std::vector<Step> steps;
    for (int k = 0; k <= 6; ++k) {
      const lpq::Vec2 d = direction(k / 24.0);
      steps.push_back({r + radius * (1 - d.y), top + radius * (1 - d.x), k == 0 || k == 6});
    }
    return steps;
  }

  /// The plate's border, moved inwards.
  Ring border(double inwards, double z) const {
    const double x = size_[0], y = size_[1];
    Ring points;
    const auto add = [&](double u, double v) {
      points.push_back({inwards == 0 ? u : inwards + u * (x - 2 * inwards) / x,
                        inwards == 0 ? v : inwards + v * (y - 2 * inwards) / y, z});
    };
    for (int k = 0; k < n_ * size_[0]; ++k) add(double(k) / n_, 0);
    for (int k = 0; k < n_ * size_[1]; ++k) add(x, double(k) / n_);
    for (int k = 0; k < n_ * size_[0]; ++k) add(x - double(k) / n_, y);
    for (int k = 0; k < n_ * size_[1]; ++k) add(0, y - double(k) / n_);
    return points;
  }

  void add_sides() {
    constexpr Step steps[] = {{0.04, 0.96}, {0.04, 0.8},  {0.12, 0.8}, {0.12, 0.7},
                              {0.04, 0.7},  {0.04, 0.3},  {0.12, 0.3}, {0.12, 0.2},
                              {0.04, 0.2},  {0.04, 0.04}, {0, 0}};
    Ring last = border(0, top);
    for (const auto& [inwards, z, starts] : steps) {
      const bool plane = z == last[0].z;
      const lpq::Index first = new_face();
      for (int i = 1; !plane && i < 4; ++i) new_face();
      Ring next = border(inwards, z);
      strip(
          last, next, [&](std::size_t j) { return plane ? first : first + side_of(j); }, true);
      last = std::move(next);
    }
  }

  lpq::Index side_of(std::size_t j) const {
    lpq::Index side = 0;
    for (auto left = static_cast<int>(j) / n_; left >= size_[side % 2]; ++side)
      left -= size_[side % 2];
    return side;
  }

  int n_;
  int size_[2];
  lpq::Index top_ = 0, bottom_ = 0, open_face_ = 0;
  lpq::SurfaceSoup soup_;
};

}  // namespace lpq_test
