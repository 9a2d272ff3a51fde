// Collisions that an indicator learned for a layer expects, for whole-path smoothing (Dai 2020,
// 4.4).
#pragma once

#include "motion/motion_scene.h"
#include "motion/smoothing/smooth_turns.h"

#include <cstddef>
#include <optional>

namespace voluta::base {
class RunContext;
}

namespace voluta::motion {

class LearnedClearance {
public:
  // `scene` must outlive it.
  explicit LearnedClearance(const MotionScene& scene) : scene_(scene) {}

  // Returns how near joints are to a collision while a path's layer is printed, or null if the cell
  // has external axes or the layer is out of reach. Learns from samples about the contact space of
  // the layer's waypoints, with the part as it is when the layer is complete: about half a second.
  // The layer used last is kept. Valid until the next call. Throws Cancelled.
  const Nearness* of(std::size_t path, const base::RunContext& ctx);

private:
  void learn(int layer, const base::RunContext& ctx);

  const MotionScene& scene_;
  std::optional<int> layer_;
  std::optional<Nearness> nearness_;
};

} // namespace voluta::motion
