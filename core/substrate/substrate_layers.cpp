#include "substrate/substrate_layers.h"

#include "base/error.h"
#include "geometry/least_squares.h"
#include "geometry/measures.h"
#include "geometry/mesh_query.h"
#include "geometry/subtract.h"
#include "substrate/blend_levels.h"
#include "substrate/flatten.h"
#include "substrate/levels.h"
#include "substrate/touch_fit.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string>
#include <utility>
#include <vector>

namespace voluta::substrate {

namespace {

using Eigen::Vector2d, Eigen::Vector3d;

constexpr double kTouchMm = 1e-3; // Points this near to the ground rest on it
constexpr double kRoundMm = 0.02; // Tolerance of a round ground

[[noreturn]] void refuse(const base::Message& what, const base::Message& remedy) {
  throw base::Error(base::ErrorCode::UnusableInput, what, "surface"_text, remedy);
}

// Returns the vertices of the part on its ground.
std::vector<Vector3d> footOf(const geometry::TriangleMesh& part, const GroundDistance& ground) {
  std::vector<Vector3d> foot;
  for (const Vector3d& p : part.vertices)
    if (ground.unsignedMm(p) <= kTouchMm)
      foot.push_back(p);
  return foot;
}

// Returns the cylinder along x, with its round side up, on which the part rests; nullopt if there
// is none.
std::optional<CircleFit> cylinderUnder(const std::vector<Vector3d>& foot) {
  std::vector<Vector2d> section;
  double height = 0.0; // Mean
  for (const Vector3d& p : foot) {
    section.emplace_back(p.tail<2>());
    height += p.z() / static_cast<double>(foot.size());
  }
  try {
    const CircleFit fit = circleThrough(section);
    return fit.rmsMm <= kRoundMm && height > fit.centre.y() ? std::optional(fit) : std::nullopt;
  } catch (const base::Error&) {
    return std::nullopt; // Flat
  }
}

// Least squares of |p|^2 = 2 c . p + k.
std::optional<Vector3d> ballUnder(const std::vector<Vector3d>& foot) {
  if (foot.size() < 4)
    return std::nullopt;
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& p : foot)
    mean += p / static_cast<double>(foot.size());
  Eigen::MatrixX4d rows(static_cast<Eigen::Index>(foot.size()), 4);
  Eigen::VectorXd right(rows.rows());
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const Vector3d p = foot[static_cast<std::size_t>(i)] - mean;
    rows.row(i) << 2.0 * p.transpose(), 1.0;
    right[i] = p.squaredNorm();
  }
  const geometry::LeastSquares solved = geometry::leastSquares(rows, right);
  if (solved.rank < 4)
    return std::nullopt; // Flat
  const Eigen::Vector4d fit = solved.x;
  const Vector3d centre = mean + fit.head<3>();
  const double radius = std::sqrt(std::max(0.0, fit[3] + fit.head<3>().squaredNorm()));
  for (const Vector3d& p : foot)
    if (std::abs((p - centre).norm() - radius) > kRoundMm)
      return std::nullopt;
  return centre;
}

Vector3d centreBelow(const geometry::TriangleMesh& part) {
  const Eigen::AlignedBox3d box = geometry::bounds(part);
  return {box.center().x(), box.center().y(), box.min().z() - 0.5 * box.sizes().z()};
}

struct Reach {
  double from = 0.0, to = 0.0;
};

// Adds levels at equal steps of the height; `between` makes one of them.
template <typename Between>
void addLevels(LevelFamily& family, const Reach& reach, const SubstrateOptions& o,
               Between between) {
  if (reach.to - reach.from < o.heightMinMm)
    refuse(base::message("the part rises {height:.3g} mm above the surface, less than a layer "
                         "of {least:.3g} mm"_text,
                         base::number(std::max(0.0, reach.to - reach.from)),
                         base::number(o.heightMinMm)),
           "print the part larger, or with a finer process"_text);
  const std::vector<double> bounds = levelBounds(reach.from, reach.to, o);
  family.count = static_cast<int>(bounds.size()) - 1;
  family.level = [bounds, between](int k, const base::RunContext& ctx) {
    const double inner = bounds[static_cast<std::size_t>(k)],
                 outer = bounds[static_cast<std::size_t>(k) + 1];
    return between(0.5 * (inner + outer), outer - inner, ctx);
  };
}

template <typename Height>
double farthest(const geometry::TriangleMesh& part, const Height& height) {
  double maximum = 0.0;
  for (const Vector3d& p : part.vertices)
    maximum = std::max(maximum, height(p));
  return maximum;
}

void addOffsets(LevelFamily& family, const geometry::TriangleMesh& part,
                const GroundDistance& ground, const SubstrateOptions& o,
                const Eigen::AlignedBox3d& box) {
  const double maximum = farthest(part, [&](const Vector3d& p) { return ground.signedMm(p); });
  addLevels(family, {0.0, maximum}, o,
            [offsets = OffsetLevels(ground, box, offsetGridMm(o))](double middle, double thickness,
                                                                   const base::RunContext& ctx) {
              return offsets.at(middle, thickness, ctx);
            });
}

void addSpheres(LevelFamily& family, const geometry::TriangleMesh& part,
                const GroundDistance& ground, const SubstrateOptions& o,
                const Eigen::AlignedBox3d& box) {
  Vector3d centre = o.centre ? *o.centre : centreBelow(part);
  if (!o.centre)
    if (const auto ball = ballUnder(footOf(part, ground)))
      centre = *ball;
  const geometry::MeshQuery query(part);
  const Reach reach{query.inside(centre) ? 0.0 : query.closest(centre).distance,
                    farthest(part, [&](const Vector3d& p) { return (p - centre).norm(); })};
  family.outward = [centre](const Vector3d& p) -> Vector3d { return (p - centre).normalized(); };
  addLevels(family, reach, o,
            [centre, box, edge = levelEdgeMm(o)](double middle, double thickness,
                                                 const base::RunContext&) {
              return sphereLevel(centre, middle, thickness, box, edge);
            });
}

void addCylinders(LevelFamily& family, const geometry::TriangleMesh& part,
                  const GroundDistance& ground, const SubstrateOptions& o,
                  const Eigen::AlignedBox3d& box) {
  Vector3d centre = o.centre ? *o.centre : centreBelow(part);
  if (!o.centre)
    if (const auto fit = cylinderUnder(footOf(part, ground)))
      centre.tail<2>() = fit->centre;
  centre.x() = 0.0;
  const auto radius = [centre](const Vector3d& p) { return (p - centre).tail<2>().norm(); };
  geometry::TriangleMesh section = part; // Projected along the axis
  for (Vector3d& p : section.vertices)
    p.x() = 0.0;
  const Reach reach{geometry::MeshQuery(section).closest(centre).distance, farthest(part, radius)};
  family.outward = [centre](const Vector3d& p) -> Vector3d {
    const Vector3d out = p - centre;
    return Vector3d(0.0, out.y(), out.z()).normalized();
  };
  addLevels(family, reach, o,
            [centre, x0 = box.min().x(), x1 = box.max().x(),
             edge = levelEdgeMm(o)](double middle, double thickness, const base::RunContext&) {
              layers::LevelSurface s = cylinderLevel(middle, thickness, x0, x1, edge);
              for (Vector3d& p : s.surface.vertices)
                p += centre;
              return s;
            });
}

// Returns the given height of the end surface, or that of the part.
double topOf(const geometry::TriangleMesh& part, const EndSurface& end) {
  return end.heightMm ? *end.heightMm : geometry::bounds(part).max().z();
}

// Returns circles from the cylinder on which the part rests; their number brings the layers nearest
// to the layer height within the limits.
std::vector<FlatteningCircle> circlesOf(const CircleFit& start, double halfWidth, double top,
                                        const SubstrateOptions& o) {
  constexpr int kMaxLayers = 2000, kAngles = 64;
  const FlatteningCircle first{start.centre.y() + start.radiusMm, start.radiusMm};
  const double rise = top - first.topMm;
  if (!(rise > 0.0))
    refuse(
        base::message("the end surface is {rise:.3g} mm above the top of the starting surface"_text,
                      base::number(rise)),
        "choose a higher end surface (`endSurface`)"_text);
  if (halfWidth >= start.radiusMm)
    refuse(base::message("the part is {width:.3g} mm wide, at least as wide as the cylinder "
                         "below it"_text,
                         base::number(2.0 * halfWidth)),
           "make the part narrower, or use `layerShape=offset`"_text);
  std::vector<FlatteningCircle> best;
  double bestOff = std::numeric_limits<double>::infinity();
  double minimum = 0.0, maximum = 0.0; // Thickness range of the best number of layers
  double bestBeyond = std::numeric_limits<double>::infinity();
  for (int n = 1; n <= kMaxLayers && rise / n >= 0.1 * o.heightMinMm; ++n) {
    std::vector<FlatteningCircle> circles =
        flatteningToPlane(first, halfWidth, rise / n, n, o.end.radiusMm);
    double low = std::numeric_limits<double>::infinity(), high = 0.0, sum = 0.0;
    for (std::size_t k = 0; k + 1 < circles.size(); ++k)
      for (int i = 0; i <= kAngles; ++i) {
        const double across = halfWidth * i / kAngles;
        const double alpha = std::acos(across / circles[k].radiusMm);
        const double h = thicknessAt(circles[k], circles[k + 1], alpha);
        low = std::isfinite(h) ? std::min(low, h) : -1.0;
        high = std::max(high, h);
        sum += h / (n * (kAngles + 1.0));
      }
    const double beyond = std::max({0.0, o.heightMinMm - low, high - o.heightMaxMm});
    const double off = std::abs(sum - o.layerHeightMm);
    if (beyond > bestBeyond || (beyond == bestBeyond && off >= bestOff))
      continue;
    bestBeyond = beyond;
    bestOff = off;
    minimum = low;
    maximum = high;
    best = std::move(circles);
  }
  constexpr double kSlackMm = 1e-9;
  if (best.empty() || bestBeyond > kSlackMm)
    refuse(base::message("no number of layers between the surface and the end surface keeps "
                         "the layer height within {least} to {most} mm: {layers} layers would "
                         "be {thinnest:.3g} to {thickest:.3g} mm high"_text,
                         base::number(o.heightMinMm), base::number(o.heightMaxMm),
                         best.empty() ? 0 : best.size() - 1, base::number(minimum),
                         base::number(maximum)),
           "choose an end surface of more similar shape, or a narrower part"_text);
  return best;
}

void addCircles(LevelFamily& family, const geometry::TriangleMesh& part, const CircleFit& start,
                const SubstrateOptions& o, const Eigen::AlignedBox3d& box) {
  const double across = start.centre.x();
  double halfWidth = 0.0;
  for (const Vector3d& p : part.vertices)
    halfWidth = std::max(halfWidth, std::abs(p.y() - across));
  const std::vector<FlatteningCircle> circles = circlesOf(start, halfWidth, topOf(part, o.end), o);
  // Slightly wider than the part, which trims it, but narrower than the cylinder.
  const double width =
      std::min(halfWidth + 2.0 * levelEdgeMm(o), 0.5 * (halfWidth + start.radiusMm));
  family.count = static_cast<int>(circles.size()) - 1;
  family.level = [circles, width, across, x0 = box.min().x(), x1 = box.max().x(),
                  edge = levelEdgeMm(o)](int k, const base::RunContext&) {
    const auto i = static_cast<std::size_t>(k);
    layers::LevelSurface s = circleLevel(circles[i], circles[i + 1], width, x0, x1, edge);
    for (Vector3d& p : s.surface.vertices)
      p.y() += across;
    return s;
  };
}

void addFlattening(LevelFamily& family, const geometry::TriangleMesh& part,
                   const GroundDistance& ground, const SubstrateOptions& o,
                   const Eigen::AlignedBox3d& box, const base::RunContext& ctx) {
  const auto cylinder = cylinderUnder(footOf(part, ground));
  if (cylinder && !o.end.mesh)
    return addCircles(family, part, *cylinder, o, box);
  if (!std::isinf(o.end.radiusMm))
    refuse("an end surface radius:R requires a cylinder along x below the part"_text,
           "give `endSurface=flat:Z` or mesh:FILE"_text);
  BlendOptions blend;
  blend.levels = o;
  blend.endHeightMm = topOf(part, o.end);
  blend.end = o.end.mesh;
  const auto levels = std::make_shared<const std::vector<layers::LevelSurface>>(
      blendLevels(ground, geometry::MeshQuery(part), box, blend, ctx));
  family.count = static_cast<int>(levels->size());
  family.level = [levels](int k, const base::RunContext&) {
    return (*levels)[static_cast<std::size_t>(k)];
  };
}

} // namespace

geometry::TriangleMesh partOnBody(const geometry::TriangleMesh& part,
                                  const geometry::TriangleMesh& body) {
  std::optional<geometry::TriangleMesh> remainder = geometry::subtract(part, body);
  if (!remainder)
    refuse("the part is not closed or self-intersects where the surface's body "
           "is subtracted"_text,
           "repair the part first"_text);
  if (remainder->empty())
    refuse("the body of the surface contains the whole part"_text,
           "move the part out of the surface, or print it larger"_text);
  return std::move(*remainder);
}

GroundDistance plateGround() {
  return {[](const Vector3d& p) { return Vector3d(p.x(), p.y(), 0.0); },
          [](const Vector3d& p) { return p.z() < 0.0; }};
}

LevelFamily substrateLevels(const geometry::TriangleMesh& part, const GroundDistance& ground,
                            const SubstrateOptions& o, const base::RunContext& ctx) {
  base::require(!part.empty(), "a part");
  LevelFamily family;
  family.ground = {[ground](const Vector3d& p) { return ground.signedMm(p); }};
  family.outward = [ground](const Vector3d& p) { return ground.outward(p); };
  Eigen::AlignedBox3d box = geometry::bounds(part);
  box.min().array() -= 2.0 * levelEdgeMm(o);
  box.max().array() += 2.0 * levelEdgeMm(o);
  switch (o.shape) {
  case LevelShape::Offset:
    addOffsets(family, part, ground, o, box);
    break;
  case LevelShape::Sphere:
    addSpheres(family, part, ground, o, box);
    break;
  case LevelShape::Cylinder:
    addCylinders(family, part, ground, o, box);
    break;
  case LevelShape::Flatten:
    addFlattening(family, part, ground, o, box, ctx);
    break;
  }
  return family;
}

} // namespace voluta::substrate
