// Collision solids for the links of an arm given as a URDF.
#pragma once

#include "robot/body.h"
#include "robot/urdf/urdf_chain.h"

#include <filesystem>
#include <string>
#include <vector>

namespace voluta::robot {

// Returns one body per frame, base first, with everything that is fixed to it: the links' collision
// shapes, or else their visual ones. Cylinders, boxes and spheres are kept, and each mesh is
// enclosed by capsules. A link without a solid, or with an unavailable mesh, gets a capsule along
// it, which is listed in `assumed`. `file`: the URDF, relative to which meshes are searched.
std::vector<Body> urdfBodies(const UrdfTree& tree, const UrdfChain& chain,
                             const std::filesystem::path& file, std::vector<std::string>& assumed);

} // namespace voluta::robot
