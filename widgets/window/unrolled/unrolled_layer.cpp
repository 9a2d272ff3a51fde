#include "window/unrolled/unrolled_layer.h"

#include "geometry/mesh_query.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace voluta::window {

namespace {
constexpr std::size_t kBetweenChecks = 4096;

// Returns (u, v) with u within half a period of 0.
Eigen::Vector2d wrapped(const Eigen::Vector2d& at, double period) {
  return period > 0.0 ? Eigen::Vector2d(std::remainder(at.x(), period), at.y()) : at;
}

// The segment from `from` (with u within half a period) by `step`, divided at the seam into at most
// two pieces.
struct Pieces {
  std::array<std::pair<Eigen::Vector2d, Eigen::Vector2d>, 2> ends;
  int count = 1;
};
Pieces cutAtSeam(const Eigen::Vector2d& from, const Eigen::Vector2d& step, double period) {
  const Eigen::Vector2d to = from + step;
  const double half = 0.5 * period;
  if (period <= 0.0 || std::abs(to.x()) <= half)
    return {{{{from, to}}}, 1};
  const double side = std::copysign(half, to.x());
  const double t = (side - from.x()) / step.x();
  const double v = from.y() + t * step.y();
  return {{{{from, {side, v}}, {{-side, v}, {to.x() - std::copysign(period, to.x()), to.y()}}}}, 2};
}

QPointF point(const Eigen::Vector2d& p) {
  return {p.x(), p.y()};
}

void addOutline(const layers::Patch& patch, UnrolledLayer& out) {
  std::map<std::pair<int, int>, int> sides;
  for (const auto& t : patch.surface.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      ++sides[std::minmax(t[k], t[(k + 1) % 3])];
  for (const auto& [ends, count] : sides) {
    if (count != 1)
      continue;
    const Eigen::Vector2d from =
        wrapped(patch.chart.at[static_cast<std::size_t>(ends.first)], out.periodMm);
    const Pieces pieces =
        cutAtSeam(from, patch.chart.between(ends.first, ends.second), out.periodMm);
    for (int i = 0; i < pieces.count; ++i) {
      const auto& [a, b] = pieces.ends[static_cast<std::size_t>(i)];
      out.outline.emplace_back(point(a), point(b));
    }
  }
}

// Finds the chart coordinates of points near a patch.
class ChartQuery {
public:
  explicit ChartQuery(const layers::Patch& patch) : patch_(patch), query_(patch.surface) {}

  Eigen::Vector2d at(const Eigen::Vector3d& p) const {
    const geometry::MeshQuery::Closest c = query_.closest(p);
    const auto& corners = patch_.surface.triangles[static_cast<std::size_t>(c.triangle)];
    const auto corner = [&](std::size_t k) {
      return patch_.surface.vertices[static_cast<std::size_t>(corners[k])];
    };
    const Eigen::Vector3d ab = corner(1) - corner(0), ac = corner(2) - corner(0),
                          ap = c.point - corner(0);
    const Eigen::Vector3d n = ab.cross(ac);
    const double area = n.squaredNorm();
    if (area <= 0.0)
      return patch_.chart.at[static_cast<std::size_t>(corners[0])];
    const double b = ap.cross(ac).dot(n) / area, a = ab.cross(ap).dot(n) / area;
    return patch_.chart.blend(corners, {1.0 - b - a, b, a});
  }

private:
  const layers::Patch& patch_;
  geometry::MeshQuery query_;
};

class PathWriter {
public:
  PathWriter(const plan::ToolPlan& plan, UnrolledLayer& out) : plan_(plan), out_(out) {}

  void add(std::size_t index, const ChartQuery& chart, const base::RunContext& ctx) {
    const plan::ToolPath& path = plan_.paths[index];
    Eigen::Vector2d last;
    for (std::size_t i = path.first; i < path.first + path.count; ++i) {
      if ((i - path.first) % kBetweenChecks == 0)
        ctx.checkpoint();
      const Eigen::Vector2d here = wrapped(chart.at(plan_.position[i]), out_.periodMm);
      if (i == path.first) {
        begin(index, path.kind);
        put(here, i);
      } else {
        const Eigen::Vector2d step = here - last;
        const Eigen::Vector2d shortest =
            out_.periodMm > 0.0 ? Eigen::Vector2d(std::remainder(step.x(), out_.periodMm), step.y())
                                : step;
        const Pieces pieces = cutAtSeam(last, shortest, out_.periodMm);
        put(pieces.ends[0].second, i);
        if (pieces.count == 2) {
          begin(index, path.kind);
          put(pieces.ends[1].first, i);
          put(pieces.ends[1].second, i);
        }
      }
      last = here;
    }
  }

private:
  void begin(std::size_t index, plan::PathKind kind) {
    out_.stretches.push_back({out_.points.size(), 0, index, kind});
  }
  void put(const Eigen::Vector2d& at, std::size_t waypoint) {
    out_.points.push_back(point(at));
    out_.waypoint.push_back(waypoint);
    out_.widthMm.push_back(plan_.widthMm[waypoint]);
    ++out_.stretches.back().count;
  }

  const plan::ToolPlan& plan_;
  UnrolledLayer& out_;
};

QRectF areaOf(const UnrolledLayer& layer) {
  double left = 1e300, right = -1e300, low = 1e300, high = -1e300;
  const auto take = [&](const QPointF& p) {
    left = std::min(left, p.x());
    right = std::max(right, p.x());
    low = std::min(low, p.y());
    high = std::max(high, p.y());
  };
  for (const QLineF& line : layer.outline) {
    take(line.p1());
    take(line.p2());
  }
  if (layer.outline.empty())
    return {};
  if (layer.periodMm > 0.0) {
    left = -0.5 * layer.periodMm;
    right = 0.5 * layer.periodMm;
  }
  return {left, low, right - left, high - low};
}

double distance(const QPointF& a, const QPointF& b, const QPointF& p) {
  const QPointF ab = b - a, ap = p - a;
  const double length = QPointF::dotProduct(ab, ab);
  const double t = length > 0.0 ? std::clamp(QPointF::dotProduct(ap, ab) / length, 0.0, 1.0) : 0.0;
  const QPointF off = ap - t * ab;
  return std::hypot(off.x(), off.y());
}
} // namespace

bool hasChart(const layers::LayerStack& stack, std::optional<int> layer) {
  return std::any_of(stack.patches.begin(), stack.patches.end(), [&](const layers::Patch& p) {
    return !p.chart.empty() && (!layer || p.layer == *layer);
  });
}

std::shared_ptr<const UnrolledLayer> unrolledLayer(const layers::LayerStack& stack,
                                                   const plan::ToolPlan* plan, int layer,
                                                   const base::RunContext& ctx) {
  auto out = std::make_shared<UnrolledLayer>();
  out->layer = layer;
  std::map<std::size_t, ChartQuery> charts;
  for (std::size_t i = 0; i < stack.patches.size(); ++i) {
    const layers::Patch& patch = stack.patches[i];
    if (patch.layer != layer || patch.chart.empty())
      continue;
    ctx.checkpoint();
    out->periodMm = patch.chart.periodMm;
    addOutline(patch, *out);
    charts.try_emplace(i, patch);
  }
  if (plan) {
    PathWriter writer(*plan, *out);
    for (std::size_t i = 0; i < plan->paths.size(); ++i)
      if (plan->paths[i].layer == layer)
        if (const auto at = charts.find(static_cast<std::size_t>(plan->paths[i].patch));
            at != charts.end())
          writer.add(i, at->second, ctx);
  }
  out->area = areaOf(*out);
  return out;
}

std::optional<UnrolledHit> nearestPath(const UnrolledLayer& layer, const QPointF& place,
                                       double reachMm) {
  std::optional<UnrolledHit> best;
  const QPointF in(layer.periodMm > 0.0 ? std::remainder(place.x(), layer.periodMm) : place.x(),
                   place.y());
  for (const UnrolledLayer::Stretch& s : layer.stretches)
    for (std::size_t i = s.first + 1; i < s.first + s.count; ++i) {
      const double d = distance(layer.points[i - 1], layer.points[i], in);
      if (d <= (best ? best->distanceMm : reachMm))
        best = UnrolledHit{s.path, layer.waypoint[i], s.kind, d};
    }
  return best;
}

std::optional<QPointF> placeOf(const UnrolledLayer& layer, std::size_t waypoint) {
  // The last of a waypoint's points is its own position; the others are at the seam.
  for (std::size_t i = layer.waypoint.size(); i-- > 0;)
    if (layer.waypoint[i] == waypoint)
      return layer.points[i];
  return std::nullopt;
}

} // namespace voluta::window
