// Solids for the links of an arm that comes as a URDF.
#pragma once

#include "robot/body.h"
#include "robot/urdf/urdf_chain.h"

#include <filesystem>
#include <string>
#include <vector>

namespace voluta::robot {

// A body a frame, base first, with all that is fixed to it: what its links have for collisions, or
// else for the eye. Cylinders, boxes and spheres as they are, meshes enclosed by some capsules
// each.
// What has no solid, or a mesh that cannot be had, gets a capsule along the link; all that is told
// in `assumed`. `file`: the URDF, beside which meshes are looked for.
std::vector<Body> urdfBodies(const UrdfTree& tree, const UrdfChain& chain,
                             const std::filesystem::path& file, std::vector<std::string>& assumed);

} // namespace voluta::robot
