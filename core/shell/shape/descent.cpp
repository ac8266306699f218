// See descent.h.
#include "shell/shape/descent.h"

#include <cmath>

namespace lpq {
namespace {

constexpr double largest_move = 0.2;  // per iteration, in units of the vertex's size

}  // namespace

SpaceQuad corners_of(const ShellMesh& mesh, Index f) {
  const Face& face = mesh.faces[f];
  return {mesh.points[face[0]], mesh.points[face[1]], mesh.points[face[2]], mesh.points[face[3]]};
}

ShellDescent::ShellDescent(ShellMesh& mesh, Freedom& freedom)
    : mesh_(mesh), freedom_(freedom), size_(mesh.points.size()), gradient_(mesh.points.size()) {}

/// Harmonic mean (of the squares) of the edge lengths at each vertex, as in cleanup/descent.h.
void ShellDescent::find_sizes(const DescentPart& part) {
  std::vector<Index> count(mesh_.points.size(), 0);
  for (const Index v : part.vertices) size_[v] = 0;
  for (const Index f : part.faces)
    for (int k = 0; k < 4; ++k) {
      const Index a = mesh_.faces[f][k], b = mesh_.faces[f][(k + 1) & 3];
      const double squared = squared_length(mesh_.points[b] - mesh_.points[a]);
      if (!(squared > 0)) continue;
      for (const Index v : {a, b}) {
        size_[v] += 1 / squared;
        ++count[v];
      }
    }
  for (const Index v : part.vertices)
    if (count[v] > 0) size_[v] = std::sqrt(count[v] / size_[v]);
}

void ShellDescent::place(const DescentPart& part, std::span<const double> unknowns) {
  std::size_t at = 0;
  for (const Index v : part.vertices) {
    const int n = freedom_.unknowns(v);
    double displacement[2] = {0, 0};
    for (int i = 0; i < n; ++i) displacement[i] = size_[v] * unknowns[at++];
    freedom_.place(v, displacement);
  }
}

Evaluation ShellDescent::evaluate(const DescentPart& part, FaceEnergy energy,
                                  std::span<double> by_unknown) {
  for (const Index f : part.faces)
    for (const Index v : mesh_.faces[f]) gradient_[v] = {};
  double sum = 0;
  for (const Index f : part.faces) {
    SpaceQuad gradient{};
    const Evaluation one = energy(f, corners_of(mesh_, f), gradient);
    if (one.status != EvalStatus::ok) return one;
    sum += one.value;
    for (int k = 0; k < 4; ++k) gradient_[mesh_.faces[f][k]] += gradient[k];
  }
  std::size_t at = 0;
  for (const Index v : part.vertices) {
    const int n = freedom_.unknowns(v);
    double by[2];
    freedom_.pull_back(v, gradient_[v], by);
    for (int i = 0; i < n; ++i) by_unknown[at++] = size_[v] * by[i];
  }
  return {sum, EvalStatus::ok};
}

int ShellDescent::run(const DescentPart& part, int iterations, double tolerance,
                      FaceEnergy energy) {
  std::size_t unknowns = 0;
  for (const Index v : part.vertices) unknowns += freedom_.unknowns(v);
  if (unknowns == 0 || iterations <= 0) return 0;
  find_sizes(part);
  freedom_.anchor(part.vertices);
  const auto objective = [&](std::span<const double> x, std::span<double> gradient) {
    place(part, x);
    return evaluate(part, energy, gradient);
  };
  Lbfgs descent(std::vector<double>(unknowns, 0.0), {.value_tolerance = tolerance},
                std::vector<double>(unknowns, largest_move));
  descent.step(iterations, objective);
  place(part, descent.x());
  return descent.iterations();
}

}  // namespace lpq
