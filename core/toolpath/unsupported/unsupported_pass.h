// A pass over unsupported beads: its input, its result, its row in the table (passes.h).
#pragma once

#include "layers/layer_stack.h"
#include "plan/finding.h"
#include "plan/tool_plan.h"
#include "process/tooling.h"

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace voluta::base {
class RunContext;
}
namespace voluta::collision {
class GrowingPart;
}
namespace voluta::platform {
struct PlatformSolid;
}
namespace voluta::robot {
class Cell;
}

namespace voluta::toolpath {

enum class PassPhase {
  // On the assembled plan, whose directions are those of the layers; on plates only. All passes see
  // the part as grown from the assembled plan.
  BeforeDirections,
  // On the plan whose directions are chosen next: a direction of the result is tried first, and
  // kept where the head is clear; the middles of beads are kept anyway. Each pass sees the part as
  // grown from the plan of the pass before.
  WithDirections,
  // On the plan with its final directions: speeds only.
  AfterDirections
};

// The part of a plan that a pass may change; everything else stays as it is.
enum class PassChange {
  Waypoints, // position, direction, height and speed of waypoints
  Supports,  // adds paths of kind Support before the first path of a patch
  Order      // order of the paths of a patch, and the order of waypoints in a path
};

// A plan between two passes.
struct UnsupportedBeads {
  plan::ToolPlan plan;
  // Per waypoint: its bead is unsupported (bridges.h), as far as passes have not cured it.
  std::vector<char> unsupported;
  // Per waypoint, unit vector: directions.h. Empty except BeforeDirections.
  std::vector<Eigen::Vector3d> clearDirection;
  // Per waypoint: the middle of its bead, position - 1/2 height x direction. Passes update it, so
  // that beads that are only tilted keep it to the last bit. Empty except WithDirections.
  std::vector<Eigen::Vector3d> middle;
};

// All that passes see besides the plan. The referenced objects must outlive it.
struct PassScene {
  const robot::Cell& cell;
  process::Tooling tooling; // the process of the first tool is the cell's
  const platform::PlatformSolid& platform;
  std::span<const layers::Pocket> pockets = {}; // filled before the beads above them
  bool canTilt = true;                          // ToolpathOptions::canTilt
  // Whether no support may stand below a place on that path; null: it may everywhere.
  std::function<bool(const plan::ToolPath&, const Eigen::Vector3d&)> isBlocked = {};
};

// Returns the part that a pass sees. It is grown at the first call, so passes that find nothing to
// do should not call it.
using SeenPart = std::function<const collision::GrowingPart&()>;

// Returns the finding about beads that were tilted. `begun`: the plan at the beginning of the
// phase; `direction`: the chosen direction of each of its waypoints.
using FindingOfDirections = std::function<std::optional<plan::Finding>(
    const plan::ToolPlan& begun, const std::vector<Eigen::Vector3d>& direction)>;

struct PassResult {
  UnsupportedBeads beads;
  double addedMm3 = 0.0;                             // volume of added paths
  std::optional<plan::Finding> finding = {};         // nullopt: nothing to report
  FindingOfDirections findingOfDirections = nullptr; // WithDirections only; null: as above
};

// Returns the changed plan; nullopt if nothing is to be changed, as in a plan without unsupported
// waypoints. Throws Cancelled.
using PassFunction = std::optional<PassResult>(const UnsupportedBeads& beads, const SeenPart& part,
                                               const PassScene& scene, const base::RunContext& ctx);

struct UnsupportedPass {
  std::string_view id;
  PassPhase phase = PassPhase::BeforeDirections;
  PassChange changes = PassChange::Waypoints;
  PassFunction* run = nullptr;
};

} // namespace voluta::toolpath
