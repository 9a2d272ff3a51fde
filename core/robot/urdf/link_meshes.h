// What the links of an arm look like: meshes for the eye, of an arm that came with some. They are
// kept beside the robot's file, ROBOT.links/FRAME.stl, and no check knows them: what is checked are
// the solids in the robot's file.
#pragma once

#include "geometry/triangle_mesh.h"
#include "robot/urdf/urdf_reader.h"

#include <filesystem>
#include <string>
#include <vector>

namespace voluta::robot {

struct LinkMesh {
  int frame = 0;               // as Body::frame
  geometry::TriangleMesh mesh; // in that frame, mm
};

// Of a description: what its links have for the eye. A frame with a box, a cylinder or a mesh that
// cannot be had among that has none, and is drawn as its solids. Throws as readUrdf().
std::vector<LinkMesh> urdfLinkMeshes(const std::filesystem::path& urdf, const UrdfOptions& options);

// Into the folder beside the robot's file, in place of what is there; no folder without meshes.
// Throws Error{CannotWrite}.
void writeLinkMeshes(const std::filesystem::path& robotFile, const std::vector<LinkMesh>& meshes);
// What is there and can be read.
std::vector<LinkMesh> readLinkMeshes(const std::filesystem::path& robotFile);

// Those of the robot of that id; none of one that is not known.
std::vector<LinkMesh> linkMeshesOf(const std::string& robotId);

} // namespace voluta::robot
