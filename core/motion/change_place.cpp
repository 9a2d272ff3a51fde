#include "motion/change_place.h"

#include "base/error.h"
#include "base/units.h"
#include "collision/cell_collision.h"
#include "collision/growing_part.h"
#include "geometry/drop.h"
#include "motion/motion_options.h"
#include "motion/sequence.h"
#include "plan/tool_plan.h"
#include "robot/nozzle_drop.h"
#include "robot/plate.h"
#include "robot/pointing_down.h"

#include <algorithm>
#include <tuple>

namespace voluta::motion {

namespace {
using Eigen::AlignedBox3d, Eigen::Isometry3d, Eigen::Vector3d;
using robot::JointVector;

constexpr double kSpareMm = 30.0;                                         // of drops from the part
constexpr double kWipeMm = 15.0;                                          // beside the place
constexpr std::size_t kMaxPlaces = 12;                                    // places
constexpr double kStepRad = base::degreesToRadians(10.0), kStepMm = 20.0; // of the first joints
constexpr int kSteps = 18;                                                // to each side

AlignedBox3d partBox(const MotionScene& scene) {
  AlignedBox3d box = scene.part.bounds();
  for (const Vector3d& p : scene.plan.position)
    box.extend(p);
  return box;
}

AlignedBox3d plateBox(const robot::Cell& cell) {
  AlignedBox3d box;
  if (const robot::Prism* plate = robot::plateOf(cell))
    for (const Eigen::Vector2d& corner : plate->polygon)
      for (const double z : {plate->zMin, plate->zMax})
        box.extend(Vector3d(corner.x(), corner.y(), z));
  return box;
}

AlignedBox3d boxIn(const AlignedBox3d& box, const Isometry3d& pose) {
  AlignedBox3d all;
  if (box.isEmpty())
    return all;
  for (int k = 0; k < 8; ++k)
    all.extend(pose * box.corner(static_cast<AlignedBox3d::CornerType>(k)));
  return all;
}

class PlaceFinder {
public:
  PlaceFinder(const MotionScene& scene, const JointVector& home)
      : scene_(scene), cell_(scene.cell), home_(home), part_(partBox(scene)),
        plate_(plateBox(scene.cell)) {}

  std::vector<PurgePlace> find() {
    if (part_.isEmpty())
      return {};
    if (cell_.nozzleMount() == robot::Mount::Flange) {
      const std::optional<Vector3d> stated = cell_.purgePlaceMm();
      if (stated)
        tryPoint(cell_.base_T_world(home_) * *stated, 0);
      else
        tryPointsBeside();
      keepFree();
      if (stated)
        return std::move(places_);
    }
    AlignedBox3d beside = part_;
    beside.extend(plate_);
    if (places_.empty())
      moveFirstJoints(beside);
    if (places_.empty())
      moveFirstJoints(part_);
    return std::move(places_);
  }

private:
  struct Candidate {
    int tier;        // lower is better
    double angleRad; // of the joint that moves most from home
    PurgePlace place;
  };

  bool isFree(const JointVector& q) {
    cell_.framePoses(q, frames_);
    return !scene_.collision.bodies(frames_, scene_.options.travelling);
  }
  double largestAngleOf(const JointVector& q) const {
    double maximum = 0.0;
    for (Eigen::Index k = 0; k < q.size(); ++k)
      maximum = std::max(maximum, robot::asAngle(cell_.limits()[static_cast<std::size_t>(k)].kind,
                                                 std::abs(q[k] - home_[k])));
    return maximum;
  }

  // Points around the plate and around the print, in the base.
  void tryPointsBeside() {
    const Isometry3d base_T_work = cell_.base_T_work(home_);
    const AlignedBox3d print = boxIn(part_, base_T_work), plate = boxIn(plate_, base_T_work);
    AlignedBox3d both = print;
    both.extend(plate);
    const double floor = plate.isEmpty() ? print.min().z() : plate.max().z();
    int tier = 0;
    for (const auto& [box, lateralMm] :
         {std::pair(both, kSpareMm + 10.0), std::pair(both, 3.0 * kSpareMm),
          std::pair(print, kSpareMm + 10.0)})
      for (const double upMm : {10.0, 40.0, 100.0}) {
        for (const Vector3d& point : around(box, lateralMm, floor + upMm))
          tryPoint(point, tier);
        ++tier;
      }
  }
  static std::vector<Vector3d> around(const AlignedBox3d& box, double lateralMm, double z) {
    const Vector3d middle = box.center(), half = 0.5 * box.sizes() + Vector3d::Constant(lateralMm);
    std::vector<Vector3d> points;
    for (const double a : {-1.0, -0.5, 0.0, 0.5, 1.0})
      for (const double b : {-1.0, -0.5, 0.0, 0.5, 1.0})
        if (std::max(std::abs(a), std::abs(b)) == 1.0)
          points.emplace_back(middle.x() + a * half.x(), middle.y() + b * half.y(), z);
    return points;
  }

  void tryPoint(const Vector3d& tip, int tier) {
    const Isometry3d work_T_base = cell_.base_T_work(home_).inverse();
    if (geometry::dropMeets(work_T_base * tip, work_T_base.linear() * -Vector3d::UnitZ(),
                            geometry::widened(part_, kSpareMm)))
      return;
    for (const JointVector& q : robot::pointingDownAt(cell_, tip, home_))
      candidates_.push_back({tier, largestAngleOf(q), {q, q}});
  }

  void keepFree() {
    std::ranges::stable_sort(candidates_, {},
                             [](const Candidate& c) { return std::tuple(c.tier, c.angleRad); });
    for (Candidate& c : candidates_) {
      if (places_.size() == kMaxPlaces)
        break;
      if (!isFree(c.place.at))
        continue;
      c.place.wiped = wipedFrom(c.place.at);
      places_.push_back(std::move(c.place));
    }
  }

  // Returns the joints with the nozzle moved aside, away from the print, as far as that is free.
  JointVector wipedFrom(const JointVector& q) {
    const Isometry3d base_T_work = cell_.base_T_work(q);
    Isometry3d base_T_tool = base_T_work * cell_.work_T_tool(q);
    Vector3d away = base_T_tool.translation() - base_T_work * part_.center();
    away.z() = 0.0;
    if (away.norm() < 1.0)
      return q;
    base_T_tool.translation() += kWipeMm * away.normalized();
    JointVector to;
    const Isometry3d work_T_tool = base_T_work.inverse() * base_T_tool;
    constexpr double kMaxRad = base::degreesToRadians(30.0);
    if (!solveNear(cell_, work_T_tool.translation(), Eigen::Quaterniond(work_T_tool.linear()), q,
                   kMaxRad, solutions_, to) ||
        !isFree(to))
      return q;
    return to;
  }

  void moveFirstJoints(const AlignedBox3d& box) {
    for (int step = 0; step <= kSteps && places_.empty(); ++step)
      for (Eigen::Index joint = 0; joint < std::min<Eigen::Index>(2, cell_.armDof()); ++joint)
        for (const int side : {1, -1}) {
          const robot::JointLimits& limits = cell_.limits()[static_cast<std::size_t>(joint)];
          const bool slides = limits.kind == robot::JointKind::Sliding;
          JointVector q = home_;
          q[joint] += side * step * (slides ? kStepMm : kStepRad);
          const bool isTried = joint == 0 || slides; // A second turning joint lowers the arm
          if (!isTried || q[joint] < limits.min || q[joint] > limits.max ||
              robot::dropMeets(cell_, q, geometry::widened(box, kSpareMm)) || !isFree(q))
            continue;
          places_.push_back({q, q});
        }
  }
  const MotionScene& scene_;
  const robot::Cell& cell_;
  const JointVector& home_;
  const AlignedBox3d part_, plate_; // in the work frame
  std::vector<Candidate> candidates_;
  std::vector<PurgePlace> places_;
  std::vector<JointVector> solutions_;
  collision::CellCollision::Frames frames_;
};

// Appends the points in reverse order, from the last one to `first`.
void appendBackwards(const std::vector<TransferPoint>& points, const RobotState& first,
                     std::vector<TransferPoint>& out) {
  for (std::size_t i = points.size(); i-- > 0;)
    out.push_back({i == 0 ? first : points[i - 1].at, points[i].move, points[i].peakDisplacement});
}
} // namespace

std::vector<PurgePlace> purgePlaces(const MotionScene& scene, const JointVector& home) {
  return PlaceFinder(scene, home).find();
}

bool dropsOnPart(const MotionScene& scene, const JointVector& q) {
  constexpr double kNearMm = 10.0;
  return robot::dropMeets(scene.cell, q, geometry::widened(partBox(scene), kNearMm));
}

double primeMm3(const process::Process& process) {
  return process::primeFlow(process) * process.primeS;
}

std::optional<plan::TrajectoryEvent> purgeEvent(const process::Process& process, double mm3) {
  if (!(mm3 > 0.0) || process.tape)
    return std::nullopt;
  return plan::TrajectoryEvent{.kind = plan::EventKind::Purge,
                               .seconds = mm3 / process::primeFlow(process),
                               .volumeMm3 = mm3};
}

std::optional<PurgeTrip> purgeTrip(const MotionScene& scene, const RobotState& rest,
                                   const std::vector<PurgePlace>& places, const Go& go) {
  constexpr std::size_t kSearched = 3; // Places to which a way around obstacles is searched
  for (const bool isStraight : {true, false})
    for (std::size_t i = 0; i < (isStraight ? places.size() : std::min(kSearched, places.size()));
         ++i) {
      const RobotState at = stateAt(scene.cell, places[i].at);
      const auto there = go(rest, at, isStraight);
      if (!there)
        continue;
      PurgeTrip trip{there->points, {}, {}};
      if (places[i].wiped != places[i].at)
        if (const auto wipe = go(at, stateAt(scene.cell, places[i].wiped), true)) {
          trip.wipe = wipe->points;
          appendBackwards(trip.wipe, at, trip.back);
        }
      appendBackwards(trip.there, rest, trip.back);
      return trip;
    }
  if (scene.cell.purgePlaceMm() && scene.cell.nozzleMount() == robot::Mount::Flange)
    throw base::Error(base::ErrorCode::UnusableInput,
                      "the arm does not get to the place for purges without a collision"_text, {},
                      "move the place or the part"_text);
  return std::nullopt;
}

} // namespace voluta::motion
