// From where a place is seen, and what has to make room for that.
#pragma once

#include "robot/robot_model.h"

#include <Eigen/Core>
#include <array>

namespace voluta::scene {

class Scene;

// What a straight line from a place to an eye meets on its way, of what is drawn.
struct Between {
  bool printed = false;  // part, voxels, pieces, layers or paths; not what is see-through
  bool platform = false; // the drawing of it
  std::array<bool, robot::kBodyRoleCount> roles{}; // of the cell's bodies
  bool machine() const;                            // the platform, or a body
};

struct Sight {
  Eigen::Vector3d towardsEye = Eigen::Vector3d::UnitX();       // world, unit
  Eigen::Vector3d towardsEyeInWork = Eigen::Vector3d::UnitX(); // the same in the work frame
  Between hides; // what still hides the place from there: to be cut away, or left out
};

// The direction nearest to the camera's own from which nothing of the machine hides the place and
// nothing printed does; else nothing of the machine; else the camera's own. The eye is where
// Scene::lookAt(placeInWork, radiusMm) puts it.
Sight clearSight(const Scene& scene, const Eigen::Vector3d& placeInWork, double radiusMm);

} // namespace voluta::scene
