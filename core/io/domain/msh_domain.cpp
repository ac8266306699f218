// See msh_domain.h.
#include "io/domain/msh_domain.h"

#include <algorithm>
#include <array>

#include "geometry/polygon.h"
#include "io/domain/drawing.h"
#include "io/mesh/msh.h"

namespace lpq {
namespace {

/// A directed edge with a region on its left, by the places of its ends.
struct Side {
  Vec2 a, b;
  Index region = none;
};
bool operator<(const Side& s, const Side& t) { return s.a == t.a ? s.b < t.b : s.a < t.a; }

class MshDomain {
 public:
  explicit MshDomain(MshElements elements) : mesh_(std::move(elements.mesh)) {
    file_.warnings = std::move(elements.warnings);
  }

  Result<DomainFile> make() {
    for (const std::string& tag : mesh_.tags) drawing_.add_source(tag);
    untagged_ = drawing_.add_source({});
    drawing_.lines.points = mesh_.points;
    if (const auto problem = collect_sides()) return *problem;
    add_edges();
    join();
    return finish();
  }

 private:
  Problem collect_sides();
  void add_edges();
  void join();
  Index region_left_of(Vec2 a, Vec2 b) const;
  Index region_of(const Walk& face) const;
  Result<DomainFile> finish();
  void add_points(const NestedFaces& nested, const std::vector<char>& filled);

  OutputMesh mesh_;
  std::vector<Side> sides_;  // of the faces, sorted
  Drawing drawing_;
  Index untagged_ = none;
  DomainFile file_;
};

Problem MshDomain::collect_sides() {
  for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
    const Face& face = mesh_.faces[f];
    const int n = corner_count(face);
    std::array<Vec2, 4> corners;
    for (int k = 0; k < n; ++k) corners[static_cast<std::size_t>(k)] = mesh_.points[face[k]];
    const bool turned = orientation({corners.data(), static_cast<std::size_t>(n)}) < 0;
    for (int k = 0; k < n; ++k) {
      const Vec2 a = corners[static_cast<std::size_t>(k)];
      const Vec2 b = corners[static_cast<std::size_t>(k + 1 == n ? 0 : k + 1)];
      sides_.push_back({turned ? b : a, turned ? a : b, mesh_.region[f]});
    }
  }
  std::stable_sort(sides_.begin(), sides_.end());
  for (std::size_t i = 1; i < sides_.size(); ++i) {
    if (sides_[i - 1] < sides_[i]) continue;
    Error error{
        ErrorCode::parse_error, "Two faces of the mesh lie on the same side of an edge.", {}};
    error.where.set_point(sides_[i].a.x, sides_[i].a.y);
    return error;
  }
  return {};
}

Index MshDomain::region_left_of(Vec2 a, Vec2 b) const {
  const Side key{a, b, none};
  const auto at = std::lower_bound(sides_.begin(), sides_.end(), key);
  return at != sides_.end() && at->a == a && at->b == b ? at->region : none;
}

/// Lines first, so that their tags stay where a side of a face is the same edge.
void MshDomain::add_edges() {
  for (const OutputEdge& edge : mesh_.edges)
    drawing_.lines.edges.push_back({edge.a, edge.b, edge.tag});
  for (std::size_t f = 0; f < mesh_.faces.size(); ++f) {
    const Face& face = mesh_.faces[f];
    for (int k = 0, n = corner_count(face); k < n; ++k) {
      const Index i = face[k], j = face[k + 1 == n ? 0 : k + 1];
      const Vec2 a = mesh_.points[i], b = mesh_.points[j];
      const Index left = region_left_of(a, b), right = region_left_of(b, a);
      const bool first = left == none || right == none || a < b;
      if (left != right && first) drawing_.lines.edges.push_back({i, j, untagged_});
    }
  }
}

/// Lines alone may end beside each other by what rounding makes of two points that are one.
void MshDomain::join() {
  constexpr double rounding = 1e-12;  // of the size
  if (!mesh_.faces.empty()) {
    join_points(drawing_.lines, 0);
    return;
  }
  std::vector<Index> degree(mesh_.points.size(), 0);
  for (const LineWork::Edge& edge : drawing_.lines.edges)
    for (const Index p : {edge.a, edge.b}) ++degree[p];
  for (const Index d : degree) drawing_.lines.loose.push_back(d == 1);
  join_points(drawing_.lines, rounding * drawing_size(drawing_.lines));
}

Index MshDomain::region_of(const Walk& face) const {
  for (std::size_t i = 0; i < face.points.size(); ++i) {
    const Index a = face.points[i], b = face.points[i + 1 == face.points.size() ? 0 : i + 1];
    const Index region = region_left_of(drawing_.lines.points[a], drawing_.lines.points[b]);
    if (region != none) return region;
  }
  return none;
}

Result<DomainFile> MshDomain::finish() {
  std::vector<Vec2> probes;
  for (const OutputPoint& point : mesh_.tagged_points) probes.push_back(mesh_.points[point.point]);
  const NestedFaces nested = nest_faces(drawing_.lines, probes);
  const bool lines_only = mesh_.faces.empty();
  if (lines_only && !nested.planar.chains.empty()) return open_chain_error(drawing_, nested, 0);
  std::vector<char> filled = even_faces(nested);
  std::vector<std::string> names(filled.size());
  for (std::size_t f = 0; f < filled.size() && !lines_only; ++f) {
    const Index region = region_of(nested.planar.faces[f]);
    filled[f] = region != none;
    if (region != none) names[f] = mesh_.regions[static_cast<std::size_t>(region)];
  }
  const Index outside = add_regions(
      drawing_, nested, filled, [&](Index f) { return names[f]; }, file_.domain);
  if (file_.domain.regions.empty())
    return Error{ErrorCode::empty, "The file has no lines that enclose anything and no faces.", {}};
  if (outside > 0)
    file_.warnings.push_back(
        {ErrorCode::ignored,
         "Lines outside all faces were left out: " + std::to_string(outside) + ".",
         {}});
  add_points(nested, filled);
  return std::move(file_);
}

void MshDomain::add_points(const NestedFaces& nested, const std::vector<char>& filled) {
  std::vector<Vec2> ends;
  for (const LineWork::Edge& edge : drawing_.lines.edges)
    for (const Index p : {edge.a, edge.b}) ends.push_back(drawing_.lines.points[p]);
  std::sort(ends.begin(), ends.end());
  Index left_out = 0;
  for (std::size_t i = 0; i < mesh_.tagged_points.size(); ++i) {
    const OutputPoint& tagged = mesh_.tagged_points[i];
    const std::string& tag = mesh_.tags[static_cast<std::size_t>(tagged.tag)];
    if (tag.empty()) continue;  // every point of a Gmsh geometry has an element
    const Vec2 p = mesh_.points[tagged.point];
    const Index face = nested.around_probe(i);
    if (face == none || !filled[face] || std::binary_search(ends.begin(), ends.end(), p)) {
      ++left_out;
    } else {
      file_.domain.points.push_back({p, tag});
    }
  }
  if (left_out > 0)
    file_.warnings.push_back({ErrorCode::ignored,
                              "Names of points that are not strictly inside were left out: " +
                                  std::to_string(left_out) + ".",
                              {}});
}

}  // namespace

Result<DomainFile> read_msh_domain(std::string_view text) {
  auto elements = read_msh_elements(text);
  if (!elements) return elements.error();
  return MshDomain(*std::move(elements)).make();
}

}  // namespace lpq
