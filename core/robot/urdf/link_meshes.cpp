#include "robot/urdf/link_meshes.h"

#include "base/data_files.h"
#include "base/error.h"
#include "base/files.h"
#include "geometry/append_mesh.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/simplify.h"
#include "robot/urdf/urdf_chain.h"
#include "robot/urdf/urdf_mesh.h"

#include <map>
#include <optional>
#include <set>

namespace voluta::robot {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kTriangles = 12000; // Per link: as many as a picture can show
constexpr int kMaxFrames = 16;

fs::path folderOf(const fs::path& robotFile) {
  return fs::path(robotFile).replace_extension(".links");
}

fs::path fileOf(const fs::path& folder, int frame) {
  return folder / (std::to_string(frame) + ".stl");
}

std::optional<geometry::TriangleMesh>
meshOf(const UrdfSolid& solid, const Eigen::Isometry3d& frame_T_link, const fs::path& urdf) {
  const auto* mesh = std::get_if<UrdfMesh>(&solid.shape);
  if (!mesh || mesh->scale.cwiseAbs().minCoeff() == 0.0)
    return std::nullopt;
  const fs::path file = meshPath(mesh->file, urdf);
  if (file.empty())
    return std::nullopt;
  try {
    return readUrdfMesh(file, *mesh, frame_T_link * solid.link_T_solid);
  } catch (const base::Error&) {
    return std::nullopt;
  }
}

} // namespace

std::vector<LinkMesh> urdfLinkMeshes(const fs::path& urdf, const UrdfOptions& options) {
  const UrdfTree tree = readUrdfTree(urdf);
  const UrdfChain chain = urdfChain(tree, options.tip, options.base, urdf.filename().string());
  std::map<int, geometry::TriangleMesh> meshes;
  std::set<int> without;
  for (const FixedLink& fixed : chain.links)
    for (const UrdfSolid& solid : tree.links[fixed.link].visual) {
      if (without.contains(fixed.frame))
        continue;
      if (const auto mesh = meshOf(solid, fixed.frame_T_link, urdf))
        geometry::appendMesh(meshes[fixed.frame], *mesh);
      else
        without.insert(fixed.frame);
    }
  std::vector<LinkMesh> found;
  for (const auto& [frame, mesh] : meshes)
    if (!without.contains(frame))
      found.push_back({frame, geometry::simplified(mesh, kTriangles)});
  return found;
}

void writeLinkMeshes(const fs::path& robotFile, const std::vector<LinkMesh>& meshes) {
  const fs::path folder = folderOf(robotFile);
  std::error_code failed;
  fs::remove_all(folder, failed);
  if (!meshes.empty() && !failed)
    fs::create_directories(folder, failed);
  if (failed)
    throw base::Error(base::ErrorCode::CannotWrite,
                      base::message("cannot be written: {why}"_text, failed.message()),
                      folder.string());
  for (const LinkMesh& link : meshes)
    base::writeFile(fileOf(folder, link.frame), geometry::writeStl(link.mesh));
}

std::vector<LinkMesh> readLinkMeshes(const fs::path& robotFile) {
  std::vector<LinkMesh> meshes;
  const fs::path folder = folderOf(robotFile);
  for (int frame = 0; frame < kMaxFrames; ++frame) {
    const fs::path file = fileOf(folder, frame);
    std::error_code none;
    if (!fs::is_regular_file(file, none))
      continue;
    try {
      meshes.push_back({frame, geometry::readMesh(file).mesh});
    } catch (const base::Error&) {
      // Its solids are drawn instead.
    }
  }
  return meshes;
}

std::vector<LinkMesh> linkMeshesOf(const std::string& robotId) {
  try {
    return readLinkMeshes(base::dataFile("robots", robotId, "unknown robot '{id}'"_text));
  } catch (const base::Error&) {
    return {};
  }
}

} // namespace voluta::robot
