#include "robot/cell/json_pose.h"

#include "base/far_places.h"
#include "base/units.h"

namespace voluta::robot {

Eigen::Vector3d readVector3(const base::JsonNode& node) {
  const std::vector<base::JsonNode> list = node.items();
  if (list.size() != 3)
    node.fail("must have three numbers"_text);
  return {list[0].number(), list[1].number(), list[2].number()};
}

Eigen::Isometry3d readPose(const base::JsonNode& node) {
  node.allowOnly({"xyzMm", "rpyDeg"});
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  // Beyond it distances of bodies overflow.
  pose.translation() = readVector3(node.at("xyzMm"));
  if (!(pose.translation().cwiseAbs().maxCoeff() <= base::kFarthestMm))
    node.at("xyzMm").fail("must be within a kilometre"_text);
  if (node.has("rpyDeg")) {
    const Eigen::Vector3d rpy = readVector3(node.at("rpyDeg")) * (base::kPi / 180.0);
    const Eigen::Quaterniond rotation = Eigen::AngleAxisd(rpy.z(), Eigen::Vector3d::UnitZ()) *
                                        Eigen::AngleAxisd(rpy.y(), Eigen::Vector3d::UnitY()) *
                                        Eigen::AngleAxisd(rpy.x(), Eigen::Vector3d::UnitX());
    pose.linear() = rotation.normalized().toRotationMatrix();
  }
  return pose;
}

} // namespace voluta::robot
