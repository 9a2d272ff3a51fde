#include "scene/label_places.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

namespace voluta::scene {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kPixelsACell = 4.0;
constexpr int kMaxCells = 320; // per side
constexpr std::int32_t kNobody = -1;

// The nearest body of each cell, and its depth.
struct Cells {
  int columns = 0, rows = 0;
  double pixels = kPixelsACell; // per side of a cell
  std::vector<std::int32_t> body;
  std::vector<float> depth;
  std::vector<bool> through; // the body is visible through the others

  explicit Cells(const LabelView& view) {
    pixels = std::max(kPixelsACell, std::max(view.width, view.height) / double(kMaxCells));
    columns = std::max(1, static_cast<int>(view.width / pixels));
    rows = std::max(1, static_cast<int>(view.height / pixels));
    body.assign(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), kNobody);
    depth.assign(body.size(), std::numeric_limits<float>::infinity());
    through.assign(body.size(), false);
  }
  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(x);
  }
  // Returns the clip coordinates of a cell's centre.
  Vector2d clip(int x, int y) const {
    return {2.0 * (x + 0.5) / columns - 1.0, 2.0 * (y + 0.5) / rows - 1.0};
  }
};

class Painter {
public:
  Painter(Cells& cells, const LabelView& view)
      : cells_(cells), view_(view), world_T_clip_(view.clip_T_world.inverse()) {}

  void paint(const SeenBody& body, std::int32_t id) {
    const Eigen::Matrix4d clip_T_body = view_.clip_T_world * body.world_T_body.matrix();
    corners_.clear();
    for (const Vector3d& p : body.mesh->vertices) {
      const Eigen::Vector4d q = clip_T_body * p.homogeneous();
      // In cells; no depth if behind the eye.
      corners_.push_back(q.w() > 0.0 ? Vector3d(0.5 * (q.x() / q.w() + 1.0) * cells_.columns - 0.5,
                                                0.5 * (q.y() / q.w() + 1.0) * cells_.rows - 0.5,
                                                q.z() / q.w())
                                     : Vector3d(0, 0, std::numeric_limits<double>::quiet_NaN()));
    }
    for (const auto& t : body.mesh->triangles)
      paint(corner(t[0]), corner(t[1]), corner(t[2]), id, body.throughOthers);
  }
  Vector3d placeOf(int x, int y) const {
    const Vector2d at = cells_.clip(x, y);
    return unprojected({at.x(), at.y(), double(cells_.depth[cells_.at(x, y)])});
  }

private:
  const Vector3d& corner(int vertex) const { return corners_[static_cast<std::size_t>(vertex)]; }
  Vector3d unprojected(const Vector3d& clip) const {
    return (world_T_clip_ * clip.homogeneous()).hnormalized();
  }

  void paint(const Vector3d& a, const Vector3d& b, const Vector3d& c, std::int32_t id,
             bool through) {
    const Vector3d low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
    if (std::isnan(a.z() + b.z() + c.z()) || high.x() < 0.0 || high.y() < 0.0 ||
        low.x() > cells_.columns || low.y() > cells_.rows)
      return;
    const int x0 = std::max(0, static_cast<int>(std::ceil(low.x())));
    const int x1 = std::min(cells_.columns - 1, static_cast<int>(std::floor(high.x())));
    const int y0 = std::max(0, static_cast<int>(std::ceil(low.y())));
    const int y1 = std::min(cells_.rows - 1, static_cast<int>(std::floor(high.y())));
    const Vector3d ab = b - a, ac = c - a;
    const double twice = ab.x() * ac.y() - ab.y() * ac.x();
    if (x0 > x1 || y0 > y1 || std::abs(twice) < 1e-12)
      return;
    for (int y = y0; y <= y1; ++y)
      for (int x = x0; x <= x1; ++x) {
        const double dx = x - a.x(), dy = y - a.y();
        const double u = (dx * ac.y() - dy * ac.x()) / twice;
        const double v = (ab.x() * dy - ab.y() * dx) / twice;
        if (u < 0.0 || v < 0.0 || u + v > 1.0)
          continue;
        const auto depth = static_cast<float>(a.z() + u * ab.z() + v * ac.z());
        const std::size_t cell = cells_.at(x, y);
        const bool beforeOthers = through && !cells_.through[cell];
        if ((cells_.through[cell] && !through) || (depth >= cells_.depth[cell] && !beforeOthers))
          continue;
        if (view_.shown) {
          const Vector2d at = cells_.clip(x, y);
          if (!view_.shown(unprojected({at.x(), at.y(), double(depth)})))
            continue;
        }
        cells_.depth[cell] = depth;
        cells_.body[cell] = id;
        cells_.through[cell] = through;
      }
  }

  Cells& cells_;
  const LabelView& view_;
  Eigen::Matrix4d world_T_clip_;
  std::vector<Vector3d> corners_;
};

// Returns each cell's distance to the nearest cell of another body or the view's edge [cells]:
// chamfer distances, 3 to a side and 4 to a corner.
std::vector<float> distancesToOthers(const Cells& cells) {
  constexpr int kSide = 3, kCorner = 4;
  std::vector<int> distance(cells.body.size(), std::numeric_limits<int>::max() / 2);
  const auto relax = [&](int x, int y, int dx, int dy) {
    const std::size_t here = cells.at(x, y);
    const int step = dx != 0 && dy != 0 ? kCorner : kSide;
    const int nx = x + dx, ny = y + dy;
    const bool inside = nx >= 0 && ny >= 0 && nx < cells.columns && ny < cells.rows;
    const bool own = inside && cells.body[cells.at(nx, ny)] == cells.body[here];
    distance[here] = std::min(distance[here], step + (own ? distance[cells.at(nx, ny)] : 0));
  };
  for (int y = 0; y < cells.rows; ++y)
    for (int x = 0; x < cells.columns; ++x)
      for (const auto& [dx, dy] : {std::pair(-1, 0), {-1, -1}, {0, -1}, {1, -1}})
        relax(x, y, dx, dy);
  for (int y = cells.rows - 1; y >= 0; --y)
    for (int x = cells.columns - 1; x >= 0; --x)
      for (const auto& [dx, dy] : {std::pair(1, 0), {1, 1}, {0, 1}, {-1, 1}})
        relax(x, y, dx, dy);
  std::vector<float> out;
  for (const int d : distance)
    out.push_back(static_cast<float>(d) / kSide);
  return out;
}

struct Best {
  float radius = 0.0F; // cells
  int x = 0, y = 0;
};

} // namespace

std::vector<std::optional<Vector3d>> labelPlaces(const std::vector<SeenBody>& bodies,
                                                 const LabelView& view) {
  std::vector<std::optional<Vector3d>> places(bodies.size());
  if (view.width <= 0 || view.height <= 0 || !(std::abs(view.clip_T_world.determinant()) > 0.0))
    return places;
  Cells cells(view);
  Painter painter(cells, view);
  for (std::size_t i = 0; i < bodies.size(); ++i)
    painter.paint(bodies[i], static_cast<std::int32_t>(i));

  const std::vector<float> distance = distancesToOthers(cells);
  std::vector<Best> best(bodies.size());
  for (int y = 0; y < cells.rows; ++y)
    for (int x = 0; x < cells.columns; ++x)
      if (const std::int32_t id = cells.body[cells.at(x, y)]; id != kNobody)
        if (Best& one = best[static_cast<std::size_t>(id)]; distance[cells.at(x, y)] > one.radius)
          one = {distance[cells.at(x, y)], x, y};
  std::vector<std::size_t> order(bodies.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(bodies[a].throughOthers, best[a].radius) >
           std::pair(bodies[b].throughOthers, best[b].radius);
  });
  std::vector<Vector2d> taken; // in pixels
  for (const std::size_t i : order) {
    if (best[i].radius <= 0.0F || best[i].radius * cells.pixels < view.minRadius)
      continue;
    const Vector2d at = cells.pixels * Vector2d(best[i].x, best[i].y);
    if (std::any_of(taken.begin(), taken.end(),
                    [&](const Vector2d& other) { return (other - at).norm() < view.apart; }))
      continue;
    taken.push_back(at);
    places[i] = bodies[i].world_T_body.inverse() * painter.placeOf(best[i].x, best[i].y);
  }
  return places;
}

} // namespace voluta::scene
