// Meshes that a URDF refers to.
#pragma once

#include "geometry/triangle_mesh.h"
#include "robot/urdf/urdf_tree.h"

#include <Eigen/Geometry>
#include <filesystem>
#include <string>

namespace voluta::robot {

// Where a mesh's file is: relative to the URDF's folder; "package://NAME/REST" as NAME/REST in that
// folder or one above it, or REST in one of them that is called NAME. Empty: it is not there.
std::filesystem::path meshPath(const std::string& written, const std::filesystem::path& urdf);

// The mesh in `path`, in metres and scaled as the URDF says, at that pose. mm.
// Throws as geometry::readMesh() and readForeign(). Precondition: no scale is 0.
geometry::TriangleMesh readUrdfMesh(const std::filesystem::path& path, const UrdfMesh& mesh,
                                    const Eigen::Isometry3d& pose);

} // namespace voluta::robot
