// The prime: a waste bead that fills the nozzle before the part begins. It is planned and checked
// like any other bead.
#pragma once

#include "plan/finding.h"
#include "plan/tool_plan.h"
#include "process/tooling.h"
#include "robot/cell.h"
#include "toolpath/options.h"

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

namespace voluta::toolpath {

// Distance of its centreline from all printed beads, and from the plate's edge [mm]; more for beads
// wider than 4 mm.
inline constexpr double kPrimeOffsetMm = 10.0, kPrimeFromEdgeMm = 4.0;
// If the plate has no room, the prime is a short bead in the air, at this distance outside the
// plate and height above its top. The material falls beside the plate.
inline constexpr double kPrimeOutsideMm = 15.0, kPrimeAboveMm = 10.0, kPrimeInAirMm = 15.0;

// The vertices of the bead's centreline, on the plate or in the air; a closed one ends where it
// begins. The side is the one nearest to the start of the first path; in the air, to the arm's home
// position.
struct PrimePlace {
  std::vector<Eigen::Vector2d> corners;
  bool onPlate = true;
};
// `plate`: convex, counter-clockwise. beadWidthMm: of the prime. Precondition: at least one
// position.
PrimePlace primePlace(const std::vector<Eigen::Vector2d>& plate,
                      const std::vector<Eigen::Vector3d>& positions, const Eigen::Vector2d& rest,
                      bool skirt, double lengthMm, double beadWidthMm);

// Returns whether the plate has room for the bead. Same precondition as primePlace.
bool hasRoomForPrime(const std::vector<Eigen::Vector2d>& plate,
                     const std::vector<Eigen::Vector3d>& positions, bool skirt, double lengthMm,
                     double beadWidthMm);

// Puts the bead before all other paths, printed with the first tool: a ring as PathKind::Skirt, a
// line as PathKind::Prime. Does nothing if options.prime is "none", the plan has no path, or the
// platform is no plate. `others`: places of other beads that it keeps clear of. Returns a finding
// with the place if the bead falls because the plate has no room for it.
std::optional<plan::Finding> addPrimePath(plan::ToolPlan& plan, const robot::Cell& cell,
                                          const process::Tooling& tooling,
                                          const ToolpathOptions& options,
                                          std::span<const Eigen::Vector3d> others = {});

} // namespace voluta::toolpath
