// Search for a camera direction with an unobstructed view of a place.
#pragma once

#include "scene/scene.h"

#include <Eigen/Core>

namespace voluta::scene {

struct Sight {
  Eigen::Vector3d towardsEye = Eigen::Vector3d::UnitX();       // world, unit
  Eigen::Vector3d towardsEyeInWork = Eigen::Vector3d::UnitX(); // the same in the work frame
  Between hides; // objects that still hide the place from there: to be cut away or hidden
};

// Returns the direction closest to the camera's own from which neither the machine nor printed
// material hides the place; otherwise one from which the machine does not; otherwise the camera's
// own. The eye is at the distance of Scene::lookAt(placeInWork, radiusMm).
Sight clearSight(const Scene& scene, const Eigen::Vector3d& placeInWork, double radiusMm);

} // namespace voluta::scene
