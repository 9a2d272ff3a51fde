#include "toolpath/unsupported/head_clearance.h"

#include "collision/growing_part.h"
#include "geometry/least_turn.h"
#include "process/process.h"
#include "robot/cell.h"

#include <Eigen/Geometry>

namespace voluta::toolpath {

HeadClearance::HeadClearance(const robot::Cell& cell, const process::Process& process)
    : collision_(cell, process) {}

bool HeadClearance::clears(const collision::GrowingPart& part, const Eigen::Vector3d& tip,
                           const Eigen::Vector3d& direction, std::size_t before,
                           double marginMm) const {
  Eigen::Isometry3d work_T_tool = Eigen::Isometry3d::Identity();
  work_T_tool.linear() =
      geometry::shortestRotation(Eigen::Vector3d::UnitZ(), -direction).toRotationMatrix();
  work_T_tool.translation() = tip;
  return !collision_.headTouchesPlatform(work_T_tool, 0.0) &&
         !collision_.headTouchesPart(work_T_tool, part, before, marginMm) &&
         !collision_.holderTouches(work_T_tool, part, before, {});
}

} // namespace voluta::toolpath
