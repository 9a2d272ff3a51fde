#include "robot/urdf/urdf_shapes.h"

#include "base/error.h"
#include "robot/shape/capsule_fit.h"
#include "robot/urdf/urdf_mesh.h"

#include <fmt/format.h>

namespace voluta::robot {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
namespace fs = std::filesystem;

// Radius of a link without any shape, as a share of the arm's length along its joints.
constexpr double kThickness = 0.06;
constexpr int kCapsules = 3; // Maximum per mesh

struct Solids {
  const fs::path& file;
  const std::string& link;
  const Isometry3d& frame_T_link;
  const Vector3d& toNext;
  std::vector<std::string>& assumed;
  Body& body;
  bool& replaced; // Set if a mesh is missing; the link then gets a capsule along it

  void add(const UrdfSolid& solid) const {
    const Isometry3d pose = frame_T_link * solid.link_T_solid;
    if (const auto* box = std::get_if<UrdfBox>(&solid.shape))
      body.shapes.push_back(Box{pose, 0.5 * box->sizeMm});
    else if (const auto* sphere = std::get_if<UrdfSphere>(&solid.shape))
      body.shapes.push_back(Capsule{pose.translation(), pose.translation(), sphere->radiusMm});
    else if (const auto* cylinder = std::get_if<UrdfCylinder>(&solid.shape)) {
      const Vector3d half = 0.5 * cylinder->lengthMm * Vector3d::UnitZ();
      body.shapes.push_back(
          Frustum{pose * -half, pose * half, cylinder->radiusMm, cylinder->radiusMm});
    } else
      addMesh(std::get<UrdfMesh>(solid.shape), pose);
  }

private:
  void addMesh(const UrdfMesh& mesh, const Isometry3d& pose) const {
    const auto leaveOut = [&](const std::string& why) {
      assumed.push_back(
          fmt::format("link '{}' is a capsule along it: its mesh {} {}", link, mesh.file, why));
      replaced = true;
    };
    const fs::path path = meshPath(mesh.file, file);
    if (path.empty())
      return leaveOut("is missing");
    if (mesh.scale.cwiseAbs().minCoeff() == 0.0)
      return leaveOut("has scale 0");
    try {
      const geometry::TriangleMesh read = readUrdfMesh(path, mesh, pose);
      std::vector<Corners> triangles;
      for (std::size_t t = 0; t < read.triangles.size(); ++t)
        triangles.push_back({read.corner(t, 0), read.corner(t, 1), read.corner(t, 2)});
      for (const Capsule& capsule : enclosingCapsules(triangles, toNext, kCapsules))
        body.shapes.push_back(capsule);
    } catch (const base::Error&) {
      leaveOut("cannot be read");
    }
  }
};

// Returns a description of a solid that has no volume; empty: it has one, or is a mesh.
std::string withoutVolume(const UrdfSolid& solid) {
  if (const auto* box = std::get_if<UrdfBox>(&solid.shape))
    return box->sizeMm.minCoeff() > 0.0
               ? ""
               : fmt::format("a box of {:g} x {:g} x {:g} mm", box->sizeMm.x(), box->sizeMm.y(),
                             box->sizeMm.z());
  if (const auto* sphere = std::get_if<UrdfSphere>(&solid.shape))
    return sphere->radiusMm > 0.0 ? ""
                                  : fmt::format("a sphere of radius {:g} mm", sphere->radiusMm);
  if (const auto* cylinder = std::get_if<UrdfCylinder>(&solid.shape))
    return cylinder->radiusMm > 0.0 && cylinder->lengthMm > 0.0
               ? ""
               : fmt::format("a cylinder of radius {:g} mm and length {:g} mm", cylinder->radiusMm,
                             cylinder->lengthMm);
  return "";
}

} // namespace

std::vector<Body> urdfBodies(const UrdfTree& tree, const UrdfChain& chain, const fs::path& file,
                             std::vector<std::string>& assumed) {
  const SerialChain& arm = chain.chain;
  const auto next = [&](std::size_t frame) {
    return frame < arm.joints.size() ? arm.joints[frame].link_T_joint.translation()
                                     : arm.last_T_flange.translation();
  };
  double length = 0.0;
  for (std::size_t frame = 0; frame <= arm.joints.size(); ++frame)
    length += next(frame).norm();

  std::vector<Body> bodies;
  for (std::size_t frame = 0; frame <= arm.joints.size(); ++frame) {
    Body body{{}, BodyRole::Link, static_cast<int>(frame), {}};
    const Vector3d toNext = next(frame);
    bool replaced = false;
    for (const FixedLink& fixed : chain.links) {
      if (fixed.frame != body.frame)
        continue;
      const UrdfLink& link = tree.links[fixed.link];
      if (body.name.empty())
        body.name = link.name;
      const Solids solids{file, link.name, fixed.frame_T_link, toNext, assumed, body, replaced};
      for (const UrdfSolid& solid : link.collision.empty() ? link.visual : link.collision) {
        const std::string flat = withoutVolume(solid);
        if (flat.empty())
          solids.add(solid);
        else
          assumed.push_back(fmt::format("link '{}': {} is left out", link.name, flat));
      }
      for (const std::string& shape : link.unknownShapes)
        assumed.push_back(
            fmt::format("link '{}': a solid of unknown shape '{}' is left out", link.name, shape));
    }
    if (body.shapes.empty() && !replaced)
      assumed.push_back(fmt::format(
          "link '{}' is a capsule along it: the description has no usable solid", body.name));
    if (body.shapes.empty() || replaced)
      body.shapes.push_back(Capsule{Vector3d::Zero(), toNext, std::max(1.0, kThickness * length)});
    bodies.push_back(std::move(body));
  }
  return bodies;
}

} // namespace voluta::robot
