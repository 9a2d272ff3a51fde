#include "toolpath/fibre/streamlines.h"

#include "geometry/symmetric_axes.h"
#include "geometry/triangle_queries.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <deque>
#include <limits>
#include <map>

namespace voluta::toolpath {

namespace {
using Eigen::Vector3d;

constexpr double kStepMm = 0.5;
constexpr std::size_t kMaxSteps = 20000;
// A step that gets less far than this share of it has met the boundary.
constexpr double kStuck = 0.5;
// Streamlines end at this share of the distance from others.
constexpr double kCloser = 0.99;
// A streamline that comes back to its begin is closed: within this share of the distance, after
// this many of it.
constexpr double kSame = 0.5, kLoop = 4.0;

// Segments that are added one by one, in cells.
class PlacedSegments {
public:
  explicit PlacedSegments(double cellMm) : cellMm_(cellMm) {}

  void add(const Vector3d& a, const Vector3d& b) {
    const Segment segment{a, b};
    eachCell(a.cwiseMin(b), a.cwiseMax(b), [&](const Cell& cell) {
      cells_[cell].push_back(segment);
      return false;
    });
  }

  // Returns whether one of them is closer to a place.
  bool isWithin(const Vector3d& p, double distanceMm) const {
    const Vector3d reach = Vector3d::Constant(distanceMm);
    return eachCell(p - reach, p + reach, [&](const Cell& cell) {
      const auto found = cells_.find(cell);
      return found != cells_.end() && std::ranges::any_of(found->second, [&](const Segment& s) {
               return geometry::distanceToSegment(p, s.from, s.to) < distanceMm;
             });
    });
  }

private:
  using Cell = std::array<int, 3>;
  struct Segment {
    Vector3d from, to;
  };

  // Calls visit(cell) for the cells of a box until it returns true; returns whether one does.
  template <typename Visit>
  bool eachCell(const Vector3d& low, const Vector3d& high, const Visit& visit) const {
    const Eigen::Vector3i first = (low / cellMm_).array().floor().cast<int>(),
                          last = (high / cellMm_).array().floor().cast<int>();
    for (int x = first.x(); x <= last.x(); ++x)
      for (int y = first.y(); y <= last.y(); ++y)
        for (int z = first.z(); z <= last.z(); ++z)
          if (visit(Cell{x, y, z}))
            return true;
    return false;
  }

  double cellMm_;
  std::map<Cell, std::vector<Segment>> cells_;
};

class Tracer {
public:
  Tracer(const PatchSurface& s, const DirectionField& field, double apartMm)
      : s_(s), field_(field), apartMm_(apartMm), placed_(apartMm) {}

  std::vector<SurfaceCurve> trace(const SurfacePoint& first, const base::RunContext& ctx) {
    std::deque<SurfacePoint> seeds = {first};
    while (!seeds.empty()) {
      ctx.checkpoint();
      const SurfacePoint seed = seeds.front();
      seeds.pop_front();
      if (!isFree(seed.position))
        continue;
      SurfaceCurve line = lineThrough(seed);
      if (line.points.size() < 2)
        continue;
      addSeeds(line, seeds);
      add(line);
      lines_.push_back(std::move(line));
    }
    return std::move(lines_);
  }

private:
  bool isFree(const Vector3d& p) const { return !placed_.isWithin(p, kCloser * apartMm_); }

  SurfaceCurve lineThrough(const SurfacePoint& seed) const {
    const Vector3d ahead = field_.at(s_, seed, Vector3d::UnitX());
    if (ahead.isZero())
      return {};
    SurfaceCurve line;
    bool closed = false;
    line.points = from(seed, ahead, closed);
    if (!closed) {
      std::vector<SurfacePoint> back = from(seed, -ahead, closed);
      std::ranges::reverse(back);
      back.pop_back(); // the seed
      line.points.insert(line.points.begin(), back.begin(), back.end());
    }
    line.closed = closed;
    return line;
  }

  // Returns the points from the seed on in a direction.
  std::vector<SurfacePoint> from(const SurfacePoint& seed, Vector3d ahead, bool& closed) const {
    std::vector<SurfacePoint> points = {seed};
    for (std::size_t i = 0; i < kMaxSteps; ++i) {
      const SurfacePoint& here = points.back();
      // The direction at half a step: second order.
      const SurfacePoint half = s_.project(here.position + 0.5 * kStepMm * ahead, here.triangle);
      const Vector3d along = field_.at(s_, half, ahead);
      if (along.isZero())
        break;
      const SurfacePoint next = s_.project(here.position + kStepMm * along, half.triangle);
      if ((next.position - here.position).dot(along) < kStuck * kStepMm || !isFree(next.position))
        break;
      ahead = along;
      points.push_back(next);
      closed = static_cast<double>(i) * kStepMm > kLoop * apartMm_ &&
               (next.position - seed.position).norm() < kSame * apartMm_;
      if (closed)
        break;
    }
    return points;
  }

  // Adds places beside a line, on both sides.
  void addSeeds(const SurfaceCurve& line, std::deque<SurfacePoint>& seeds) const {
    const auto every = std::max<std::size_t>(1, static_cast<std::size_t>(apartMm_ / kStepMm));
    const std::size_t middle = line.points.size() / 2;
    for (std::size_t k = 0; k < line.points.size(); k += every) {
      // From the middle outwards
      const std::size_t i = (middle + k) % line.points.size();
      const SurfacePoint& p = line.points[i];
      const Vector3d along = field_.at(s_, p, Vector3d::UnitX());
      const Vector3d lateral = s_.interpolate(s_.normal, p).cross(along);
      for (const double side : {-1.0, 1.0}) {
        const SurfacePoint seed = s_.project(p.position + side * apartMm_ * lateral, p.triangle);
        if ((seed.position - p.position).norm() > kCloser * apartMm_)
          seeds.push_back(seed);
      }
    }
  }

  void add(const SurfaceCurve& line) {
    for (std::size_t i = 1; i < line.points.size() + (line.closed ? 1 : 0); ++i)
      placed_.add(line.points[i - 1].position, line.points[i % line.points.size()].position);
  }

  const PatchSurface& s_;
  const DirectionField& field_;
  double apartMm_;
  PlacedSegments placed_;
  std::vector<SurfaceCurve> lines_;
};

// Returns the place of the surface that is nearest to the middle of its area.
SurfacePoint middleOf(const PatchSurface& s) {
  Vector3d middle = Vector3d::Zero();
  const auto centreOf = [&](std::size_t t) {
    Vector3d centre = Vector3d::Zero();
    for (const int v : s.triangles[t])
      centre += s.position[static_cast<std::size_t>(v)] / 3.0;
    return centre;
  };
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
    middle += s.triangleArea[t] / s.areaMm2 * centreOf(t);
  SurfacePoint nearest{centreOf(0), 0};
  double minimum = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < s.triangles.size(); ++t)
    if (const double d = (centreOf(t) - middle).squaredNorm(); d < minimum) {
      minimum = d;
      nearest = {centreOf(t), static_cast<int>(t)};
    }
  return s.project(middle, nearest.triangle);
}

} // namespace

Vector3d DirectionField::at(const PatchSurface& surface, const SurfacePoint& point,
                            const Vector3d& ahead) const {
  const Eigen::Matrix3d dyads = dyads_(point.position);
  const Vector3d normal = surface.interpolate(surface.normal, point);
  const Eigen::Matrix3d flat = Eigen::Matrix3d::Identity() - normal * normal.transpose();
  const Eigen::Matrix3d within = flat * dyads * flat;
  const auto [values, axes] = geometry::symmetricAxes(within);
  constexpr double kNone = 1e-9;
  if (values[2] <= kNone * dyads.trace())
    return Vector3d::Zero();
  const Vector3d along = (flat * axes.col(2)).normalized();
  return along.dot(ahead) < 0.0 ? Vector3d(-along) : along;
}

std::vector<SurfaceCurve> evenStreamlines(const PatchSurface& surface, const DirectionField& field,
                                          double apartMm, double firstMm,
                                          const base::RunContext& ctx) {
  if (surface.triangles.empty())
    return {};
  const SurfacePoint middle = middleOf(surface);
  const Vector3d along = field.at(surface, middle, Vector3d::UnitX());
  const Vector3d lateral = surface.interpolate(surface.normal, middle).cross(along);
  const SurfacePoint first = surface.project(middle.position + firstMm * lateral, middle.triangle);
  return Tracer(surface, field, apartMm).trace(first, ctx);
}

} // namespace voluta::toolpath
