// From where a place is seen, and what has to make room for that.
#pragma once

#include "scene/scene.h"

#include <Eigen/Core>

namespace voluta::scene {

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
