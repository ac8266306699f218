// The charts of a surface meshed again and again, with smaller sizes where there is no mesh or one
// that is too coarse, until all have a mesh and the union is one.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/function_ref.h"
#include "base/result.h"
#include "mesh/validate.h"
#include "shell/mesh_charts.h"
#include "shell/options.h"
#include "shell/smaller.h"

namespace lpq {

/// A surface with its features, cut into charts.
struct Cut {
  const SurfaceMesh& surface;
  SurfaceFeatures& features;  // more of them where it has no mesh else
  const SurfaceCrossField& cross;
  const Atlas& atlas;
};

/// Largest slope of the size field: the option, or what stands for 0.
double growth_of(const SurfaceOptions& options);

class ChartRounds {
 public:
  /// What `cut` refers to must outlive the rounds. `size`: #V, the sizes of the first round.
  ChartRounds(const Cut& cut, std::vector<double> size, const SurfaceOptions& options);
  ChartRounds(const ChartRounds&) = delete;
  ChartRounds& operator=(const ChartRounds&) = delete;
  ~ChartRounds();

  /// The curves of a round, or one step of the planar chain in one chart. Errors: those of
  /// mesh_curves, too_many_elements; no_valid_mesh with the place when there were enough rounds.
  Problem step();
  bool done() const { return done_; }
  /// See SurfaceMesher.
  bool mesh_planes(int threads, FunctionRef<bool(Index)> keep_going);

  Index round() const { return round_; }                  // from 1
  std::span<const double> size() const { return size_; }  // #V, of this round
  const ChartsMesher* charts() const { return charts_ ? &*charts_ : nullptr; }
  /// Of the charts so far, or once done of all.
  const ShellMesh& mesh() const { return charts_ ? charts_->result().mesh : mesh_; }
  /// Refers to these rounds.
  Charted charted() const;

 private:
  Problem start_round();
  Problem end_round(MeshedCharts made);
  void refine_doubts();
  double add_crossings(std::vector<Fault>& doubts) const;
  std::vector<Fault> faults_of(std::vector<ChartFailure>& failures) const;
  std::vector<Fault> faults_at(const std::vector<Violation>& violations) const;
  Problem try_again(const std::vector<Fault>& faults);
  void divide_tips();
  void keep_vertices(const std::vector<Fault>& faults);
  bool has_grown() const;
  bool take_kept();
  Error failed(const Fault& fault) const;
  double size_there(const Fault& fault) const;

  Cut cut_;
  SurfaceOptions options_;
  SurfaceFeatures lines_;            // features and cuts
  std::vector<double> size_;         // #V
  double capacity_at_first_;         // quads that fit before sizes became smaller
  double nodes_at_first_ = 0;        // of the curves
  std::vector<char> kept_vertices_;  // #V  that have nodes
  SurfaceCurves curves_;
  CurveMesh nodes_;
  PlaneMeshes made_;
  std::optional<ChartsMesher> charts_;  // while they are meshed
  ShellMesh mesh_;
  struct Kept {
    ShellMesh mesh;
    std::vector<double> size;
    SurfaceFeatures features, lines;
    SurfaceCurves curves;
    CurveMesh nodes;
    double crossings = 0;    // that the surface has not
    std::size_t places = 0;  // where it is too coarse
  };
  std::optional<Kept> kept_;  // good enough, while a better one is tried
  int doubts_ = 0;            // rounds for meshes that were too coarse in places
  int faulty_ = 0;            // rounds with faults since a mesh is kept
  Index round_ = 1;
  bool done_ = false;
};

}  // namespace lpq
