#include "build3mf/bead_cells.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/run_context.h"
#include "process/bead_model.h"
#include "voxel/voxel_object.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace voluta::build3mf {

using Eigen::Vector3d;
using Eigen::Vector3i;

namespace {

constexpr double kMaxCells = 1 << 27;
constexpr std::size_t kSlabs = 16; // of levels that are filled at the same time

bool isOfPart(const plan::ToolPath& path) {
  return path.kind != plan::PathKind::Support && path.kind != plan::PathKind::Tape &&
         path.kind != plan::PathKind::Shot && !plan::isWaste(path.kind);
}

// The volume of one segment: flat where its path begins and ends, rounded where it continues.
struct Room {
  Room(const plan::ToolPlan& plan, const plan::ToolPath& path, std::size_t i)
      : a(plan.position[i]), b(plan.position[i + 1]), up(plan.direction[i]),
        opensBehind(i == path.first && !path.closed),
        opensAhead(i + 2 == path.first + path.count && !path.closed) {
    const auto mean = [i](const std::vector<float>& v) { return 0.5 * (v[i] + v[i + 1]); };
    height = mean(plan.heightMm);
    half = 0.5 * process::hatchOf(mean(plan.widthMm), height);
    up = (up + plan.direction[i + 1]).normalized();
  }

  Eigen::AlignedBox3d box() const {
    Eigen::AlignedBox3d all(a);
    all.extend(b);
    const Vector3d around = Vector3d::Constant(half + height);
    return {all.min() - around, all.max() + around};
  }

  bool holds(const Vector3d& centre) const {
    const Vector3d along = b - a;
    const double length2 = along.squaredNorm();
    double t = length2 > 0.0 ? (centre - a).dot(along) / length2 : 0.0;
    if ((t < 0.0 && opensBehind) || (t > 1.0 && opensAhead))
      return false;
    t = std::clamp(t, 0.0, 1.0);
    const Vector3d off = centre - (a + t * along);
    const double depth = -off.dot(up);
    return depth >= 0.0 && depth <= height && (off + depth * up).squaredNorm() <= half * half;
  }

  Vector3d a, b, up;
  double half = 0.0, height = 0.0;
  bool opensBehind, opensAhead;
};

template <typename Take> void eachRoom(const plan::ToolPlan& plan, const Take& take) {
  for (const plan::ToolPath& path : plan.paths)
    if (isOfPart(path))
      for (std::size_t i = path.first; i + 1 < path.first + path.count; ++i)
        take(Room(plan, path, i));
}

} // namespace

geometry::TriangleMesh solidOfBeads(const plan::ToolPlan& plan, double pitchMm,
                                    const base::RunContext& ctx) {
  base::require(pitchMm > 0.0, "pitch > 0");
  base::require(plan.direction.size() == plan.waypointCount() &&
                    plan.widthMm.size() == plan.waypointCount() &&
                    plan.heightMm.size() == plan.waypointCount(),
                "plan arrays of one length");
  Eigen::AlignedBox3d box;
  bool sections = true;
  eachRoom(plan, [&](const Room& room) {
    sections = sections && room.half > 0.0 && room.height > 0.0;
    box.extend(room.box());
  });
  if (box.isEmpty() || !sections)
    throw base::Error(base::ErrorCode::UnusableInput,
                      "contains neither an object nor beads with width and height"_text);
  voxel::VoxelGrid grid;
  grid.pitch = std::max(pitchMm, std::cbrt(box.volume() / kMaxCells));
  grid.origin = (box.min() / grid.pitch).array().floor().matrix() * grid.pitch;
  const Vector3d cells = ((box.max() - grid.origin) / grid.pitch).array().ceil();
  if (!(cells.prod() <= 2.0 * kMaxCells))
    throw base::Error(base::ErrorCode::UnusableInput,
                      "the beads extend too far to be filled with cells"_text);
  grid.size = cells.cast<int>().cwiseMax(1);
  voxel::VoxelObject object;
  object.size = grid.size;
  object.solid.assign(grid.cellCount(), 0);
  const auto levels = static_cast<std::size_t>(grid.size.z());
  base::parallelChunks(
      ctx, levels, (levels + kSlabs - 1) / kSlabs, [&](std::size_t begin, std::size_t end) {
        std::size_t rooms = 0;
        bool isCancelled = false;
        eachRoom(plan, [&](const Room& room) {
          if (++rooms % 1024 == 0 && ctx.cancelled())
            isCancelled = true;
          if (isCancelled)
            return;
          const Eigen::AlignedBox3d around = room.box();
          const Vector3i low = grid.cellOf(around.min()).cwiseMax(0);
          const Vector3i high = grid.cellOf(around.max()).cwiseMin(grid.size - Vector3i::Ones());
          for (int k = std::max(low.z(), static_cast<int>(begin));
               k <= std::min(high.z(), static_cast<int>(end) - 1); ++k)
            for (int j = low.y(); j <= high.y(); ++j)
              for (int i = low.x(); i <= high.x(); ++i)
                if (room.holds(grid.centre(i, j, k)))
                  object.solid[grid.index(i, j, k)] = 1;
        });
      });
  ctx.checkpoint();
  geometry::TriangleMesh solid = voxel::surfaceOf(object);
  if (solid.empty())
    throw base::Error(base::ErrorCode::UnusableInput,
                      "the beads are too thin to be filled with cells"_text);
  for (Vector3d& v : solid.vertices)
    v = grid.origin + grid.pitch * v;
  return solid;
}

} // namespace voluta::build3mf
