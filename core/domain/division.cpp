#include "domain/division.h"

#include "base/sort_numbers.h"

namespace lpq {

std::vector<Index> boundary_counts(std::span<const Segment> segments, Index region_count,
                                   std::span<const Index> pieces) {
  std::vector<Index> counts(region_count, 0);
  for (std::size_t s = 0; s < segments.size(); ++s) {
    if (segments[s].left == segments[s].right) continue;
    if (segments[s].left != none) counts[segments[s].left] += pieces[s];
    if (segments[s].right != none) counts[segments[s].right] += pieces[s];
  }
  return counts;
}

namespace {

/// Breadth-first from the outside over common borders: for every region the best segment towards
/// the outside, and the order in which regions were reached.
struct BorderTree {
  std::vector<Index> order;    // regions, nearest to the outside first
  std::vector<Index> segment;  // #R  best segment towards the parent
};

BorderTree grow_border_tree(std::span<const Segment> segments, Index region_count,
                            std::span<const double> preference) {
  const Index outside = region_count;
  const auto place = [&](Index side) { return side == none ? outside : side; };
  // Segments around every region and, last, the outside.
  const auto borders = csr_from<Index>(region_count + 1, [&](auto&& emit) {
    for (Index i = 0; i < static_cast<Index>(segments.size()); ++i) {
      if (segments[i].left == segments[i].right) continue;
      emit(place(segments[i].left), i);
      emit(place(segments[i].right), i);
    }
  });

  BorderTree tree;
  tree.segment.assign(region_count, none);
  std::vector<Index> queue{outside};
  std::vector<char> settled(region_count + 1, 0);
  settled[outside] = 1;
  for (std::size_t head = 0; head < queue.size(); ++head) {
    const Index here = queue[head];
    const std::size_t found = queue.size();
    for (const Index i : borders.row(here)) {
      const Index left = place(segments[i].left), right = place(segments[i].right);
      const Index there = left == here ? right : left;
      if (settled[there]) continue;
      if (tree.segment[there] == none) queue.push_back(there);
      Index& best = tree.segment[there];
      if (best == none || preference[i] > preference[best]) best = i;
    }
    for (std::size_t k = found; k < queue.size(); ++k) settled[queue[k]] = 1;
  }
  tree.order.assign(queue.begin() + 1, queue.end());
  return tree;
}

}  // namespace

std::vector<Index> segments_to_even(std::span<const Segment> segments, Index region_count,
                                    std::span<const Index> pieces,
                                    std::span<const double> preference) {
  std::vector<Index> counts = boundary_counts(segments, region_count, pieces);
  const BorderTree tree = grow_border_tree(segments, region_count, preference);
  std::vector<Index> chosen;
  for (auto r = tree.order.rbegin(); r != tree.order.rend(); ++r) {
    if (counts[*r] % 2 == 0) continue;
    const Segment& s = segments[tree.segment[*r]];
    chosen.push_back(tree.segment[*r]);
    for (const Index side : {s.left, s.right})
      if (side != none) ++counts[side];
  }
  return chosen;
}

namespace {

/// Nodes in the order of the caller's loops: along every edge as given, each node where it is
/// first.
std::vector<Index> document_order(const Domain& domain, std::span<const Segment> segments,
                                  const std::vector<Index>& node_of_point,
                                  const std::vector<Index>& first_interior, Index node_count) {
  const auto polylines_last = [](const Segment& s) { return s.region == none; };
  const std::vector<Index> order = sorted_numbers(segments.size(), [&](Index i, Index j) {
    const Segment &s = segments[i], &t = segments[j];
    if (polylines_last(s) != polylines_last(t)) return polylines_last(t);
    if (s.region != t.region) return s.region < t.region;
    if (s.loop != t.loop) return s.loop < t.loop;
    if (s.edge != t.edge) return s.edge < t.edge;
    return i < j;
  });
  std::vector<Index> rank(node_count, none);
  Index next = 0;
  const auto emit = [&](Index node) {
    if (rank[node] == none) rank[node] = next++;
  };
  for (const Index i : order) {
    const Segment& s = segments[i];
    emit(node_of_point[s.reversed ? s.b : s.a]);
    const Index begin = first_interior[i], end = first_interior[i + 1];
    for (Index k = 0; k < end - begin; ++k) emit(s.reversed ? end - 1 - k : begin + k);
    if (polylines_last(s)) emit(node_of_point[s.b]);
  }
  // What is left are isolated points, which the domain keeps in the caller's order.
  for (std::size_t p = 0; p < domain.points.size(); ++p)
    if (node_of_point[p] != none) emit(node_of_point[p]);
  return rank;
}

void measure_spacing(BoundaryMesh& mesh) {
  std::vector<Index> degree(mesh.points.size(), 0);
  mesh.spacing.assign(mesh.points.size(), 0.0);
  for (const Segment& e : mesh.edges) {
    const double l = distance(mesh.points[e.a], mesh.points[e.b]);
    for (const Index v : {e.a, e.b}) {
      mesh.spacing[v] += l;
      ++degree[v];
    }
  }
  for (std::size_t v = 0; v < degree.size(); ++v)
    if (degree[v] > 0) mesh.spacing[v] /= degree[v];
}

}  // namespace

BoundaryMesh assemble(const Domain& domain, std::span<const Segment> segments,
                      std::span<const char> used, const Division& division) {
  BoundaryMesh mesh;
  const auto add = [&mesh](Vec2 point, Vec2 world, Index source) {
    mesh.points.push_back(point);
    mesh.world.push_back(world);
    mesh.source.push_back(source);
    return static_cast<Index>(mesh.points.size()) - 1;
  };
  std::vector<Index> node_of_point(domain.points.size(), none);
  for (std::size_t p = 0; p < domain.points.size(); ++p)
    if (used[p]) node_of_point[p] = add(domain.points[p], domain.given[p], static_cast<Index>(p));
  std::vector<Index> first_interior;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    Segment piece = segments[i];
    const Index end = node_of_point[piece.b];
    piece.a = node_of_point[piece.a];
    first_interior.push_back(static_cast<Index>(mesh.points.size()));
    for (const Vec2 p : division.row(static_cast<Index>(i))) {
      piece.b = add(p, domain.frame.to_world(p), none);
      mesh.edges.push_back(piece);
      piece.a = piece.b;
    }
    piece.b = end;
    mesh.edges.push_back(piece);
  }
  first_interior.push_back(static_cast<Index>(mesh.points.size()));
  mesh.output_rank = document_order(domain, segments, node_of_point, first_interior,
                                    static_cast<Index>(mesh.points.size()));
  measure_spacing(mesh);
  return mesh;
}

}  // namespace lpq
