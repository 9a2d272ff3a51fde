// Where the nozzle is filled before the part begins: a bead of its own, waste, which is planned and
// checked as any other.
#pragma once

#include "plan/finding.h"
#include "plan/tool_plan.h"
#include "process/process.h"
#include "robot/cell.h"
#include "toolpath/options.h"

#include <Eigen/Core>
#include <optional>
#include <vector>

namespace voluta::toolpath {

// How far beside all that is printed, and how far from the plate's edge, its middle stays, mm.
inline constexpr double kPrimeAsideMm = 10.0, kPrimeFromEdgeMm = 4.0;
// Where the plate has no room: a short bead in the air, so far outside the plate and above its top.
// What it lays falls beside the plate.
inline constexpr double kPrimeOutsideMm = 15.0, kPrimeAboveMm = 10.0, kPrimeInAirMm = 15.0;

// The corners of the bead's middle, on the plate or in the air; one that is closed ends where it
// begins. Of all sides the nearest to where the first path begins, in the air to where the arm
// rests.
struct PrimePlace {
  std::vector<Eigen::Vector2d> corners;
  bool onPlate = true;
};
// `plate`: convex, counter-clockwise. Precondition: positions has one at least.
PrimePlace primePlace(const std::vector<Eigen::Vector2d>& plate,
                      const std::vector<Eigen::Vector3d>& positions, const Eigen::Vector2d& rest,
                      bool skirt, double lengthMm);

// Is there room for the bead on that plate? Same precondition as primePlace.
bool hasRoomForPrime(const std::vector<Eigen::Vector2d>& plate,
                     const std::vector<Eigen::Vector3d>& positions, bool skirt, double lengthMm);

// Puts the bead before all other paths: a ring as PathKind::Skirt, a line as PathKind::Prime. Does
// nothing if options.prime is "none", the plan has no path, or the platform is no plate. Returns a
// finding with the place if the bead falls because the plate has no room for it.
std::optional<plan::Finding> addPrimePath(plan::ToolPlan& plan, const robot::Cell& cell,
                                          const process::Process& process,
                                          const ToolpathOptions& options);

} // namespace voluta::toolpath
