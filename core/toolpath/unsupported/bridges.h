// Detects unsupported beads: spans without printed material below, known before the motion is
// planned.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <vector>

namespace voluta::base {
class RunContext;
}
namespace voluta::collision {
class GrowingPart;
}
namespace voluta::plan {
struct ToolPath;
struct ToolPlan;
} // namespace voluta::plan
namespace voluta::platform {
struct PlatformSolid;
}

namespace voluta::toolpath {

// Returns per waypoint 1 if the bead is unsupported: neither the platform nor earlier material is
// directly below it at any of eight samples across its width (at fewer than `minPlaces` of them),
// within its height and a quarter more below the tip. Ignores stretches shorter than a bead's
// width, interruptions of longer stretches by that little, and waste. `part`: the plan's beads with
// its ground. Throws Cancelled.
std::vector<char> unsupportedWaypoints(const plan::ToolPlan& plan,
                                       const collision::GrowingPart& part,
                                       const platform::PlatformSolid& platform,
                                       const base::RunContext& ctx, int minPlaces = 1);

// A range [begin, end) of unsupported waypoints of one path.
struct UnsupportedStretch {
  std::size_t begin = 0, end = 0;
};
// Returns the stretches of a path that are longer than the given length, in order.
std::vector<UnsupportedStretch> unsupportedStretches(const plan::ToolPlan& plan,
                                                     const plan::ToolPath& path,
                                                     const std::vector<char>& unsupported,
                                                     double longerThanMm);

// Returns how many of kPlacesAcross samples across a bead are supported, as above, if it is printed
// with the tip at `tip` along `direction`. Stops counting at `enough`.
inline constexpr int kPlacesAcross = 8;        // as in the replay
inline constexpr int kMinSupportedSamples = 2; // a quarter of the width
int supportedSamples(const plan::ToolPlan& plan, const plan::ToolPath& path, std::size_t waypoint,
                     const Eigen::Vector3d& tip, const Eigen::Vector3d& direction,
                     const collision::GrowingPart& part, const platform::PlatformSolid& platform,
                     int enough = kPlacesAcross);
// Returns the unit vector sideways to the path at a waypoint: direction x path tangent.
Eigen::Vector3d sideOf(const plan::ToolPlan& plan, const plan::ToolPath& path,
                       std::size_t waypoint);

} // namespace voluta::toolpath
