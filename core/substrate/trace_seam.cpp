#include "substrate/trace_seam.h"

#include "geometry/mesh_query.h"
#include "geometry/polygon_paths.h"
#include "substrate/corner_normals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace voluta::substrate {

using ClipperLib::Path;
using ClipperLib::Paths;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double kMinClosingMm = 0.01;
constexpr double kMinReachMm = 10.0; // of the search for the side beside an outline
constexpr double kArcMm = 0.002, kCleanMm = 0.004;
constexpr std::size_t kUnionOf = 256; // polygons that are united at a time

// Many small polygons are united group by group, which is faster than all at once.
Paths unitedInGroups(Paths paths, const base::RunContext& ctx) {
  while (paths.size() > kUnionOf) {
    Paths next;
    for (std::size_t first = 0; first < paths.size(); first += kUnionOf) {
      ctx.checkpoint();
      const auto from = paths.begin() + static_cast<std::ptrdiff_t>(first),
                 to = paths.begin() +
                      static_cast<std::ptrdiff_t>(std::min(paths.size(), first + kUnionOf));
      const Paths group = geometry::united(Paths(from, to));
      next.insert(next.end(), group.begin(), group.end());
    }
    const bool isStuck = next.size() > paths.size() / 2;
    paths = std::move(next);
    if (isStuck)
      break;
  }
  return geometry::united(paths);
}

Paths grown(const Paths& paths, double byMm) {
  return geometry::offsetPaths(
      paths, byMm,
      {.arcMm = kArcMm, .corners = byMm > 0.0 ? ClipperLib::jtRound : ClipperLib::jtMiter});
}

// Removes steps of an outline to the side: where the normals of neighbouring triangles differ, the
// outline jumps by a fraction of a millimetre, and a strip along it would fold. A short edge
// between edges of nearly one direction is replaced by its middle.
Path withoutJags(Path path, double shortMm) {
  constexpr double kSameDirection = 0.9; // cosine
  for (bool isChanged = true; isChanged && path.size() > 4;) {
    isChanged = false;
    for (std::size_t i = 0; i < path.size() && path.size() > 4; ++i) {
      const std::size_t n = path.size();
      const Vector2d before = geometry::pointMm(path[(i + n - 1) % n]),
                     from = geometry::pointMm(path[i]), to = geometry::pointMm(path[(i + 1) % n]),
                     after = geometry::pointMm(path[(i + 2) % n]);
      const Vector2d direction = (from - before).normalized(), step = to - from;
      const bool isSideways =
          step.norm() > 0.0 && step.normalized().dot(direction) < kSameDirection;
      if (step.norm() >= shortMm || !isSideways ||
          direction.dot((after - to).normalized()) < kSameDirection)
        continue;
      path[i] = geometry::pathPoint(0.5 * (from + to));
      path.erase(path.begin() + static_cast<std::ptrdiff_t>((i + 1) % n));
      isChanged = true;
    }
  }
  return path;
}

// Returns the part of a triangle where the angle is at most `steepRad`, seen from above.
Path gentlePart(const geometry::TriangleMesh& mesh, std::size_t t,
                const std::array<double, 3>& angle, double steepRad) {
  Path part;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t n = (k + 1) % 3;
    const Vector3d &a = mesh.corner(t, static_cast<int>(k)),
                   &b = mesh.corner(t, static_cast<int>(n));
    if (angle[k] <= steepRad)
      part.push_back(geometry::pathPoint(a.head<2>()));
    if ((angle[k] <= steepRad) != (angle[n] <= steepRad)) {
      const double share = (steepRad - angle[k]) / (angle[n] - angle[k]);
      part.push_back(geometry::pathPoint(a.head<2>() + share * (b - a).head<2>()));
    }
  }
  return part;
}

class Tracer {
public:
  Tracer(const geometry::TriangleMesh& surface, const SeamRule& rule, const base::RunContext& ctx)
      : mesh_(surface), rule_(rule), ctx_(ctx), normals_(cornerNormals(surface)),
        query_(surface, geometry::MeshQuery::Of::Surface) {
    for (const Vector3d& v : surface.vertices) {
      low_ = std::min(low_, v.z());
      high_ = std::max(high_, v.z());
    }
  }

  std::vector<SeamCurve> trace() const {
    std::vector<SeamCurve> curves;
    const auto keep = [&](std::optional<SeamCurve> curve, double minMm) {
      if (curve && curve->lengthMm() >= minMm)
        curves.push_back(std::move(*curve));
    };
    for (const Path& outline : outlines()) {
      for (int k = 0; k < rule_.curves; ++k)
        for (const Path& path : inset(outline, k))
          keep(lifted(path, true), rule_.minMm);
      for (int k = 0; k < rule_.sideCurves; ++k)
        keep(onSide(outline, rule_.sideDepthMm + k * rule_.spacingMm), rule_.minMm);
      for (const Path& line : endLines(inset(outline, rule_.curves)))
        keep(lifted(line, false), rule_.spacingMm); // ends are narrow
    }
    return curves;
  }

private:
  // Returns the outer outlines, counter-clockwise.
  Paths outlines() const {
    Paths parts;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      std::array<double, 3> angle{};
      for (std::size_t k = 0; k < 3; ++k)
        angle[k] = std::acos(std::clamp(normals_[t][k].z(), -1.0, 1.0));
      Path part = gentlePart(mesh_, t, angle, rule_.steepRad);
      if (part.size() >= 3 && ClipperLib::Area(part) > 0.0)
        parts.push_back(std::move(part));
    }
    const double closing = std::max(kMinClosingMm, rule_.closingMm);
    Paths closed = grown(grown(unitedInGroups(std::move(parts), ctx_), closing), -closing);
    ClipperLib::CleanPolygons(closed, kCleanMm * geometry::kPathUnits);
    std::erase_if(closed, [](const Path& path) {
      return path.size() < 3 || ClipperLib::Area(path) <= 0.0; // holes
    });
    constexpr double kShortShare = 0.25; // of a step
    for (Path& path : closed)
      path = withoutJags(std::move(path), kShortShare * rule_.stepMm);
    return closed;
  }

  // Returns the outline moved inwards to the place of curve k.
  Paths inset(const Path& outline, int k) const {
    const double mm = rule_.insetMm + k * rule_.spacingMm;
    return mm > 0.0 ? grown({outline}, -mm) : Paths{outline};
  }

  // Returns points of a path, at most a step apart.
  std::vector<Vector2d> stepped(const Path& path, bool isClosed) const {
    std::vector<Vector2d> points;
    const std::size_t pieces = path.size() - (isClosed ? 0 : 1);
    for (std::size_t i = 0; i < pieces; ++i) {
      const Vector2d from = geometry::pointMm(path[i]),
                     to = geometry::pointMm(path[(i + 1) % path.size()]);
      const int steps = std::max(1, static_cast<int>(std::ceil((to - from).norm() / rule_.stepMm)));
      for (int s = 0; s < steps; ++s)
        points.emplace_back(from + (to - from) * s / steps);
    }
    if (!isClosed)
      points.push_back(geometry::pointMm(path.back()));
    return points;
  }

  // Returns the curve on the surface below the path; nullopt if the surface has a gap there.
  std::optional<SeamCurve> lifted(const Path& path, bool isClosed) const {
    SeamCurve curve;
    curve.isClosed = isClosed;
    for (const Vector2d& point : stepped(path, isClosed))
      if (!lift(point, curve))
        return std::nullopt;
    return curve;
  }

  // Returns the section of the surface with the ribbon that the outline, lowered along z, spans
  // with its copies further out and in; nullopt if the section has a gap.
  std::optional<SeamCurve> onSide(const Path& outline, double depthMm) const {
    const double reach = std::max(kMinReachMm, 2.0 * depthMm);
    const std::vector<Vector2d> points = stepped(outline, true);
    SeamCurve seam, side;
    for (std::size_t i = 0, n = points.size(); i < n; ++i) {
      if (!lift(points[i], seam))
        return std::nullopt;
      const Vector2d along = points[(i + 1) % n] - points[(i + n - 1) % n];
      const Vector3d outward = Vector3d(along.y(), -along.x(), 0.0).normalized(),
                     low = seam.points.back() - depthMm * Vector3d::UnitZ(),
                     from = low + reach * outward, to = low - reach * outward;
      const auto hit = query_.firstHit(from, to);
      if (!hit)
        return std::nullopt;
      append(from + hit->t * (to - from), static_cast<std::size_t>(hit->triangle), side);
    }
    return side;
  }

  // Returns lines across both ends of the areas, from the ends inwards.
  Paths endLines(const Paths& areas) const {
    Paths lines;
    const Vector2d along(std::cos(rule_.fillRad), std::sin(rule_.fillRad)),
        across(along.y(), -along.x());
    for (const Path& area : areas) {
      double low = std::numeric_limits<double>::infinity(), high = -low, reach = 0.0;
      for (const ClipperLib::IntPoint& corner : area) {
        const Vector2d p = geometry::pointMm(corner);
        low = std::min(low, p.dot(across));
        high = std::max(high, p.dot(across));
        reach = std::max(reach, std::abs(p.dot(along)) + 1.0);
      }
      for (int end = 0; end < 2; ++end)
        for (int k = 0; k < rule_.fillLines; ++k) {
          const double in = (k + 0.5) * rule_.spacingMm;
          // The ends do not share lines.
          constexpr double kSlackMm = 0.01; // of the outline
          if (in > 0.5 * (high - low) - (end == 0 ? 0.0 : 0.5 * rule_.spacingMm) + kSlackMm)
            break;
          const Vector2d middle = (end == 0 ? high - in : low + in) * across;
          const Path line{geometry::pathPoint(middle - reach * along),
                          geometry::pathPoint(middle + reach * along)};
          ClipperLib::Clipper clipper;
          clipper.AddPath(line, ClipperLib::ptSubject, false);
          clipper.AddPath(area, ClipperLib::ptClip, true);
          ClipperLib::PolyTree inside;
          clipper.Execute(ClipperLib::ctIntersection, inside);
          Paths pieces;
          ClipperLib::OpenPathsFromPolyTree(inside, pieces);
          lines.insert(lines.end(), pieces.begin(), pieces.end());
        }
    }
    return lines;
  }

  // Rounding may put a point on the rim just outside the surface.
  bool lift(const Vector2d& at, SeamCurve& curve) const {
    constexpr double kBeyondMm = 1.0, kRimMm = 0.05;
    const Vector3d above(at.x(), at.y(), high_ + kBeyondMm),
        below(at.x(), at.y(), low_ - kBeyondMm);
    if (const auto hit = query_.firstHit(above, below)) {
      const Vector3d point = above + hit->t * (below - above);
      append(point, static_cast<std::size_t>(hit->triangle), curve);
      return true;
    }
    const auto nearest = query_.closest({at.x(), at.y(), high_}, high_ - low_ + kRimMm);
    if (nearest.triangle < 0 || (nearest.point.head<2>() - at).norm() > kRimMm)
      return false;
    append(nearest.point, static_cast<std::size_t>(nearest.triangle), curve);
    return true;
  }

  void append(const Vector3d& point, std::size_t triangle, SeamCurve& curve) const {
    curve.points.push_back(point);
    curve.normals.push_back(normalAt(mesh_, triangle, normals_[triangle], point));
  }

  const geometry::TriangleMesh& mesh_;
  const SeamRule& rule_;
  const base::RunContext& ctx_;
  std::vector<CornerNormals> normals_;
  geometry::MeshQuery query_;
  double low_ = std::numeric_limits<double>::infinity(), high_ = -low_;
};

} // namespace

double SeamCurve::lengthMm() const {
  double length = 0.0;
  for (std::size_t i = isClosed ? 0 : 1; i < points.size(); ++i)
    length += (points[i] - points[(i + points.size() - 1) % points.size()]).norm();
  return length;
}

std::vector<SeamCurve> seamCurves(const geometry::TriangleMesh& surface, const SeamRule& rule,
                                  const base::RunContext& ctx) {
  return surface.empty() ? std::vector<SeamCurve>() : Tracer(surface, rule, ctx).trace();
}

} // namespace voluta::substrate
