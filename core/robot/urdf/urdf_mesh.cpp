#include "robot/urdf/urdf_mesh.h"

#include "base/error.h"
#include "geometry/formats/foreign_reader.h"
#include "geometry/formats/mesh_reader.h"

#include <optional>
#include <utility>

namespace voluta::robot {

using Eigen::Vector3d;
namespace fs = std::filesystem;

namespace {

constexpr double kMmInMetre = 1000.0;

std::optional<std::string_view> after(std::string_view text, std::string_view prefix) {
  if (!text.starts_with(prefix))
    return std::nullopt;
  return text.substr(prefix.size());
}

} // namespace

fs::path meshPath(const std::string& written, const fs::path& urdf) {
  std::error_code none;
  const fs::path folder = fs::absolute(urdf, none).parent_path();
  if (const auto rest = after(written, "package://")) {
    const fs::path named(*rest), package = *named.begin();
    const fs::path inside = named.lexically_relative(package);
    for (fs::path at = folder;; at = at.parent_path()) {
      if (fs::is_regular_file(at / named, none))
        return at / named;
      if (at.filename() == package && fs::is_regular_file(at / inside, none))
        return at / inside;
      if (at == at.parent_path())
        return {};
    }
  }
  const fs::path plain = folder / fs::path(after(written, "file://").value_or(written));
  return fs::is_regular_file(plain, none) ? plain : fs::path();
}

geometry::TriangleMesh readUrdfMesh(const fs::path& path, const UrdfMesh& mesh,
                                    const Eigen::Isometry3d& pose) {
  base::require(mesh.scale.cwiseAbs().minCoeff() > 0.0, "a mesh that is scaled to something");
  geometry::TriangleMesh read = geometry::readMeshOf(path, geometry::ForeignFrame::AsWritten).mesh;
  for (Vector3d& p : read.vertices)
    p = pose * Vector3d(kMmInMetre * mesh.scale.cwiseProduct(p));
  if (mesh.scale.prod() < 0.0) // A mirror image reverses the orientation
    for (std::array<int, 3>& triangle : read.triangles)
      std::swap(triangle[1], triangle[2]);
  return read;
}

} // namespace voluta::robot
