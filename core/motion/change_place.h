// Where the tool is changed and the nozzle purged, and the way there.
#pragma once

#include "motion/motion_scene.h"
#include "motion/transfers/transfer.h"
#include "plan/trajectory.h"
#include "process/process.h"

#include <functional>
#include <optional>
#include <vector>

namespace voluta::motion {

// Joints at which material may drop, and those at the end of a wipe beside it (the same ones if the
// nozzle cannot be moved aside, or is fixed).
struct PurgePlace {
  robot::JointVector at, wiped;
};

// Returns places, best first, from which nothing drips on the plan's tool-paths or the workpiece
// (with 30 mm to spare), and at which the cell's bodies keep clear of each other. With a moving
// nozzle: the cell's own place (robot::Cell::purgePlaceMm), else points beside the plate, then
// points above it beside the print, low ones and those near `home` first. Then, and with a fixed
// nozzle: home with one of the arm's first two joints moved as little as is needed, so that the
// drops fall beside the plate, or at least beside the print. Empty if there are none. The robot's
// base is upright.
std::vector<PurgePlace> purgePlaces(const MotionScene& scene, const robot::JointVector& home);

// Material that drops from the nozzle with these joints: whether it falls on the plan's tool-paths
// or the workpiece.
bool dropsOnPart(const MotionScene& scene, const robot::JointVector& q);

// Returns the material that primes a nozzle at rest [mm3].
double primeMm3(const process::Process& process);
// Returns the purge with that volume, at point 0; nullopt if it is 0, or the tool lays tape.
std::optional<plan::TrajectoryEvent> purgeEvent(const process::Process& process, double mm3);

struct PurgeTrip {
  std::vector<TransferPoint> there, wipe, back; // `wipe` may be empty
};
// Plans a motion between two states: straight in joint space, or else around obstacles.
using Go = std::function<std::optional<Transfer>(const RobotState& from, const RobotState& to,
                                                 bool isStraight)>;
// Returns the way from rest to the first of the places that can be reached, and back; nullopt if
// there is none. Throws Error{UnusableInput} if the cell states a place and the arm does not get
// there.
std::optional<PurgeTrip> purgeTrip(const MotionScene& scene, const RobotState& rest,
                                   const std::vector<PurgePlace>& places, const Go& go);

} // namespace voluta::motion
