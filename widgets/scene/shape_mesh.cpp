#include "scene/shape_mesh.h"

#include "base/units.h"

#include <cmath>

namespace voluta::scene {

namespace {

constexpr int kAround = 32, kBands = 8;

// A ring about an axis: height along it, radius, and the normal's component along it.
struct Ring {
  double height, radius, slope;
};

class ShapeMesher {
public:
  explicit ShapeMesher(MeshBuffers& out) : out_(out) {}

  void operator()(const robot::Capsule& c) const {
    const double length = (c.p1 - c.p0).norm();
    std::vector<Ring> rings;
    for (int i = 0; i <= kBands; ++i) {
      const double a = base::kPi / 2 * (double(i) / kBands - 1.0);
      rings.push_back({c.radius * std::sin(a), c.radius * std::cos(a), std::sin(a)});
    }
    for (int i = 0; i <= kBands; ++i) {
      const double a = base::kPi / 2 * i / kBands;
      rings.push_back({length + c.radius * std::sin(a), c.radius * std::cos(a), std::sin(a)});
    }
    revolve(c.p0, c.p1 - c.p0, rings);
  }

  void operator()(const robot::Frustum& f) const {
    const double length = (f.p1 - f.p0).norm();
    const double slope = (f.r0 - f.r1) / std::hypot(length, f.r0 - f.r1);
    revolve(f.p0, f.p1 - f.p0, {{0, 0, -1}, {0, f.r0, -1}});
    revolve(f.p0, f.p1 - f.p0, {{0, f.r0, slope}, {length, f.r1, slope}});
    revolve(f.p0, f.p1 - f.p0, {{length, f.r1, 1}, {length, 0, 1}});
  }

  void operator()(const robot::Box& b) const {
    for (int axis = 0; axis < 3; ++axis)
      for (const int side : {-1, 1}) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        std::int32_t corner[4];
        for (int k = 0; k < 4; ++k) {
          Eigen::Vector3d p = Eigen::Vector3d::Zero();
          p[axis] = side * b.half[axis];
          p[u] = (k == 1 || k == 2 ? 1 : -1) * b.half[u];
          p[v] = (k >= 2 ? 1 : -1) * b.half[v];
          const Eigen::Vector3d normal = side * Eigen::Vector3d::Unit(axis);
          corner[k] = out_.addPoint(b.frame_T_box * p, b.frame_T_box.linear() * normal);
        }
        out_.addQuad(corner[0], corner[1], corner[2], corner[3]);
      }
  }

  void operator()(const robot::Prism& p) const {
    const std::size_t n = p.polygon.size();
    std::vector<std::int32_t> top, bottom;
    for (std::size_t i = 0; i < n; ++i) {
      const Eigen::Vector2d &a = p.polygon[i], &b = p.polygon[(i + 1) % n];
      const Eigen::Vector2d along = (b - a).normalized();
      const Eigen::Vector3d normal(along.y(), -along.x(), 0.0);
      out_.addQuad(out_.addPoint({a.x(), a.y(), p.zMin}, normal),
                   out_.addPoint({b.x(), b.y(), p.zMin}, normal),
                   out_.addPoint({b.x(), b.y(), p.zMax}, normal),
                   out_.addPoint({a.x(), a.y(), p.zMax}, normal));
      top.push_back(out_.addPoint({a.x(), a.y(), p.zMax}, Eigen::Vector3d::UnitZ()));
      bottom.push_back(out_.addPoint({a.x(), a.y(), p.zMin}, -Eigen::Vector3d::UnitZ()));
    }
    for (std::size_t i = 2; i < n; ++i) {
      out_.addTriangle(top[0], top[i - 1], top[i]);
      out_.addTriangle(bottom[0], bottom[i], bottom[i - 1]);
    }
  }

private:
  void revolve(const Eigen::Vector3d& origin, const Eigen::Vector3d& axis,
               const std::vector<Ring>& rings) const {
    const Eigen::Vector3d w = axis.norm() > 0 ? axis.normalized() : Eigen::Vector3d::UnitZ();
    const Eigen::Vector3d u = w.unitOrthogonal(), v = w.cross(u);
    std::int32_t before = 0;
    for (std::size_t r = 0; r < rings.size(); ++r) {
      const auto first = static_cast<std::int32_t>(out_.points.size() / 3);
      for (int i = 0; i < kAround; ++i) {
        const double a = 2 * base::kPi * i / kAround;
        const Eigen::Vector3d out = std::cos(a) * u + std::sin(a) * v;
        const double side = std::sqrt(std::max(0.0, 1 - rings[r].slope * rings[r].slope));
        out_.addPoint(origin + rings[r].height * w + rings[r].radius * out,
                      side * out + rings[r].slope * w);
      }
      for (int i = 0; r > 0 && i < kAround; ++i) {
        const int next = (i + 1) % kAround;
        out_.addQuad(before + i, before + next, first + next, first + i);
      }
      before = first;
    }
  }

  MeshBuffers& out_;
};

} // namespace

void addShape(MeshBuffers& buffers, const robot::Shape& shape) {
  std::visit(ShapeMesher(buffers), shape);
}

} // namespace voluta::scene
