#include "cells/cell_check.h"

#include "base/units.h"
#include "cells/reach_map.h"
#include "collision/cell_collision.h"
#include "collision/shape_distance.h"
#include "process/head_shapes.h"
#include "robot/plate.h"
#include "robot/pointing_down.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace voluta::cells {

namespace {

using collision::CellCollision;
using collision::Contact;
using robot::BodyRole;

using Frames = std::vector<Eigen::Isometry3d>;

Frames framesAtRest(const robot::Cell& cell) {
  Frames frames;
  cell.framePoses(cell.home(), frames);
  return frames;
}

// Returns the pose with the nozzle's z against the plate's.
Eigen::Isometry3d upright(const Eigen::Vector3d& tip, double rotation) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = tip;
  pose.linear() = Eigen::AngleAxisd(rotation, Eigen::Vector3d::UnitZ()).toRotationMatrix() *
                  Eigen::Vector3d(1, -1, -1).asDiagonal();
  return pose;
}

double headMm(const process::Process& process) {
  return process.head.sections.empty() ? 0.0 : process.head.sections.back().zMm;
}

void checkHead(const process::Process& process, std::vector<CellFault>& faults) {
  if (const auto reason = process::upsideDown(process.head))
    faults.push_back(
        {*reason, base::message("turn the head of process {process} over"_text, process.id)});
}

void checkNozzle(const robot::Cell& cell, const process::Process& process, const Frames& frames,
                 std::vector<CellFault>& faults) {
  const Eigen::Isometry3d& tool = frames[static_cast<std::size_t>(cell.toolFrame())];
  for (const robot::Body& body : cell.bodies()) {
    if (body.role != BodyRole::Link && body.role != BodyRole::Obstacle)
      continue;
    const Eigen::Isometry3d frame_T_base =
        frames[static_cast<std::size_t>(body.frame)].inverse(Eigen::Isometry);
    for (const double height : {0.0, 0.5 * headMm(process)}) {
      const Eigen::Vector3d at = frame_T_base * (tool * Eigen::Vector3d(0, 0, -height));
      if (std::ranges::none_of(body.shapes, [&](const robot::Shape& shape) {
            return collision::signedDistance(shape, at) < 0.0;
          }))
        continue;
      faults.push_back({base::message("the nozzle is inside {body}"_text, robot::nameOf(body)),
                        "move the nozzle's frame"_text});
      return;
    }
  }
}

void checkRest(const CellCollision& collision, const Frames& frames,
               std::vector<CellFault>& faults) {
  if (const auto contact = collision.bodies(frames, {}))
    faults.push_back(
        {base::message("in the home pose {first} collides with {second}"_text,
                       collision.nameOf(contact->first), collision.nameOf(contact->second)),
         "move one of them, or choose another home pose"_text});
}

// Returns a lattice of 5 x 5 over the plate's bounding box, restricted to the plate.
ReachGrid coarseGrid(const robot::Prism& plate, const process::Process& process) {
  constexpr double kAcross = 5.0;
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& corner : plate.polygon)
    box.extend(corner);
  ReachGrid grid;
  grid.spacingMm = box.sizes().maxCoeff() / kAcross;
  grid.heightsMm = {process.layerHeightMm};
  grid.tiltsRad = {0.0};
  grid.azimuths = 1;
  grid.turns = 12;
  return grid;
}

// Returns the pair of bodies that collides most often where the arm reaches. At each place only the
// solution with the smallest joint motion from home counts. Returns nullopt if the arm reaches no
// place or nothing collides.
std::optional<Contact> commonestContact(const robot::Cell& cell, const CellCollision& collision,
                                        const collision::Margins& margins, const ReachMap& map,
                                        const base::RunContext& ctx) {
  std::map<std::pair<int, int>, int> times;
  std::vector<robot::JointVector> solutions;
  Frames frames;
  for (const Eigen::Vector2d& at : map.points()) {
    ctx.checkpoint();
    double minimum = INFINITY;
    robot::JointVector nearest;
    for (const robot::JointVector& axes : axisPlaces(cell, map.grid().axisPlaces))
      for (int rotation = 0; rotation < map.grid().turns; ++rotation) {
        robot::JointVector near = cell.home();
        near.tail(axes.size()) = axes;
        cell.inverse(upright({at.x(), at.y(), map.grid().heightsMm.front()},
                             base::kTwoPi * rotation / map.grid().turns),
                     near, solutions);
        for (const robot::JointVector& q : solutions)
          if (const double turned = robot::asAngles(q - cell.home(), cell.limits()).norm();
              turned < minimum) {
            minimum = turned;
            nearest = q;
          }
      }
    if (nearest.size() == 0)
      continue;
    cell.framePoses(nearest, frames);
    if (const auto contact = collision.bodies(frames, margins))
      ++times[{contact->first, contact->second}];
  }
  if (times.empty())
    return std::nullopt;
  const auto maximum =
      std::ranges::max_element(times, {}, [](const auto& entry) { return entry.second; });
  return Contact{maximum->first.first, maximum->first.second};
}

void checkPlate(const robot::Cell& cell, const process::Process& process,
                const CellCollision& collision, const collision::Margins& margins,
                const base::RunContext& ctx, std::vector<CellFault>& faults) {
  const robot::Prism* plate = robot::plateOf(cell);
  if (!plate)
    return;
  const ReachMap map = reachMap(cell, process, coarseGrid(*plate, process), margins, ctx);
  if (map.shareOfTilt(0) > 0.0)
    return;
  if (const auto contact = commonestContact(cell, collision, margins, map, ctx))
    faults.push_back(
        {base::message("wherever the nozzle reaches the plate, {first} collides with "
                       "{second}"_text,
                       collision.nameOf(contact->first), collision.nameOf(contact->second)),
         "move one of them, or make the stem or the nozzle longer"_text});
  else
    faults.push_back({"the plate is out of the arm's reach"_text,
                      "bring plate and nozzle nearer to the arm"_text});
}

void checkLoad(const robot::Cell& cell, double partKg, std::vector<CellFault>& faults) {
  const double carried =
      cell.carriedKg() + (cell.nozzleMount() == robot::Mount::World ? partKg : 0.0);
  if (const std::optional<double>& maximum = cell.robot().payloadKg; maximum && carried > *maximum)
    faults.push_back({base::message("payload {carried:.3g} kg exceeds the robot's rating of "
                                    "{most:.3g} kg"_text,
                                    base::number(carried), base::number(*maximum)),
                      "reduce the payload, or use a stronger robot"_text});
}

void checkPurgePlace(const robot::Cell& cell, const CellCollision& collision,
                     std::vector<CellFault>& faults) {
  const std::optional<Eigen::Vector3d>& place = cell.purgePlaceMm();
  if (!place)
    return;
  const robot::JointVector home = cell.home();
  const std::vector<robot::JointVector> solutions =
      robot::pointingDownAt(cell, cell.base_T_world(home) * *place, home);
  Frames frames;
  const bool isFree = std::ranges::any_of(solutions, [&](const robot::JointVector& q) {
    cell.framePoses(q, frames);
    return !collision.bodies(frames, {});
  });
  if (solutions.empty())
    faults.push_back(
        {"the arm does not reach the place for purges"_text, "move the place for purges"_text});
  else if (!isFree)
    faults.push_back(
        {"the arm collides at the place for purges"_text, "move the place for purges"_text});
}
} // namespace

std::vector<CellFault> cellFaults(const robot::Cell& cell, const process::Process& process,
                                  double partKg, const base::RunContext& ctx) {
  const CellCollision collision(cell, process);
  const Frames frames = framesAtRest(cell);
  std::vector<CellFault> faults;
  checkHead(process, faults);
  checkNozzle(cell, process, frames, faults);
  checkRest(collision, frames, faults);
  checkPlate(cell, process, collision, {}, ctx, faults);
  checkPurgePlace(cell, collision, faults);
  checkLoad(cell, partKg, faults);
  return faults;
}

std::vector<CellFault> printingFaults(const robot::Cell& cell, const process::Process& process,
                                      const collision::Margins& margins,
                                      const base::RunContext& ctx) {
  const CellCollision collision(cell, process);
  std::vector<CellFault> faults;
  checkRest(collision, framesAtRest(cell), faults);
  checkPlate(cell, process, collision, margins, ctx, faults);
  return faults;
}

std::optional<robot::JointVector> clearestRest(const robot::Cell& cell,
                                               const process::Process& process) {
  constexpr double kHighestMm = 180.0, kLowestMm = 20.0, kStepMm = 20.0, kEnoughMm = 20.0;
  constexpr int kTurns = 16;
  const CellCollision collision(cell, process);
  const collision::Margins margins;
  std::vector<robot::JointVector> solutions;
  Frames frames;
  std::optional<robot::JointVector> best;
  std::tuple<double, double, double> bestRank;
  robot::JointVector zero = robot::JointVector::Zero(cell.dof());
  for (double height = kHighestMm; height >= kLowestMm; height -= kStepMm)
    for (int rotation = 0; rotation < kTurns; ++rotation) {
      cell.inverse(upright({0, 0, height}, base::kTwoPi * rotation / kTurns), zero, solutions);
      for (const robot::JointVector& q : solutions) {
        cell.framePoses(q, frames);
        if (collision.bodies(frames, margins))
          continue;
        const std::tuple rank(std::floor(collision.clearance(frames, kEnoughMm)), height,
                              -robot::asAngles(q, cell.limits()).norm());
        if (!best || rank > bestRank) {
          best = q;
          bestRank = rank;
        }
      }
    }
  return best;
}

} // namespace voluta::cells
