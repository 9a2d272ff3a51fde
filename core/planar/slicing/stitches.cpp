#include "planar/slicing/stitches.h"

#include "base/units.h"
#include "geometry/append_mesh.h"
#include "geometry/measures.h"
#include "geometry/mesh_query.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace voluta::planar {

using Eigen::Vector3d;

namespace {

// A pocket's outline from its bottom to its top: heights and radii in diameters.
struct Corner {
  double height, radius;
};
constexpr std::array<Corner, 4> kDovetail{{{0.0, 0.5}, {0.25, 0.5}, {0.5, 0.25}, {0.75, 0.25}}};
constexpr std::array<Corner, 2> kCone{{{0.0, 0.5}, {0.5, 0.25}}};

std::span<const Corner> outlineOf(PocketShape shape) {
  if (shape == PocketShape::Cone)
    return kCone;
  return kDovetail;
}

constexpr int kSides = 96;    // inscribed: 0.07 % less than the round section
constexpr int kAzimuths = 24; // at which the material around a pocket is probed

Vector3d around(double radius, int k, int of) {
  const double angle = base::kTwoPi * k / of;
  return {radius * std::cos(angle), radius * std::sin(angle), 0.0};
}

double diameterOf(const layers::Pocket& pocket, PocketShape shape) {
  return pocket.depthMm / outlineOf(shape).back().height;
}

class Placer {
public:
  Placer(const Piece& piece, const std::vector<double>& bounds, const StitchRule& rule)
      : rule_(rule), bounds_(bounds), query_(piece.solid.mesh),
        box_(geometry::bounds(piece.solid.mesh)) {}

  std::vector<layers::Pocket> place() {
    const auto every = static_cast<std::size_t>(std::max(1, rule_.everyLayers));
    for (std::size_t k = every; k + 1 < bounds_.size(); k += every)
      placeAt(k, (k / every) % 2 == 0 ? 0.5 : 0.0);
    return std::move(pockets_);
  }

private:
  void placeAt(std::size_t bound, double shift) {
    const Vector3d middle = box_.center(), half = 0.5 * box_.sizes();
    const int across = static_cast<int>(half.x() / rule_.spacingMm) + 1,
              along = static_cast<int>(half.y() / rule_.spacingMm) + 1;
    for (int j = -along; j <= along; ++j)
      for (int i = -across; i <= across; ++i) {
        const Vector3d top(middle.x() + (i + shift) * rule_.spacingMm,
                           middle.y() + (j + shift) * rule_.spacingMm, bounds_[bound]);
        layers::Pocket pocket = pocketAt(top, rule_.diameterMm, rule_.shape);
        pocket.layer = static_cast<int>(bound) - 1;
        if (isInside(pocket, bound) && isApart(pocket))
          pockets_.push_back(pocket);
      }
  }

  bool isInside(const layers::Pocket& pocket, std::size_t bound) const {
    constexpr int kLevels = 6;
    const Vector3d bottom = pocket.top - pocket.depthMm * Vector3d::UnitZ();
    const double floor = bottom.z() - (bounds_[1] - bounds_[0]),
                 roof = 0.5 * (bounds_[bound] + bounds_[bound + 1]);
    if (floor <= 0.0)
      return false;
    const auto isSolid = [&](double z, double radius) {
      if (!query_.inside({pocket.top.x(), pocket.top.y(), z}))
        return false;
      for (int k = 0; k < kAzimuths; ++k)
        if (!query_.inside(Vector3d(pocket.top.x(), pocket.top.y(), z) +
                           around(radius, k, kAzimuths)))
          return false;
      return true;
    };
    if (!isSolid(floor, pocketRadius(pocket, 0.0, rule_.shape)) ||
        !isSolid(roof, 0.5 * pocket.openingMm))
      return false;
    for (int l = 0; l < kLevels; ++l) {
      const double height = pocket.depthMm * (l + 0.5) / kLevels;
      if (!isSolid(bottom.z() + height, pocketRadius(pocket, height, rule_.shape) + rule_.marginMm))
        return false;
    }
    return true;
  }

  bool isApart(const layers::Pocket& pocket) const {
    const double apart = rule_.diameterMm + rule_.marginMm;
    return std::ranges::none_of(pockets_, [&](const layers::Pocket& other) {
      const Vector3d step = pocket.top - other.top;
      return step.z() < pocket.depthMm + rule_.marginMm && step.head<2>().norm() < apart;
    });
  }

  const StitchRule& rule_;
  const std::vector<double>& bounds_;
  geometry::MeshQuery query_;
  Eigen::AlignedBox3d box_;
  std::vector<layers::Pocket> pockets_;
};

geometry::TriangleMesh surfaceOf(const layers::Pocket& pocket, PocketShape shape) {
  const double d = diameterOf(pocket, shape);
  const std::span<const Corner> outline = outlineOf(shape);
  const Vector3d bottom = pocket.top - pocket.depthMm * Vector3d::UnitZ();
  geometry::TriangleMesh mesh;
  for (const auto& [height, radius] : outline)
    for (int k = 0; k < kSides; ++k)
      mesh.vertices.push_back(bottom + around(radius * d, k, kSides) +
                              height * d * Vector3d::UnitZ());
  const auto rings = static_cast<int>(outline.size());
  for (int ring = 0; ring + 1 < rings; ++ring)
    for (int k = 0; k < kSides; ++k) {
      const int a = ring * kSides + k, b = ring * kSides + (k + 1) % kSides;
      mesh.triangles.push_back({a, b + kSides, b});
      mesh.triangles.push_back({a, a + kSides, b + kSides});
    }
  const int low = static_cast<int>(mesh.vertices.size()), high = low + 1,
            last = (rings - 1) * kSides;
  mesh.vertices.push_back(bottom);
  mesh.vertices.push_back(pocket.top);
  for (int k = 0; k < kSides; ++k) {
    const int next = (k + 1) % kSides;
    mesh.triangles.push_back({low, k, next});
    mesh.triangles.push_back({high, last + next, last + k});
  }
  return mesh;
}

} // namespace

layers::Pocket pocketAt(const Vector3d& top, double diameterMm, PocketShape shape) {
  const std::span<const Corner> outline = outlineOf(shape);
  layers::Pocket pocket;
  pocket.top = top;
  pocket.depthMm = outline.back().height * diameterMm;
  pocket.openingMm = 2.0 * outline.back().radius * diameterMm;
  double share = 0.0; // of the diameter's cube: the sum of frusta
  for (std::size_t i = 1; i < outline.size(); ++i) {
    const double a = outline[i - 1].radius, b = outline[i].radius;
    share +=
        base::kPi * (outline[i].height - outline[i - 1].height) * (a * a + a * b + b * b) / 3.0;
  }
  pocket.volumeMm3 = share * std::pow(diameterMm, 3);
  return pocket;
}

double pocketRadius(const layers::Pocket& pocket, double heightMm, PocketShape shape) {
  const double d = diameterOf(pocket, shape), at = heightMm / d;
  const std::span<const Corner> outline = outlineOf(shape);
  for (std::size_t i = 1; i < outline.size(); ++i) {
    const Corner &low = outline[i - 1], &high = outline[i];
    if (at <= high.height)
      return d * (low.radius + std::max(0.0, at - low.height) / (high.height - low.height) *
                                   (high.radius - low.radius));
  }
  return d * outline.back().radius;
}

std::vector<layers::Pocket> placePockets(const Piece& piece, const std::vector<double>& bounds,
                                         const StitchRule& rule) {
  if (!rule.makesPockets() || bounds.size() < 3)
    return {};
  return Placer(piece, bounds, rule).place();
}

geometry::TriangleMesh pocketSurfaces(const std::vector<layers::Pocket>& pockets,
                                      PocketShape shape) {
  geometry::TriangleMesh all;
  for (const layers::Pocket& pocket : pockets)
    geometry::appendMesh(all, surfaceOf(pocket, shape));
  return all;
}

void assignLayers(std::vector<layers::Pocket>& pockets, const layers::LayerStack& stack) {
  constexpr double kSameMm = 0.01;
  std::erase_if(pockets, [&](layers::Pocket& pocket) {
    const auto at = std::ranges::find_if(stack.patches, [&](const layers::Patch& patch) {
      return patch.group != layers::kSupportGroup &&
             std::abs(patch.surface.vertices.front().z() + 0.5 * patch.thicknessMm.front() -
                      pocket.top.z()) < kSameMm;
    });
    if (at == stack.patches.end())
      return true;
    pocket.layer = at->layer;
    return false;
  });
}

} // namespace voluta::planar
