// The state of cutting a surface into charts: edges cut so far, charts accepted, parts known to
// have no good map.
#pragma once

#include <array>
#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include "surface/charts/charts.h"
#include "surface/charts/split.h"

namespace lpq {

class ChartMaker {
 public:
  ChartMaker(const SurfaceMesh& mesh, std::span<const char> feature, const ChartOptions& options);
  /// Cuts until every part is accepted.
  void cut_up();
  /// Puts neighbouring parts of a face together again where one map serves both.
  void merge();
  Atlas finish();

 private:
  struct Neighbours {
    Index a = none, b = none;  // charts, a < b
    double shared = 0;         // length of their common cuts
  };
  void work_on(std::vector<Index> triangles);
  PartMap map(const Part& part, MapMethod last);
  void remember_hopeless(const Part& part);
  bool known_hopeless(const Part& part) const;
  void keep(const Part& part, PartMap map);
  bool try_cut_open(const Part& part);
  void split(const Part& part, Verdict verdict);
  void separate_all(const Part& part);
  void mark(std::span<const Index> half_edges, char value);

  std::vector<Neighbours> neighbours() const;
  std::vector<Index> shared_cuts(Index a, Index b) const;
  bool try_merge(Index a, Index b);

  const SurfaceMesh& mesh_;
  ChartOptions options_;
  PartTaker taker_;
  Splitter splitter_;
  std::vector<Index> face_;                  // #T
  std::vector<std::vector<Index>> waiting_;  // parts, as triangles
  std::vector<Index> chart_of_;              // #T  none while waiting
  std::set<std::uint64_t> hopeless_;         // hashes of the parts without a good map
  Atlas atlas_;
};

}  // namespace lpq
