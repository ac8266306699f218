// The page under every picture: world coordinates to pixels, colours in bins so that a picture of
// 100 000 cells has a few dozen paths, and the frame of the SVG file.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/vec.h"

namespace lpq {

struct Colour {
  int r = 0, g = 0, b = 0;
};

/// "#rrggbb"
std::string colour_text(Colour colour);
/// Piecewise linear colour map on [0, 1]; t is clamped.
Colour blend(std::span<const Colour> stops, double t);

class SvgCanvas {
 public:
  /// Fits the points into a page `width` pixels wide (or high, for tall ones).
  SvgCanvas(std::span<const Vec2> points, std::string_view title, double width = 1000);

  /// Pixels per unit of length.
  double scale() const { return scale_; }

  /// Polygons and polylines collect in `path`; paint() puts them on the page as one path element.
  void add_polygon(std::string& path, std::span<const Vec2> polygon) const;
  void add_segment(std::string& path, Vec2 a, Vec2 b) const;
  void paint(const std::string& path, std::string_view attributes);
  void dot(Vec2 centre, double radius_pixels, std::string_view fill);

  /// A row of colours under the picture with what its ends mean.
  void legend(std::span<const Colour> stops, std::string_view low, std::string_view high);

  /// The finished file; the canvas is empty afterwards.
  std::string finish();

 private:
  void append_point(std::string& out, Vec2 p) const;

  std::string title_, body_;
  Vec2 low_;
  double scale_ = 1, width_ = 0, height_ = 0, foot_ = 0;
};

}  // namespace lpq
