#include "robot/urdf_shapes.h"

#include "base/error.h"
#include "geometry/formats/foreign_reader.h"
#include "geometry/formats/mesh_reader.h"
#include "robot/capsule_fit.h"

#include <fmt/format.h>

namespace voluta::robot {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
namespace fs = std::filesystem;

constexpr double kMmInMetre = 1000.0;
// Of the arm's length along its joints: how thick a link is that nothing is known of.
constexpr double kThickness = 0.06;
constexpr int kCapsules = 3; // a mesh at most

std::optional<std::string_view> after(std::string_view text, std::string_view prefix) {
  if (!text.starts_with(prefix))
    return std::nullopt;
  return text.substr(prefix.size());
}

struct Solids {
  const fs::path& file;
  const std::string& link;
  const Isometry3d& frame_T_link;
  const Vector3d& toNext;
  std::vector<std::string>& assumed;
  Body& body;
  bool& replaced; // by the capsule along the link, which one mesh less is enough for

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
      return leaveOut("is not there");
    if (mesh.scale.cwiseAbs().minCoeff() == 0.0)
      return leaveOut("is scaled to nothing");
    try {
      const geometry::TriangleMesh read =
          geometry::isForeign(path)
              ? geometry::readForeign(path, geometry::ForeignFrame::AsWritten).mesh
              : geometry::readMesh(path).mesh;
      std::vector<Corners> triangles;
      for (const std::array<int, 3>& triangle : read.triangles) {
        Corners& corners = triangles.emplace_back();
        for (std::size_t k = 0; k < 3; ++k)
          corners[k] = pose * Vector3d(kMmInMetre *
                                       mesh.scale.cwiseProduct(
                                           read.vertices[static_cast<std::size_t>(triangle[k])]));
      }
      for (const Capsule& capsule : enclosingCapsules(triangles, toNext, kCapsules))
        body.shapes.push_back(capsule);
    } catch (const base::Error&) {
      leaveOut("cannot be read");
    }
  }
};

bool hasSize(const UrdfSolid& solid) {
  if (const auto* box = std::get_if<UrdfBox>(&solid.shape))
    return box->sizeMm.minCoeff() > 0.0;
  if (const auto* sphere = std::get_if<UrdfSphere>(&solid.shape))
    return sphere->radiusMm > 0.0;
  if (const auto* cylinder = std::get_if<UrdfCylinder>(&solid.shape))
    return cylinder->radiusMm > 0.0 && cylinder->lengthMm > 0.0;
  return true;
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
      for (const UrdfSolid& solid : link.collision.empty() ? link.visual : link.collision)
        if (hasSize(solid))
          solids.add(solid);
    }
    if (body.shapes.empty() && !replaced)
      assumed.push_back(
          fmt::format("link '{}' is a capsule along it: the description has no solid", body.name));
    if (body.shapes.empty() || replaced)
      body.shapes.push_back(Capsule{Vector3d::Zero(), toNext, std::max(1.0, kThickness * length)});
    bodies.push_back(std::move(body));
  }
  return bodies;
}

} // namespace voluta::robot
