// Automatic arrangement of several parts on a plate.
#pragma once

#include "layers/print_order.h"
#include "pipeline/items/footprint.h"

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

namespace voluta::pipeline {

struct ArrangeOptions {
  layers::PrintOrder order = layers::PrintOrder::OneAfterAnother;
  double spareMm = 3.0; // Distance beyond the one that the head needs, and from the plate's edge
  // Corners of the plate, convex and counter-clockwise; empty: as large as needed
  std::vector<Eigen::Vector2d> plate;
};

// Returns how far each part has to be moved [mm] so that the parts keep the distances that the head
// needs in this order of printing: the largest first, each as near to the plate's centre as it can
// be. Returns nullopt if the plate has no room for all of them.
std::optional<std::vector<Eigen::Vector2d>> arranged(std::span<const Footprint> parts,
                                                     const process::HeadShape& head,
                                                     const ArrangeOptions& options);

} // namespace voluta::pipeline
