#include "planar/pith_limbs.h"

#include "base/units.h"
#include "geometry/polyline.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace voluta::planar {

namespace {
using Eigen::Vector3d;

constexpr double kFarMm = 1e5;
constexpr int kSmoothPasses = 8;

class Graph {
public:
  explicit Graph(const CurveSkeleton& skeleton)
      : points_(skeleton.points), neighbours_(skeleton.points.size()) {
    for (const auto& [a, b] : skeleton.edges) {
      neighbours_[static_cast<std::size_t>(a)].push_back(b);
      neighbours_[static_cast<std::size_t>(b)].push_back(a);
    }
  }

  std::size_t degree(int node) const { return of(node).size(); }
  const Vector3d& point(int node) const { return points_[static_cast<std::size_t>(node)]; }
  int count() const { return static_cast<int>(points_.size()); }

  // Returns the nodes of each line between nodes that do not have two neighbours.
  std::vector<std::vector<int>> lines() const {
    std::vector<std::vector<int>> lines;
    for (int node = 0; node < count(); ++node)
      if (degree(node) != 2)
        for (const int next : of(node)) {
          std::vector<int> line = lineFrom(node, next);
          if (line.front() < line.back() ||
              (line.front() == line.back() && line[1] < line.end()[-2]))
            lines.push_back(std::move(line));
        }
    return lines;
  }

  void removeLine(const std::vector<int>& line) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      std::erase(of(line[i - 1]), line[i]);
      std::erase(of(line[i]), line[i - 1]);
    }
  }

private:
  const std::vector<int>& of(int node) const { return neighbours_[static_cast<std::size_t>(node)]; }
  std::vector<int>& of(int node) { return neighbours_[static_cast<std::size_t>(node)]; }

  std::vector<int> lineFrom(int node, int next) const {
    std::vector<int> line{node, next};
    while (degree(line.back()) == 2 && line.back() != node) {
      const std::vector<int>& around = of(line.back());
      line.push_back(around[0] == line.end()[-2] ? around[1] : around[0]);
    }
    return line;
  }

  std::vector<Vector3d> points_;
  std::vector<std::vector<int>> neighbours_;
};

double lengthOf(const std::vector<Vector3d>& points) {
  return geometry::polylineLength(points.size(), [&](std::size_t i) { return points[i]; });
}

std::vector<Vector3d> evenly(const std::vector<Vector3d>& points, double spacingMm) {
  const double length = lengthOf(points);
  const int steps = std::max(1, static_cast<int>(std::lround(length / spacingMm)));
  std::vector<Vector3d> even{points.front()};
  double before = 0.0;
  int k = 1;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double piece = (points[i] - points[i - 1]).norm();
    for (; k < steps && k * length / steps <= before + piece; ++k)
      even.push_back(points[i - 1] + (k * length / steps - before) / std::max(piece, 1e-12) *
                                         (points[i] - points[i - 1]));
    before += piece;
  }
  even.push_back(points.back());
  return even;
}

void smooth(std::vector<Vector3d>& points) {
  for (int pass = 0; pass < kSmoothPasses; ++pass) {
    const std::vector<Vector3d> before = points;
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
      points[i] = 0.25 * before[i - 1] + 0.5 * before[i] + 0.25 * before[i + 1];
  }
}

Vector3d tangentAt(const std::vector<Vector3d>& points, std::size_t i) {
  const std::size_t before = i > 0 ? i - 1 : 0, after = std::min(i + 1, points.size() - 1);
  return (points[after] - points[before]).normalized();
}

std::optional<double> distanceAlong(const geometry::MeshQuery& part, const Vector3d& from,
                                    const Vector3d& direction) {
  const auto hit = part.firstHit(from, from + kFarMm * direction);
  return hit ? std::optional(hit->t * kFarMm) : std::nullopt;
}

// Returns the least distance to the surface across a direction; 0 if nothing is there.
double radiusAcross(const geometry::MeshQuery& part, const Vector3d& at, const Vector3d& tangent) {
  constexpr int kRays = 24;
  const Vector3d u = tangent.unitOrthogonal(), v = tangent.cross(u);
  double minimum = std::numeric_limits<double>::infinity();
  for (int k = 0; k < kRays; ++k) {
    const double angle = base::kTwoPi * k / kRays;
    if (const auto mm = distanceAlong(part, at, std::cos(angle) * u + std::sin(angle) * v))
      minimum = std::min(minimum, *mm);
  }
  return std::isfinite(minimum) ? minimum : 0.0;
}

// Extends the last point along the limb's direction to the surface.
void extendToSurface(std::vector<Vector3d>& points, const geometry::MeshQuery& part) {
  const Vector3d end = points.back();
  const double near = part.closest(end).distance;
  // The flow draws the skeleton's last points towards corners of the end.
  while (points.size() > 2 && (points.back() - end).norm() < near)
    points.pop_back();
  std::size_t before = points.size() - 2;
  while (before > 0 && (points.back() - points[before]).norm() < near)
    --before;
  const Vector3d direction = (points.back() - points[before]).normalized();
  if (const auto mm = distanceAlong(part, points.back(), direction))
    points.push_back(points.back() + *mm * direction);
}

void pruneShortEnds(Graph& graph, const geometry::MeshQuery& part) {
  for (bool isPruned = true; isPruned;) {
    isPruned = false;
    for (const std::vector<int>& line : graph.lines()) {
      const bool first = graph.degree(line.front()) == 1, last = graph.degree(line.back()) == 1;
      if (first == last)
        continue;
      std::vector<Vector3d> points;
      for (const int node : line)
        points.push_back(graph.point(node));
      const double radius = part.closest(graph.point(first ? line.back() : line.front())).distance;
      if (lengthOf(points) >= radius)
        continue;
      graph.removeLine(line);
      isPruned = true;
      break;
    }
  }
}

} // namespace

double Limb::lengthMm() const {
  return lengthOf(points);
}

std::vector<Limb> limbsOf(const CurveSkeleton& skeleton, const geometry::MeshQuery& part,
                          double spacingMm) {
  Graph graph(skeleton);
  pruneShortEnds(graph, part);
  std::vector<Limb> limbs;
  for (const std::vector<int>& line : graph.lines()) {
    Limb limb;
    limb.branchesFirst = graph.degree(line.front()) > 2;
    limb.branchesLast = graph.degree(line.back()) > 2;
    std::vector<Vector3d> points;
    for (const int node : line)
      points.push_back(graph.point(node));
    points = evenly(points, spacingMm);
    smooth(points);
    if (!limb.branchesLast)
      extendToSurface(points, part);
    if (!limb.branchesFirst) {
      std::ranges::reverse(points);
      extendToSurface(points, part);
      std::ranges::reverse(points);
    }
    limb.points = evenly(points, spacingMm);
    for (std::size_t i = 0; i < limb.points.size(); ++i)
      limb.partRadiusMm.push_back(radiusAcross(part, limb.points[i], tangentAt(limb.points, i)));
    // At its ends a limb may leave the surface, or see the whole of a crossing.
    if (limb.points.size() > 2) {
      limb.partRadiusMm.front() = limb.partRadiusMm[1];
      limb.partRadiusMm.back() = limb.partRadiusMm.end()[-2];
    }
    limbs.push_back(std::move(limb));
  }
  return limbs;
}

} // namespace voluta::planar
