// Visual meshes of an arm's links, for arms that come with meshes. They are stored next to the
// robot's file as ROBOT.links/FRAME.stl and not used by any check: collisions are checked with the
// solids in the robot's file.
#pragma once

#include "geometry/triangle_mesh.h"
#include "robot/urdf/urdf_reader.h"

#include <filesystem>
#include <string>
#include <vector>

namespace voluta::robot {

struct LinkMesh {
  int frame = 0;               // As Body::frame
  geometry::TriangleMesh mesh; // In that frame [mm]
};

// Returns the visual meshes of a description's links. A frame whose visuals include a box, a
// cylinder or an unavailable mesh has none, and is drawn as its solids. Throws as readUrdf().
std::vector<LinkMesh> urdfLinkMeshes(const std::filesystem::path& urdf, const UrdfOptions& options);

// Writes the meshes to the folder next to the robot's file, replacing its content; creates no
// folder if there are no meshes. Throws Error{CannotWrite}.
void writeLinkMeshes(const std::filesystem::path& robotFile, const std::vector<LinkMesh>& meshes);
// Returns the meshes that exist and can be read.
std::vector<LinkMesh> readLinkMeshes(const std::filesystem::path& robotFile);

// Returns the meshes of the robot with that id; none for an unknown id.
std::vector<LinkMesh> linkMeshesOf(const std::string& robotId);

} // namespace voluta::robot
