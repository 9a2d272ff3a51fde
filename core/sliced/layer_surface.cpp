#include "sliced/layer_surface.h"

#include "base/error.h"
#include "base/run_context.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

namespace voluta::sliced {

namespace {
using Eigen::Vector2d, Eigen::Vector3d, Eigen::Vector3i;

constexpr double kMaxShift = 0.45; // [cells]
constexpr float kFar = std::numeric_limits<float>::infinity();

// The beads of one slab, per cell.
struct Outlines {
  int slab = -1;
  std::vector<float> distance;    // From the outline [mm]; negative within a bead
  std::vector<float> bottom, top; // Of the beads that contain the cell's centre
};

struct Mean {
  Vector2d sum = Vector2d::Zero();
  int count = 0;
};

class Fitting {
public:
  Fitting(const voxel::VoxelObject& object, const plan::ToolPlan& plan, const LayerSlabs& slabs,
          const LayerMask::Field& field)
      : object_(object), plan_(plan), slabs_(slabs), field_(field) {}

  // Returns the place of a corner of the cells [mm].
  Vector3d placed(const Vector3i& corner) {
    const Outlines* below = outlinesOf(corner.z() - 1);
    const Outlines* above = outlinesOf(corner.z());
    Mean side;
    for (const Outlines* slab : {below, above})
      if (slab)
        addCrossings(corner, *slab, side);
    Vector2d level = corner.head<2>().cast<double>();
    if (side.count > 0)
      level += (side.sum / side.count).cwiseMax(-kMaxShift).cwiseMin(kMaxShift);
    const Vector2d at = field_.origin + field_.pitch * level;
    return {at.x(), at.y(), heightOf(corner, below, above)};
  }

private:
  const Outlines* outlinesOf(int slab) {
    if (slab < 0 || slab >= object_.size.z())
      return nullptr;
    Outlines& kept = kept_[static_cast<std::size_t>(slab) % kept_.size()];
    if (kept.slab == slab)
      return &kept;
    const auto cells =
        static_cast<std::size_t>(field_.width) * static_cast<std::size_t>(field_.depth);
    kept.slab = slab;
    kept.distance.assign(cells, kFar);
    kept.bottom.assign(cells, kFar);
    kept.top.assign(cells, -kFar);
    for (const LayerSlabs::Segment& s : slabs_.segments(static_cast<std::size_t>(slab)))
      add(s.end, kept);
    return &kept;
  }

  void add(std::size_t end, Outlines& to) const {
    constexpr double kMargin = 1.5; // [cells] beyond the outline
    const Vector3d &a = plan_.position[end - 1], &b = plan_.position[end];
    LayerMask::eachNear(
        field_, plan_, end, kMargin * field_.pitch, [&](std::size_t c, double distance, double t) {
          to.distance[c] = std::min(to.distance[c], static_cast<float>(distance));
          if (distance > 0.0)
            return;
          const double top = std::lerp(a.z(), b.z(), t);
          const double height = std::lerp(plan_.heightMm[end - 1], plan_.heightMm[end], t);
          to.top[c] = std::max(to.top[c], static_cast<float>(top));
          to.bottom[c] = std::min(to.bottom[c], static_cast<float>(top - height));
        });
  }

  bool isSolid(const Vector3i& cell) const { return object_.solidAt(cell.x(), cell.y(), cell.z()); }
  float valueAt(const std::vector<float>& values, const Vector3i& cell) const {
    return cell.x() < 0 || cell.y() < 0 || cell.x() >= field_.width || cell.y() >= field_.depth
               ? kFar
               : values[static_cast<std::size_t>(cell.x()) +
                        static_cast<std::size_t>(field_.width) *
                            static_cast<std::size_t>(cell.y())];
  }

  // Adds the places [cells, from the corner] where the outline crosses the ring through the centres
  // of the four cells around a corner in one slab.
  void addCrossings(const Vector3i& corner, const Outlines& slab, Mean& mean) const {
    constexpr std::array<std::array<int, 2>, 4> kRing{{{-1, -1}, {0, -1}, {0, 0}, {-1, 0}}};
    for (std::size_t k = 0; k < kRing.size(); ++k) {
      const auto cellOf = [&](std::size_t n) {
        const auto& step = kRing[n % kRing.size()];
        return Vector3i(corner.x() + step[0], corner.y() + step[1], slab.slab);
      };
      Vector3i in = cellOf(k), out = cellOf(k + 1);
      if (isSolid(in) == isSolid(out))
        continue;
      if (!isSolid(in))
        std::swap(in, out);
      const Vector2d centre = (in - corner).head<2>().cast<double>() + Vector2d::Constant(0.5);
      mean.sum += centre + crossingShare(in, out, slab) * (out - in).head<2>().cast<double>();
      ++mean.count;
    }
  }

  // Returns where the outline is on the way from a solid cell to an empty one, 0 to 1; the middle
  // if no bead ends between them.
  double crossingShare(const Vector3i& in, const Vector3i& out, const Outlines& slab) const {
    const double within = valueAt(slab.distance, in), beyond = valueAt(slab.distance, out);
    return within <= 0.0 && beyond > 0.0 && beyond < kFar ? within / (within - beyond) : 0.5;
  }

  // Returns the height of a corner [mm]: that of the tops or bottoms of the beads beside it.
  double heightOf(const Vector3i& corner, const Outlines* below, const Outlines* above) const {
    double sum = 0.0;
    int count = 0;
    for (int column = 0; column < 4; ++column) {
      const Vector3i over = corner + Vector3i(column % 2 - 1, column / 2 - 1, 0);
      const bool solidBelow = isSolid(over - Vector3i::UnitZ());
      if (solidBelow == isSolid(over))
        continue;
      const float z = solidBelow ? valueAt(below->top, over) : valueAt(above->bottom, over);
      if (std::isinf(z))
        continue;
      sum += static_cast<double>(z);
      ++count;
    }
    const double bound = slabs_.heightAt(corner.z());
    if (count == 0)
      return bound;
    const auto toward = [&](int next, int other) {
      const bool exists = next >= 0 && next <= object_.size.z();
      return kMaxShift * std::abs(slabs_.heightAt(exists ? next : other) - bound);
    };
    const int lower = corner.z() - 1, upper = corner.z() + 1;
    return std::clamp(sum / count, bound - toward(lower, upper), bound + toward(upper, lower));
  }

  const voxel::VoxelObject& object_;
  const plan::ToolPlan& plan_;
  const LayerSlabs& slabs_;
  const LayerMask::Field& field_;
  std::array<Outlines, 3> kept_; // Of the slabs used last
};

bool isBetween(const Vector3d& vertex, int axis) {
  return vertex[axis] != std::floor(vertex[axis]);
}
} // namespace

geometry::TriangleMesh surfaceOfLayers(const voxel::VoxelObject& object, const plan::ToolPlan& plan,
                                       const LayerSlabs& slabs, const LayerMask::Field& field,
                                       const base::RunContext& ctx) {
  base::require(object.size == Vector3i(field.width, field.depth, static_cast<int>(slabs.count())),
                "an object of the size of field and slabs");
  geometry::TriangleMesh mesh = voxel::surfaceOf(object);
  std::vector<std::size_t> order(mesh.vertices.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t v) { return mesh.vertices[v].z(); });
  Fitting fitting(object, plan, slabs, field);
  for (std::size_t n = 0; n < order.size(); ++n) {
    if (n % 4096 == 0)
      ctx.checkpoint();
    Vector3d& vertex = mesh.vertices[order[n]];
    // A vertex in the middle of an edge is between its ends.
    Vector3i low = vertex.array().floor().cast<int>(), high = low;
    for (int axis = 0; axis < 3; ++axis)
      high[axis] += isBetween(vertex, axis);
    vertex = low == high ? fitting.placed(low)
                         : Vector3d(0.5 * (fitting.placed(low) + fitting.placed(high)));
  }
  return mesh;
}

} // namespace voluta::sliced
