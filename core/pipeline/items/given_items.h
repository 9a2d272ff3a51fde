// The toolpath stage of several items, some of which are printed along the tool-paths of their
// files.
#pragma once

#include "layers/print_order.h"
#include "pipeline/stages.h"

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace voluta::pipeline {

struct GivenItem {
  std::size_t item = 0;
  std::shared_ptr<const ToolpathStage> stage; // givenToolpathStage()
};
using GivenItems = std::vector<GivenItem>;

// Returns where these items are printed: the positions of their waypoints.
std::vector<Eigen::Vector3d> placesOf(const GivenItems& given);

// Returns the stage of all items: the plans joined (joined_plans.h), figures of the whole, findings
// with their items. `planned`: of all other items; without a plan if there is none. `sequence`: as
// joinedPlans().
std::shared_ptr<const ToolpathStage> joinedStage(const ToolpathStage& planned,
                                                 const GivenItems& given, layers::PrintOrder order,
                                                 std::span<const std::size_t> sequence,
                                                 const process::Tooling& tooling);

} // namespace voluta::pipeline
