#include "together/static_conflicts.h"

#include "base/parallel.h"
#include "collision/cell_collision.h"
#include "collision/growing_part.h"
#include "collision/margins.h"
#include "collision/shape_distance.h"
#include "plan/tool_plan.h"
#include "robot/body.h"
#include "robot/cell.h"
#include "together/poses.h"
#include "voxel/voxel_grid.h"

#include <algorithm>
#include <utility>

namespace voluta::together {

using Eigen::Isometry3d;
using robot::BodyRole;

namespace {
constexpr double kStepMm = 2.0;

class Checker {
public:
  Checker(const PlacedMotion& machine, const PlacedMotion& other, const collision::Margins& margins)
      : machine_(machine), other_(other), margins_(margins), rest_(framesAt(other, 0)),
        head_(machine.collision->erodedHead()) {
    for (std::size_t b = 0; b < bodies().size(); ++b)
      if (isMoved(*machine.cell, bodies()[b]))
        moved_.push_back(static_cast<int>(b));
    for (std::size_t b = 0; b < other.cell->bodies().size(); ++b)
      if (!isMoved(*other.cell, other.cell->bodies()[b]))
        atRest_.push_back(static_cast<int>(b));
  }

  std::optional<std::pair<int, int>> bodyContact(const Frames& frames) const {
    for (const int a : moved_)
      for (const int b : atRest_)
        if (areChecked(a, b) && isNear(a, b, frames))
          return std::pair(a, b);
    return std::nullopt;
  }

  // Returns the least number of printed waypoints with which the pose meets the part, if it is
  // below `minimum`; else `minimum`.
  std::size_t meets(const Frames& frames, std::size_t minimum) const {
    if (isPartMoved(*other_.cell))
      return minimum;
    const Isometry3d work_T_shared =
        rest_[static_cast<std::size_t>(other_.cell->workFrame())].inverse(Eigen::Isometry);
    const std::size_t all = other_.toolPlan->waypointCount();
    for (const int a : moved_) {
      const robot::Body& body = bodies()[static_cast<std::size_t>(a)];
      const Isometry3d pose = work_T_shared * frames[static_cast<std::size_t>(body.frame)];
      const bool isHead = body.role == BodyRole::Head;
      const double margin =
          isHead ? margins_.headMm - 0.5 * other_.part->grid().pitch : margins_.partMm;
      for (const robot::Shape& shape : isHead ? head_ : body.shapes) {
        const auto touches = [&](std::size_t before) {
          return other_.part->touches(shape, pose, margin, before);
        };
        if (!touches(std::min(all, minimum == kNever ? all : minimum - 1)))
          continue;
        std::size_t clear = 0, meets = std::min(all, minimum == kNever ? all : minimum - 1);
        if (touches(0))
          return 0;
        while (meets - clear > 1) {
          const std::size_t middle = clear + (meets - clear) / 2;
          (touches(middle) ? meets : clear) = middle;
        }
        minimum = meets;
      }
    }
    return minimum;
  }

private:
  const std::vector<robot::Body>& bodies() const { return machine_.cell->bodies(); }

  bool isAgainstObstacles(int a) const {
    const auto isObstacle = [&](int b) {
      return bodies()[static_cast<std::size_t>(b)].role == BodyRole::Obstacle;
    };
    const bool hasObstacles = std::ranges::any_of(
        bodies(), [](const robot::Body& body) { return body.role == BodyRole::Obstacle; });
    return !hasObstacles || std::ranges::any_of(machine_.cell->checkedPairs(), [&](auto pair) {
      return (pair.first == a && isObstacle(pair.second)) ||
             (pair.second == a && isObstacle(pair.first));
    });
  }
  bool areChecked(int a, int b) const {
    return other_.cell->bodies()[static_cast<std::size_t>(b)].role != BodyRole::Obstacle ||
           isAgainstObstacles(a);
  }
  bool isNear(int a, int b, const Frames& frames) const {
    const robot::Body &body = bodies()[static_cast<std::size_t>(a)],
                      &still = other_.cell->bodies()[static_cast<std::size_t>(b)];
    const bool isAtPlate = body.role == BodyRole::Head && still.role == BodyRole::Platform;
    const double margin = isAtPlate ? margins_.headMm : margins_.bodiesMm;
    return machine_.collision->distanceToOther(
               a, frames[static_cast<std::size_t>(body.frame)], *other_.collision, b,
               rest_[static_cast<std::size_t>(still.frame)], margin) <= margin;
  }

  const PlacedMotion &machine_, &other_;
  const collision::Margins& margins_;
  const Frames rest_; // of the other machine
  const std::vector<robot::Shape> head_;
  std::vector<int> moved_, atRest_;
};
} // namespace

std::optional<Eigen::Vector3d> partOverlap(const PlacedMotion& machine, const PlacedMotion& other) {
  if (isPartMoved(*machine.cell) || isPartMoved(*other.cell))
    return std::nullopt;
  const Frames own = framesAt(machine, 0), rest = framesAt(other, 0);
  const Isometry3d& shared_T_own = own[static_cast<std::size_t>(machine.cell->workFrame())];
  const Isometry3d work_T_shared =
      rest[static_cast<std::size_t>(other.cell->workFrame())].inverse(Eigen::Isometry);
  std::vector<collision::PlacedShape> solids;
  for (const robot::Body& body : other.cell->bodies())
    if (!isMoved(*other.cell, body))
      for (const robot::Shape& shape : body.shapes)
        solids.push_back(collision::place(shape, rest[static_cast<std::size_t>(body.frame)]));
  const voxel::VoxelGrid& grid = machine.part->grid();
  for (std::size_t c = 0; c < grid.cellCount(); ++c) {
    if (machine.part->filledAt(c) == collision::GrowingPart::kNeverFilled)
      continue;
    const Eigen::Vector3i at = grid.cell(c);
    const Eigen::Vector3d point = shared_T_own * grid.centre(at.x(), at.y(), at.z());
    const auto isInside = [&](const collision::PlacedShape& solid) {
      return collision::signedDistance(solid, point) < -0.5 * grid.pitch;
    };
    if (other.part->holds(work_T_shared * point, other.toolPlan->waypointCount()) ||
        std::ranges::any_of(solids, isInside))
      return point;
  }
  return std::nullopt;
}

StaticConflicts staticConflicts(const PlacedMotion& machine, const Rests& rests,
                                const PlacedMotion& other, const collision::Margins& margins,
                                const base::RunContext& ctx) {
  const Checker checker(machine, other, margins);
  StaticConflicts found;
  found.bodies.resize(rests.segments());
  found.segmentMeets.assign(rests.segments(), kNever);
  found.restMeets.assign(rests.point.size(), kNever);
  base::parallelChunks(ctx, rests.segments(), 1, [&](std::size_t i, std::size_t) {
    std::size_t& meets = found.segmentMeets[i];
    visitPoses(machine, rests.point[i], rests.point[i + 1], kStepMm, [&](const Frames& frames) {
      meets = meets == 0 ? 0 : checker.meets(frames, meets);
      if (found.bodies[i])
        return;
      if (const auto pair = checker.bodyContact(frames))
        found.bodies[i] = {
            i, pair->first, pair->second,
            frames[static_cast<std::size_t>(machine.cell->toolFrame())].translation()};
    });
  });
  base::parallelChunks(ctx, rests.point.size(), 1, [&](std::size_t i, std::size_t) {
    found.restMeets[i] = checker.meets(framesAt(machine, rests.point[i]), kNever);
  });
  return found;
}

} // namespace voluta::together
