#include "replay/replay_ground.h"

#include "base/units.h"
#include "replay/bead_coverage.h"
#include "replay/distances.h"

#include <algorithm>
#include <cmath>

namespace voluta::replay {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kOnMm = 1e-6; // a point this far above a surface is on it
constexpr std::size_t kMaxCells = 8'000'000;

struct Bounds {
  Vector3d low, high;
};
Bounds boundsOf(const geometry::TriangleMesh& mesh) {
  Bounds b{mesh.vertices.front(), mesh.vertices.front()};
  for (const Vector3d& v : mesh.vertices) {
    b.low = b.low.cwiseMin(v);
    b.high = b.high.cwiseMax(v);
  }
  return b;
}
voxel::VoxelGrid gridRound(const geometry::TriangleMesh& mesh, double pitchMm) {
  const Bounds b = boundsOf(mesh);
  return gridOver(b.low, b.high, pitchMm, kMaxCells);
}

// Returns the vertices of a prism's cross-section, in the plane perpendicular to x.
std::vector<Vector2d> sectionOfRod(double radius, int sides) {
  std::vector<Vector2d> corners;
  for (int k = 0; k < sides; ++k) {
    const double a = 2.0 * base::kPi * k / sides;
    corners.emplace_back(radius * std::cos(a), radius * std::sin(a));
  }
  return corners;
}

// Returns the section of a rod between two points of its profile.
robot::Shape solidOf(const platform::RodShape& rod, const Vector2d& a, const Vector2d& b) {
  if (rod.sides > 0 && a.y() == b.y())
    return robot::Prism{sectionOfRod(a.y(), rod.sides), a.x(), b.x()};
  const double within = rod.sides > 0 ? std::cos(base::kPi / rod.sides) : 1.0;
  return robot::Frustum{{0, 0, a.x()}, {0, 0, b.x()}, within * a.y(), within * b.y()};
}

// Returns a frame whose z is the rod's axis and whose x is at angle 0.
Isometry3d rodFrame() {
  Isometry3d frame = Isometry3d::Identity();
  frame.linear() << Vector3d::UnitY(), Vector3d::UnitZ(), Vector3d::UnitX();
  return frame;
}

} // namespace

GroundCells::GroundCells(const geometry::TriangleMesh& mesh, double pitchMm,
                         const base::RunContext& ctx) {
  cells_.grid = gridRound(mesh, pitchMm);
  const PartCells inside = partCells(mesh, geometry::MeshQuery(mesh), cells_.grid, ctx);
  cells_.filler = base::ZeroedArray<std::uint32_t>(inside.share.size());
  for (std::size_t c = 0; c < inside.share.size(); ++c)
    if (inside.share[c] > 127)
      cells_.filler[c] = 1;
  // A run number that no bead has, so that none of the body counts as soft.
  piece_.emplace_back().run = kNeverFilled - 1;
  part_.emplace(cells_, piece_);
}

GroundProbe::GroundProbe(const platform::PlatformSolid& platform,
                         std::span<const InsertedBody> inserted)
    : platform_(platform) {
  if (platform.mesh)
    body_.emplace(*platform.mesh);
  for (const InsertedBody& one : inserted) {
    const Bounds bounds = boundsOf(*one.body);
    inserted_.push_back(
        {geometry::MeshQuery(*one.body), {bounds.low, bounds.high}, one.firstPiece});
  }
}

bool GroundProbe::onPlate(const Vector3d& point, double slackMm) const {
  const std::vector<Vector2d>& plate = platform_.polygon;
  if (plate.empty() || point.z() > kOnMm)
    return false;
  for (std::size_t i = 0; i < plate.size(); ++i) {
    const Vector2d &a = plate[i], &b = plate[(i + 1) % plate.size()];
    const Vector2d edge = b - a, r = point.head<2>() - a;
    if (edge.x() * r.y() - edge.y() * r.x() < -slackMm * edge.norm())
      return false;
  }
  return true;
}

bool GroundProbe::inRod(const Vector3d& point, double slackMm) const {
  if (!platform_.rod)
    return false;
  const platform::RodShape& rod = *platform_.rod;
  double along = point.tail<2>().norm();
  if (rod.sides > 0) {
    // Scales the distance so that a side compares like a corner with the corners' radius.
    const double sector = 2.0 * base::kPi / rod.sides;
    const double angle = std::atan2(point.z(), point.y());
    const double inSector = angle - sector * std::floor(angle / sector);
    along *= std::cos(inSector - 0.5 * sector) / std::cos(0.5 * sector);
  }
  const auto& profile = rod.profile;
  const double x = std::clamp(point.x(), profile.front().x(), profile.back().x());
  if (std::abs(point.x() - x) > slackMm)
    return false;
  for (std::size_t k = 1; k < profile.size(); ++k) {
    const Vector2d &a = profile[k - 1], &b = profile[k];
    if (x < a.x() || x > b.x() || b.x() <= a.x())
      continue;
    if (along <= a.y() + (x - a.x()) / (b.x() - a.x()) * (b.y() - a.y()) + kOnMm)
      return true;
  }
  return false;
}

bool GroundProbe::holds(const Vector3d& point, double slackMm, std::uint32_t before) const {
  return onPlate(point, slackMm) || inRod(point, slackMm) || (body_ && body_->inside(point)) ||
         std::ranges::any_of(inserted_, [&](const Inserted& one) {
           return one.firstPiece <= before && one.box.contains(point) && one.body.inside(point);
         });
}

GroundSolids::GroundSolids(const platform::PlatformSolid& platform, const robot::Cell& cell,
                           double pitchMm, const base::RunContext& ctx,
                           std::span<const InsertedBody> inserted)
    : rod_(platform.rod.has_value()) {
  if (rod_) {
    const auto& profile = platform.rod->profile;
    for (std::size_t k = 1; k < profile.size(); ++k) {
      const Vector2d &a = profile[k - 1], &b = profile[k];
      reachMm_ = std::max({reachMm_, a.y(), b.y()});
      if (b.x() - a.x() > kOnMm)
        solids_.emplace_back(rodFrame(), solidOf(*platform.rod, a, b));
    }
  } else {
    for (const robot::Body& body : cell.bodies()) {
      if (body.role != robot::BodyRole::Platform || body.frame != cell.workFrame())
        continue;
      for (const robot::Shape& shape : body.shapes) {
        solids_.emplace_back(Isometry3d::Identity(), shape);
        const auto* prism = std::get_if<robot::Prism>(&shape);
        const Ball ball = ballRound(shape);
        reachMm_ = std::max(reachMm_, prism ? prism->zMax : ball.centre.z() + ball.radius);
      }
    }
  }
  if (platform.mesh && !platform.mesh->empty())
    bodies_.push_back({std::make_unique<const GroundCells>(*platform.mesh, pitchMm, ctx), 0, true});
  for (const InsertedBody& one : inserted)
    bodies_.push_back(
        {std::make_unique<const GroundCells>(*one.body, pitchMm, ctx), one.firstPiece, false});
}

Vector3d GroundSolids::outward(const Vector3d& direction) const {
  if (!rod_)
    return Vector3d::UnitZ();
  const Vector3d across(0.0, direction.y(), direction.z());
  return across.norm() > kOnMm ? Vector3d(across.normalized()) : Vector3d::UnitZ();
}

} // namespace voluta::replay
