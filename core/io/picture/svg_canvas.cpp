// See svg_canvas.h.
#include "io/picture/svg_canvas.h"

#include <algorithm>

#include "geometry/box.h"
#include "io/escape.h"
#include "io/number.h"

namespace lpq {
namespace {
constexpr double margin = 20, legend_height = 44;  // pixels
}

std::string colour_text(Colour colour) {
  constexpr char hex[] = "0123456789abcdef";
  std::string text = "#";
  for (const int channel : {colour.r, colour.g, colour.b}) {
    text += hex[(channel >> 4) & 15];
    text += hex[channel & 15];
  }
  return text;
}

Colour blend(std::span<const Colour> stops, double t) {
  const double last = static_cast<double>(stops.size() - 1);
  const double at = t > 0 ? std::min(t, 1.0) * last : 0;  // NaN becomes 0
  const auto k = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  const double w = at - static_cast<double>(k);
  const auto mix = [w](int a, int b) { return static_cast<int>(a + w * (b - a) + 0.5); };
  const Colour a = stops[k], b = stops[k + 1];
  return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
}

SvgCanvas::SvgCanvas(std::span<const Vec2> points, std::string_view title, double width)
    : title_(title) {
  const Box box = points.empty() ? Box{} : box_of(points);
  low_ = box.lo;
  const Vec2 extent = box.hi - box.lo;
  const double longest = std::max(extent.x, extent.y);
  scale_ = longest > 0 ? (width - 2 * margin) / longest : 1;
  width_ = extent.x * scale_ + 2 * margin;
  height_ = extent.y * scale_ + 2 * margin;
}

void SvgCanvas::append_point(std::string& out, Vec2 p) const {
  append_fixed(out, (p.x - low_.x) * scale_ + margin, 2);
  out += ' ';
  append_fixed(out, height_ - margin - (p.y - low_.y) * scale_, 2);
}

void SvgCanvas::add_polygon(std::string& path, std::span<const Vec2> polygon) const {
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    path += k == 0 ? 'M' : 'L';
    append_point(path, polygon[k]);
  }
  if (!polygon.empty()) path += "Z\n";
}

void SvgCanvas::add_segment(std::string& path, Vec2 a, Vec2 b) const {
  path += 'M';
  append_point(path, a);
  path += 'L';
  append_point(path, b);
  path += '\n';
}

void SvgCanvas::paint(const std::string& path, std::string_view attributes) {
  if (path.empty()) return;
  body_ += "<path ";
  body_ += attributes;
  body_ += " d=\"";
  body_ += path;
  body_ += "\"/>\n";
}

void SvgCanvas::dot(Vec2 centre, double radius_pixels, std::string_view fill) {
  body_ += "<circle cx=\"";
  append_fixed(body_, (centre.x - low_.x) * scale_ + margin, 2);
  body_ += "\" cy=\"";
  append_fixed(body_, height_ - margin - (centre.y - low_.y) * scale_, 2);
  body_ += "\" r=\"";
  append_fixed(body_, radius_pixels, 2);
  body_ += "\" fill=\"";
  body_ += fill;
  body_ += "\"/>\n";
}

void SvgCanvas::legend(std::span<const Colour> stops, std::string_view low, std::string_view high) {
  constexpr int steps = 20;
  constexpr double step = 8, indent = 90;
  const double top = height_ + foot_ + 8;
  const auto label = [&](double x, std::string_view text, bool before) {
    body_ += "<text x=\"";
    append_fixed(body_, x, 2);
    body_ += "\" y=\"";
    append_fixed(body_, top + 14, 2);
    body_ += before ? "\" text-anchor=\"end\">" : "\">";
    append_xml(body_, text);
    body_ += "</text>\n";
  };
  label(margin + indent - 8, low, true);
  for (int k = 0; k < steps; ++k) {
    body_ += "<rect x=\"";
    append_fixed(body_, margin + indent + k * step, 2);
    body_ += "\" y=\"";
    append_fixed(body_, top, 2);
    body_ += "\" width=\"8.5\" height=\"18\" fill=\"";
    body_ += colour_text(blend(stops, (k + 0.5) / steps));
    body_ += "\"/>\n";
  }
  label(margin + indent + steps * step + 8, high, false);
  foot_ += legend_height;
}

std::string SvgCanvas::finish() {
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 ";
  append_fixed(out, std::max(width_, 340.0), 2);
  out += ' ';
  append_fixed(out, height_ + foot_, 2);
  out += "\" font-family=\"sans-serif\" font-size=\"14\" fill=\"#333\">\n<title>";
  append_xml(out, title_);
  out += "</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#fdfdfb\"/>\n";
  out += body_;
  out += "</svg>\n";
  body_.clear();
  return out;
}

}  // namespace lpq
