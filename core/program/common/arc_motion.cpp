#include "program/common/arc_motion.h"

#include "program/common/arc.h"

namespace voluta::program {

std::optional<base::Message> setArc(const Eigen::Vector3d& from, const Eigen::Vector3d& via,
                                    plan::ProgramMotion& motion) {
  const std::optional<Arc> arc = arcThrough(from, via, motion.frame_T_tcp.translation());
  if (!arc)
    return "the three points of an arc are on a line"_text;
  for (const Eigen::Vector3d& point : pointsAlong(*arc))
    motion.viaPoints.push_back({point, Eigen::Vector3d::UnitZ()});
  return std::nullopt;
}

double lengthMm(const Eigen::Vector3d& from, const plan::ProgramMotion& motion) {
  Eigen::Vector3d last = from;
  double length = 0.0;
  for (const plan::NozzlePoint& point : motion.viaPoints) {
    length += (point.position - last).norm();
    last = point.position;
  }
  return length + (motion.frame_T_tcp.translation() - last).norm();
}

} // namespace voluta::program
