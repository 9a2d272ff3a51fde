// Counts the layers between a place and the part's surface.
#pragma once

#include "base/run_context.h"
#include "layers/layer_stack.h"
#include "layers/stack_query.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::toolpath {

// Thread-safe after construction.
class LayerCount {
public:
  // `stack` must outlive this object. Throws Cancelled.
  LayerCount(const layers::LayerStack& stack, const base::RunContext& ctx);

  struct Layers {
    int count = 0;
    double mm = 0.0; // Distance to the middle of the last one
  };
  // Returns the layers of the same item that follow each other without a gap from a place on a
  // patch along a unit vector, at most `enough`. A layer of another build direction, such as that
  // of the next piece in planar mode, ends the count, and so does a support. Preconditions: the
  // place is on patch `patch`, whose thickness there is `thicknessMm`.
  Layers along(std::size_t patch, const Eigen::Vector3d& place, const Eigen::Vector3d& ray,
               double thicknessMm, int enough) const;

  // Returns the patch directly below a place of patch `patch`, whose build direction there is
  // `direction`; -1 if there is none without a gap.
  int patchBelow(std::size_t patch, const Eigen::Vector3d& place, const Eigen::Vector3d& direction,
                 double thicknessMm) const;

private:
  template <typename F>
  void walk(std::size_t patch, const Eigen::Vector3d& place, const Eigen::Vector3d& ray,
            double thicknessMm, int enough, F&& layer) const;

  const layers::LayerStack& stack_;
  layers::StackQuery query_;
  double maxThicknessMm_ = 0.0;
};

} // namespace voluta::toolpath
