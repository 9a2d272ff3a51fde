// Does the head, at a waypoint, reach into what is printed or into the plate?
#pragma once

#include "collision/growing_part.h"
#include "process/process.h"
#include "robot/body.h"

#include <Eigen/Geometry>
#include <vector>

namespace voluta::toolpath {

class HeadClearance {
public:
  // The head less the contact tolerance (process::erodedHead). platform: convex, counter-clockwise,
  // work frame, solid below z = 0; empty: none.
  HeadClearance(const process::Process& process, std::vector<Eigen::Vector2d> platform);

  // Is the head clear of the plate, and by marginMm of all that is filled before waypoint `before`,
  // with the tip at `tip` and the nozzle coming from `direction` (unit)? What lies in it by less
  // than half a cell of the part's grid does not count, as in CellCollision. Work frame, mm.
  bool clears(const collision::GrowingPart& part, const Eigen::Vector3d& tip,
              const Eigen::Vector3d& direction, std::size_t before, double marginMm = 0.0) const;

private:
  bool clearsPlatform(const Eigen::Vector3d& tip, const Eigen::Vector3d& direction) const;

  std::vector<robot::Frustum> frusta_; // tool frame: z in the direction of extrusion
  std::vector<robot::Shape> shapes_;
  std::vector<Eigen::Vector2d> platform_, rim_; // rim: points along the platform's edge
};

} // namespace voluta::toolpath
