// Meshes that a URDF refers to.
#pragma once

#include "geometry/triangle_mesh.h"
#include "robot/urdf/urdf_tree.h"

#include <Eigen/Geometry>
#include <filesystem>
#include <string>

namespace voluta::robot {

// Returns the path of a mesh's file: relative to the URDF's folder; "package://NAME/REST" as
// NAME/REST in that folder or one above it, or REST in one of them that is called NAME. Empty if it
// does not exist.
std::filesystem::path meshPath(const std::string& written, const std::filesystem::path& urdf);

// Returns the mesh in `path`, whose unit is metres, scaled as the URDF says and moved to that pose
// [mm]. Throws as geometry::readMesh() and readForeign(). Precondition: no scale is 0.
geometry::TriangleMesh readUrdfMesh(const std::filesystem::path& path, const UrdfMesh& mesh,
                                    const Eigen::Isometry3d& pose);

} // namespace voluta::robot
