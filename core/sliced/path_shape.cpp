#include "sliced/path_shape.h"

#include "base/error.h"
#include "base/run_context.h"
#include "base/units.h"
#include "build3mf/bead_cells.h"
#include "geometry/measures.h"
#include "process/bead_model.h"
#include "sliced/ground_body.h"
#include "sliced/layer_solid.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace voluta::sliced {

namespace {
using Eigen::Vector2d, Eigen::Vector3d;

constexpr double kChordMm = 0.01;
constexpr double kMaxAngle = 0.499 * base::kPi; // From the top of the ground
constexpr double kMinLeftMm = 2.0;              // Radius left inside a hollow ground

double areaOf(const plan::ToolPlan& plan, std::size_t i) {
  return process::beadArea(plan.widthMm[i], plan.heightMm[i]);
}

// Changes the section's area and keeps its height, unless the bead would be thinner than round.
void setArea(plan::ToolPlan& plan, std::size_t i, double areaMm2) {
  const double round = std::sqrt(areaMm2 / (base::kPi / 4.0));
  const double height = std::min(static_cast<double>(plan.heightMm[i]), round);
  plan.heightMm[i] = static_cast<float>(height);
  plan.widthMm[i] =
      static_cast<float>(height < round ? process::widthOfArea(areaMm2, height) : round);
}

bool hasSection(const plan::ToolPlan& plan, std::size_t i) {
  return plan.widthMm[i] > 0.0f && plan.heightMm[i] > 0.0f;
}

// Returns the turn of each layer, by its top.
std::map<int, double> turnsOf(const plan::ToolPlan& plan, const PathShape& shape) {
  std::map<int, double> tops;
  for (const plan::ToolPath& path : plan.paths)
    for (std::size_t i = path.first; i < path.first + path.count; ++i) {
      const auto [at, isNew] = tops.emplace(path.layer, plan.position[i].z());
      at->second = std::max(at->second, plan.position[i].z());
    }
  std::map<int, double> turns;
  double rotation = 0.0;
  for (const auto& [layer, top] : tops) {
    if (!turns.empty()) {
      constexpr double kRounding = 1e-6;
      const bool back =
          shape.reverseMm > 0.0 &&
          static_cast<long long>(std::floor((top - kRounding) / shape.reverseMm)) % 2 != 0;
      rotation += (back ? -1.0 : 1.0) * shape.rotationPerLayerRad;
    }
    turns[layer] = rotation;
  }
  return turns;
}

void rotateLayers(plan::ToolPlan& plan, const PathShape& shape) {
  const std::map<int, double> turns = turnsOf(plan, shape);
  for (const plan::ToolPath& path : plan.paths) {
    const Eigen::Matrix3d rotation =
        Eigen::AngleAxisd(turns.at(path.layer), Vector3d::UnitZ()).toRotationMatrix();
    for (std::size_t i = path.first; i < path.first + path.count; ++i) {
      plan.position[i] = rotation * plan.position[i];
      plan.direction[i] = rotation * plan.direction[i];
    }
  }
}

// Divides segments longer than `maxMm`.
plan::ToolPlan divided(const plan::ToolPlan& given, double maxMm) {
  plan::ToolPlan plan;
  plan.fill = given.fill;
  const auto add = [&](std::size_t a, std::size_t b, double t) {
    const auto at = [&](const std::vector<float>& v) {
      return static_cast<float>((1.0 - t) * v[a] + t * v[b]);
    };
    plan.position.push_back(given.position[a] + t * (given.position[b] - given.position[a]));
    const Vector3d direction = (1.0 - t) * given.direction[a] + t * given.direction[b];
    plan.direction.push_back(direction.norm() > 1e-6 ? Vector3d(direction.normalized())
                                                     : given.direction[b]);
    plan.widthMm.push_back(at(given.widthMm));
    plan.heightMm.push_back(at(given.heightMm));
    plan.speedMmPerS.push_back(given.speedMmPerS[b]);
  };
  for (const plan::ToolPath& path : given.paths) {
    plan::ToolPath mine = path;
    mine.first = plan.waypointCount();
    add(path.first, path.first, 0.0);
    for (std::size_t i = path.first + 1; i < path.first + path.count; ++i) {
      const double length = (given.position[i] - given.position[i - 1]).norm();
      const auto pieces = static_cast<int>(std::max(1.0, std::ceil(length / maxMm)));
      for (int k = 1; k <= pieces; ++k)
        add(i - 1, i, static_cast<double>(k) / pieces);
    }
    mine.count = plan.waypointCount() - mine.first;
    plan.paths.push_back(mine);
  }
  return plan;
}

void requireRoom(const plan::ToolPlan& plan, const CurvedGround& ground) {
  double angle = 0.0, top = 0.0;
  for (const Vector3d& p : plan.position) {
    angle = std::max(angle, ground.angleAt(p));
    top = std::max(top, p.z());
  }
  if (ground.radiusMm < 0.0 && top > -ground.radiusMm - kMinLeftMm)
    throw base::Error(base::ErrorCode::UnusableInput,
                      base::message("the part is {height:.1f} high, too high for the inside of a "
                                    "radius of {radius:.1f}"_text,
                                    base::mm(top), base::mm(-ground.radiusMm)),
                      {}, "give a larger `pathsRadiusMm`"_text);
  if (angle > kMaxAngle)
    throw base::Error(
        base::ErrorCode::UnusableInput,
        base::message("the part reaches {angle:.0f} round the ground, more than 90"_text,
                      base::degrees(base::radiansToDegrees(angle))),
        {}, "give a larger `pathsRadiusMm`, or turn the part by 90 degrees"_text);
}

// Maps a path. The area at a waypoint is the mean of those of the segments beside it, weighted
// with their lengths.
void bendPath(plan::ToolPlan& plan, const plan::ToolPath& path, const CurvedGround& ground) {
  const std::size_t end = path.first + path.count;
  std::vector<CurvedGround::Mapped> mapped;
  for (std::size_t i = path.first; i < end; ++i)
    mapped.push_back(ground.map(plan.position[i]));
  std::vector<double> factor(path.count, 1.0);
  double before = 0.0, lengthBefore = 0.0;
  for (std::size_t k = 0; k < path.count; ++k) {
    double after = before, lengthAfter = lengthBefore;
    if (k + 1 < path.count) {
      const Vector3d& a = plan.position[path.first + k];
      const Vector3d& b = plan.position[path.first + k + 1];
      const Vector2d step = (b - a).head<2>();
      lengthAfter = (mapped[k + 1].position - mapped[k].position).norm();
      after = step.norm() > 1e-9
                  ? 0.5 * (hatchFactor(mapped[k], step) + hatchFactor(mapped[k + 1], step))
                  : 1.0;
    }
    if (k == 0)
      before = after, lengthBefore = lengthAfter;
    const double all = lengthBefore + lengthAfter;
    factor[k] = all > 0.0 ? (lengthBefore * before + lengthAfter * after) / all : after;
    before = after, lengthBefore = lengthAfter;
  }
  constexpr double kSame = 1e-9;
  for (std::size_t k = 0; k < path.count; ++k) {
    const std::size_t i = path.first + k;
    plan.position[i] = mapped[k].position;
    plan.direction[i] = mapped[k].rotation * plan.direction[i];
    if (hasSection(plan, i) && std::abs(factor[k] - 1.0) > kSame)
      setArea(plan, i, factor[k] * areaOf(plan, i));
  }
}

void move(plan::ToolPlan& plan, geometry::TriangleMesh& solid, const Eigen::Isometry3d& motion) {
  for (Vector3d& p : plan.position)
    p = motion * p;
  for (Vector3d& d : plan.direction)
    d = motion.linear() * d;
  for (Vector3d& v : solid.vertices)
    v = motion * v;
}

// Makes the solid anew from its beads.
void remake(ShapedPaths& made, const base::RunContext& ctx) {
  if (isLevel(made.plan)) {
    LayerSolid solid = solidOfLayers(made.plan, 0.0, ctx);
    made.solid = std::move(solid.mesh);
    made.plan.fill.clear();
    if (!std::isinf(solid.fill.shellMm))
      made.plan.fill = {solid.fill};
    return;
  }
  constexpr double kCellMm = 0.25;
  made.solid = build3mf::solidOfBeads(made.plan, kCellMm, ctx);
}
} // namespace

bool PathShape::changesNothing() const {
  return amountFactor == 1.0 && rotationPerLayerRad == 0.0 && ground.shape == GroundShape::Plate &&
         frame.matrix().isIdentity(0.0);
}

ShapedPaths shaped(const plan::ToolPlan& plan, const geometry::TriangleMesh& solid,
                   const PathShape& shape, const base::RunContext& ctx) {
  base::require(shape.amountFactor > 0.0 && shape.ground.radiusMm != 0.0,
                "an amount > 0 and a radius");
  ShapedPaths made{plan, solid, std::nullopt};
  const Eigen::AlignedBox3d box = geometry::bounds(solid);
  Eigen::Isometry3d toMiddle = Eigen::Isometry3d::Identity();
  toMiddle.translation() = -Vector3d(box.center().x(), box.center().y(), box.min().z());
  move(made.plan, made.solid, toMiddle);
  if (shape.amountFactor != 1.0)
    for (std::size_t i = 0; i < made.plan.waypointCount(); ++i)
      if (hasSection(made.plan, i))
        setArea(made.plan, i, shape.amountFactor * areaOf(made.plan, i));
  if (shape.rotationPerLayerRad != 0.0)
    rotateLayers(made.plan, shape);
  if (shape.amountFactor != 1.0 || shape.rotationPerLayerRad != 0.0)
    remake(made, ctx.sub(0.0, 0.8));
  ctx.checkpoint();
  Eigen::AlignedBox3d extent = geometry::bounds(made.solid); // Skirts included
  for (const Vector3d& p : made.plan.position)
    extent.extend(p);
  if (shape.ground.isCurved()) {
    requireRoom(made.plan, shape.ground);
    made.plan = divided(made.plan, std::sqrt(8.0 * kChordMm * std::abs(shape.ground.radiusMm)));
    for (const plan::ToolPath& path : made.plan.paths)
      bendPath(made.plan, path, shape.ground);
  }
  if (shape.ground.shape != GroundShape::Plate)
    made.ground = groundBody(shape.ground, extent);
  if (shape.ground.isCurved())
    for (Vector3d& v : made.solid.vertices)
      v = shape.ground.map(v).position;
  // What sparse infill leaves open grows with the part.
  if (shape.ground.isCurved() && !made.plan.fill.empty())
    made.plan.fill.front().openMm3 =
        std::max(0.0, geometry::volume(made.solid) - partBeadsMm3(made.plan));
  if (!shape.frame.matrix().isIdentity(0.0)) {
    move(made.plan, made.solid, shape.frame);
    if (made.ground)
      for (Vector3d& v : made.ground->vertices)
        v = shape.frame * v;
  }
  return made;
}

} // namespace voluta::sliced
