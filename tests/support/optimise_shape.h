// All steps of a ShapeFinisher at once.
#pragma once

#include <utility>

#include "shell/shape/shape.h"

namespace lpq_test {

inline lpq::ShapeStats optimise_shape(const lpq::Charted& charted,
                                      const lpq::SmoothOptions& options, lpq::ShellMesh& mesh) {
  lpq::ShapeFinisher finisher(charted, options, std::move(mesh));
  while (finisher.step()) {
  }
  mesh = finisher.take();
  return finisher.stats();
}

}  // namespace lpq_test
