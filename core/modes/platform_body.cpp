#include "modes/platform_body.h"

#include "base/error.h"
#include "geometry/measures.h"
#include "geometry/repair/repair.h"
#include "project/loaded_part.h"

namespace voluta::modes {

std::shared_ptr<const geometry::TriangleMesh> platformBody(const project::Platform& platform,
                                                           const base::RunContext& ctx) {
  if (!platform.isBody())
    return nullptr;
  const std::shared_ptr<const project::LoadedPart> loaded =
      project::loadPart(platform.file(), true, ctx);
  const auto fail = [&](const base::Message& what, const base::Message& remedy) {
    throw base::Error(base::ErrorCode::UnusableInput, what, platform.file(), remedy);
  };
  if (loaded->cells)
    fail("a platform must be a mesh, not a voxel object"_text,
         "give an STL, OBJ, PLY, OFF or 3MF file"_text);
  const std::shared_ptr<const geometry::TriangleMesh> mesh =
      loaded->open
          ? std::make_shared<geometry::TriangleMesh>(project::closedPart(*loaded, ctx).mesh)
          : loaded->mesh;
  if (!geometry::isWatertight(*mesh))
    fail("the platform's mesh is not closed"_text, "repair it in a modelling program"_text);
  return mesh;
}

Eigen::Isometry3d motionOf(const geometry::TriangleMesh& mesh, double scale,
                           const geometry::Placement& placement) {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() = placement.rotation.normalized().toRotationMatrix();
  Eigen::AlignedBox3d box;
  for (const auto& triangle : mesh.triangles)
    for (int v : triangle)
      box.extend(scale * (motion.linear() * mesh.vertices[static_cast<std::size_t>(v)]));
  motion.translation() =
      Eigen::Vector3d(placement.centreMm.x(), placement.centreMm.y(), placement.liftMm) -
      Eigen::Vector3d(box.center().x(), box.center().y(), box.min().z());
  return motion;
}

geometry::Placement placementBy(const geometry::TriangleMesh& mesh, double scale,
                                const Eigen::Isometry3d& motion) {
  const Eigen::AlignedBox3d box = geometry::bounds(moved(mesh, scale, motion));
  geometry::Placement placement;
  if (!motion.linear().isIdentity(0.0))
    placement.rotation = Eigen::Quaterniond(motion.linear());
  placement.centreMm = box.center().head<2>();
  placement.liftMm = box.min().z();
  return placement;
}

geometry::TriangleMesh moved(const geometry::TriangleMesh& mesh, double scale,
                             const Eigen::Isometry3d& motion) {
  geometry::TriangleMesh out = mesh;
  for (Eigen::Vector3d& v : out.vertices)
    v = motion * Eigen::Vector3d(scale * v);
  return out;
}

} // namespace voluta::modes
