#include "cells/cell_layout.h"

#include "base/error.h"
#include "base/units.h"
#include "cells/near_pairs.h"
#include "collision/cell_collision.h"
#include "robot/leaning_tool.h"
#include "robot/nozzle_turns.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <optional>

namespace voluta::cells {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using robot::BodyRole;
using robot::JointVector;
using robot::Mount;

// number of poses for the search for bodies that are always near
constexpr std::size_t kDrawn = 300;
// distance below the arm's underside, since capsules extend beyond it
constexpr double kTableBelowMm = 30.0;
constexpr double kNozzleMm = 200.0; // tip from the flange; the head is 110 mm high
// A nozzle that is bent relative to the flange. With a straight one, rotation about the nozzle
// moves the last joint alone, and a tilted nozzle brings the wrist close to its singularity.
constexpr double kBendRad = base::degreesToRadians(45.0);
constexpr double kBeforeBendMm = 60.0, kBehindBendMm = 150.0;
constexpr double kStemMm = 100.0;   // of a plate on the flange
constexpr double kGantryMm = 600.0; // above the tip of a stationary nozzle
constexpr double kSame = 0.01;      // shares that differ by less count as equal
constexpr double kMostly = 0.5;     // share of the poses within limits
// Makers set limits such that a link does not collide with the next but one: if the solids
// intersect at a seventh of all poses, the solids are too large.
constexpr double kOftenNextButOne = 0.15;

double toTens(double mm) {
  return 10.0 * std::round(0.1 * mm);
}

// Few poses: an arm that is solved numerically takes about 1 ms for each.
PosePattern patternFor(double reachMm) {
  return {.radiusMm = std::clamp(5.0 * std::round(0.02 * reachMm), 40.0, 150.0),
          .shells = 4,
          .sides = 4,
          .turns = 8,
          .tiltDeg = {0, 30, 60, 90}};
}

struct Place {
  double out, up;   // mm, from joint 1's axis and from the arm's underside
  double offCentre; // of the grid, in steps
  double bendRad;   // of the nozzle against the flange
};
std::vector<Place> placesFor(const ArmFacts& facts, Mount nozzle,
                             const std::vector<double>& bendsRad) {
  const std::vector<double> outs{0.4, 0.5, 0.6, 0.7};
  // A flange that points up needs more height than one that points down.
  const std::vector<double> ups = nozzle == Mount::Flange
                                      ? std::vector<double>{0.05, 0.15, 0.3, 0.45}
                                      : std::vector<double>{0.4, 0.55, 0.7, 0.85, 1.0};
  std::vector<Place> places;
  for (const double bend : nozzle == Mount::Flange ? bendsRad : std::vector<double>{0.0})
    for (std::size_t i = 0; i < outs.size(); ++i)
      for (std::size_t k = 0; k < ups.size(); ++k)
        places.push_back(
            {toTens(outs[i] * facts.reachMm), toTens(ups[k] * facts.reachMm),
             std::abs(static_cast<double>(i) - 0.5 * static_cast<double>(outs.size() - 1)) +
                 std::abs(static_cast<double>(k) - 0.5 * static_cast<double>(ups.size() - 1)),
             bend});
  return places;
}

robot::Frustum upright(double bottom, double top, double radius) {
  return {Vector3d(0, 0, bottom), Vector3d(0, 0, top), radius, radius};
}

robot::CellDescription describe(const robot::RobotModel& robot, const ArmFacts& facts, Mount nozzle,
                                const Place& place) {
  const bool plateMoves = nozzle == Mount::World;
  robot::CellDescription cell;
  cell.id = robot.id + (plateMoves ? "-fixed" : "-moving");
  cell.label = robot.label + (plateMoves ? ", nozzle fixed, plate on the flange"
                                         : ", nozzle moving, plate on a table");
  cell.robot = robot.id;
  cell.nozzleMount = nozzle;
  const double table = facts.foot.z() - kTableBelowMm;
  Isometry3d ahead = Isometry3d::Identity();
  ahead.linear() = Eigen::AngleAxisd(facts.aheadRad, Vector3d::UnitZ()).toRotationMatrix();
  const Vector3d at = facts.foot + ahead * Vector3d(place.out, 0, place.up);
  const auto onFlange = [&](double mm) {
    Isometry3d pose = Isometry3d::Identity();
    pose.linear() = facts.flange_R_outward;
    pose.translation() = facts.flange_R_outward * Vector3d(0, 0, mm);
    return pose;
  };
  if (plateMoves) {
    cell.nozzlePose = ahead;
    cell.nozzlePose.translation() = at;
    cell.nozzlePose.linear() *= Eigen::AngleAxisd(base::kPi, Vector3d::UnitX()).toRotationMatrix();
    cell.holder = {upright(-110.0, -kGantryMm, 20.0)};
    cell.platePose = onFlange(kStemMm);
    cell.plateThicknessMm = 5.0;
    cell.plates = {"disc:60", "disc:90", "disc:120", "disc:160", "disc:200", "disc:250"};
    cell.stem = {upright(-kStemMm, -kStemMm + 8.0, 32.0), upright(-kStemMm + 8.0, -5.0, 14.0)};
  } else {
    if (place.bendRad > 0.0) {
      const Eigen::AngleAxisd bend(-place.bendRad, Vector3d::UnitY());
      cell.nozzlePose = onFlange(kBeforeBendMm) * bend * Eigen::Translation3d(0, 0, kBehindBendMm);
      const Vector3d flange = cell.nozzlePose.inverse(Eigen::Isometry) * Vector3d::Zero();
      cell.holder = {upright(-110.0, -kBehindBendMm, 20.0),
                     robot::Frustum{Vector3d(0, 0, -kBehindBendMm), flange, 20.0, 20.0}};
    } else {
      cell.nozzlePose = onFlange(kNozzleMm);
      cell.holder = {upright(-110.0, -kNozzleMm + 25.0, 20.0)};
    }
    cell.platePose = ahead;
    cell.platePose.translation() = at;
    cell.plateThicknessMm = 10.0;
    cell.plates = {"rect:200x200", "rect:300x300", "rect:400x400"};
    cell.stem = {upright(table - at.z(), -10.0, 40.0)};
  }
  constexpr double kThick = 50.0;
  const double side = std::max(2000.0, 2.4 * facts.reachMm);
  Isometry3d middle = Isometry3d::Identity();
  middle.translation() = Vector3d(facts.foot.x(), facts.foot.y(), table - 0.5 * kThick);
  cell.obstacles = {
      {"table", BodyRole::Obstacle, 0, {robot::Box{middle, 0.5 * Vector3d(side, side, kThick)}}}};
  cell.home = JointVector::Zero(robot.dof());
  for (int i = 0; i < robot.dof(); ++i) {
    const robot::JointLimits& limit = robot.limits[static_cast<std::size_t>(i)];
    if (!(limit.min <= 0.0 && 0.0 <= limit.max))
      cell.home[i] = 0.5 * (limit.min + limit.max);
  }
  return cell;
}

const robot::Body& bodyOf(const robot::Cell& cell, int i) {
  return cell.bodies()[static_cast<std::size_t>(i)];
}

// Returns pairs of a link and another body of the cell that are near each other at most poses.
std::vector<robot::UncheckedPair> nearInCell(const robot::Cell& cell) {
  std::vector<Frames> poses;
  for (const JointVector& q : drawnPoses(cell.limits(), kDrawn))
    cell.framePoses(q, poses.emplace_back());
  std::vector<robot::UncheckedPair> never;
  for (const auto& [a, b] : cell.checkedPairs()) {
    const robot::Body &one = bodyOf(cell, a), &other = bodyOf(cell, b);
    if ((one.role == BodyRole::Link) != (other.role == BodyRole::Link) &&
        nearShare(one, other, poses, kClearMm) > kMostly)
      never.push_back({one.name, other.name,
                       "near each other at most poses that the limits allow: they are mounted so"});
  }
  return never;
}

// Returns the pair of links that collides most often if all poses above the plate collide; nullopt
// otherwise.
std::optional<std::pair<int, int>> blockingLinks(const robot::Cell& cell,
                                                 const process::Process& process) {
  constexpr int kTurns = 16;
  const collision::CellCollision bodies(cell, process);
  std::vector<JointVector> solutions;
  Frames frames;
  std::map<std::pair<int, int>, int> blocking;
  const robot::NozzleTurns turns(cell, robot::leaningTool({0, 0, 100.0}, 0.0, 0.0), cell.home());
  for (int rotation = 0; rotation < kTurns; ++rotation) {
    turns.at(base::kTwoPi * rotation / kTurns, solutions);
    for (const JointVector& q : solutions) {
      cell.framePoses(q, frames);
      const auto contact = bodies.bodies(frames, {kClearMm, kClearMm, 0.0});
      if (!contact)
        return std::nullopt;
      if (bodyOf(cell, contact->first).role == BodyRole::Link &&
          bodyOf(cell, contact->second).role == BodyRole::Link)
        ++blocking[{contact->first, contact->second}];
    }
  }
  const auto maximum =
      std::max_element(blocking.begin(), blocking.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  if (maximum == blocking.end())
    return std::nullopt;
  return maximum->first;
}

std::string noteOf(const CellLayout& layout, std::size_t places, const std::string& part) {
  std::string tilts, shares;
  for (std::size_t t = 0; t < layout.score.poses.size(); ++t) {
    tilts += fmt::format("{}{:.0f}", t > 0 ? ", " : "", layout.pattern.tiltDeg[t]);
    shares += fmt::format("{}{:.0f}", t > 0 ? ", " : "", 100.0 * layout.score.share(t));
  }
  return fmt::format(
      "Laid out {}: the best of {} places, tips in a ball of {:.0f} mm radius standing on the "
      "plate. Here "
      "arm and tool are clear by {:.0f} mm at a tilt of {} deg in {} % of the "
      "poses. Home: tip {:.0f} mm above the plate, {:.0f} mm clear. The plate's place, the "
      "nozzle's length, its holder and the table are ours: measure yours.",
      part.empty() ? "at import" : "for " + part, places, layout.pattern.radiusMm, kClearMm, tilts,
      shares, layout.rest.heightMm, layout.rest.clearMm);
}

std::vector<std::string> notesOf(const ArmFacts& facts) {
  std::vector<std::string> notes;
  if (!facts.uprightAxis)
    notes.emplace_back("joint 1 does not turn about an upright axis: the base's z is taken as up");
  if (!facts.flange_R_outward.isIdentity())
    notes.emplace_back("the flange's z does not lie along the last joint's axis: nozzle or plate "
                       "are mounted along that axis");
  return notes;
}

struct Tried {
  robot::CellDescription cell;
  CellScore score;
  double offCentre;
};
// Prefers the larger printable share; among nearly equal ones, the place nearer to the middle of
// the grid.
bool better(const Tried& a, const Tried& b) {
  const double is = std::round(a.score.meanOfTilts() / kSame),
               other = std::round(b.score.meanOfTilts() / kSame);
  return is != other ? is > other : a.offCentre < b.offCentre;
}

} // namespace

robot::Cell cellOf(const robot::CellDescription& description, const robot::RobotModel& robot,
                   const process::Process& process) {
  return robot::Cell::read(robot::cellFileJson(description, robot::kindsOf(robot.limits)),
                           description.id + ".json", robot, process, smallPlate());
}

std::vector<std::pair<int, int>> neverNear(const robot::RobotModel& robot) {
  std::vector<Frames> poses;
  for (const JointVector& q : drawnPoses(robot.limits, kDrawn))
    robot.kinematics->linkPoses(q, poses.emplace_back());
  std::vector<std::pair<int, int>> pairs;
  for (std::size_t a = 0; a < robot.links.size(); ++a)
    for (std::size_t b = a + 1; b < robot.links.size(); ++b) {
      const int apart = std::abs(robot.links[b].frame - robot.links[a].frame);
      if (apart > 1 && nearShare(robot.links[a], robot.links[b], poses, kClearMm) >
                           (apart == 2 ? kOftenNextButOne : kMostly))
        pairs.emplace_back(static_cast<int>(a), static_cast<int>(b));
    }
  return pairs;
}

CellLayout layOut(const robot::RobotModel& robot, Mount nozzle, const process::Process& process,
                  const base::RunContext& ctx) {
  LayoutSearch search;
  search.bendsRad = {0.0, kBendRad};
  return layOut(robot, nozzle, search, process, ctx);
}

CellLayout layOut(const robot::RobotModel& given, Mount nozzle, const LayoutSearch& search,
                  const process::Process& process, const base::RunContext& ctx) {
  constexpr int kRounds = 4; // of excluding pairs that collide at every home pose
  robot::RobotModel robot = given;
  const ArmFacts facts = armFacts(robot);
  constexpr double kShortestMm = 100.0, kLongestMm = 20000.0;
  if (!(facts.reachMm > kShortestMm && facts.reachMm < kLongestMm))
    throw base::Error(base::ErrorCode::UnusableInput,
                      base::message("implausible reach of the arm: {reach} mm"_text,
                                    base::number(std::round(facts.reachMm))),
                      robot.id, "lengths in a URDF are metres"_text);
  // With a slow IK every turn about a bent nozzle needs its own solution.
  const std::vector<Place> places = placesFor(
      facts, nozzle, robot.kinematics->isFast() ? search.bendsRad : std::vector<double>{0.0});
  const PosePattern pattern = search.pattern.value_or(patternFor(facts.reachMm));
  std::vector<std::pair<int, int>> meetAtRest;
  for (int round = 0; round < kRounds; ++round) {
    std::vector<Tried> tried;
    std::optional<std::pair<int, int>> meeting;
    for (std::size_t i = 0; i < places.size(); ++i) {
      ctx.report((round + static_cast<double>(i) / static_cast<double>(places.size())) / kRounds,
                 "searching a place for the plate"_text);
      robot::CellDescription cell = describe(robot, facts, nozzle, places[i]);
      cell.neverMeet = nearInCell(cellOf(cell, robot, process));
      const robot::Cell at = cellOf(cell, robot, process);
      CellScore score = scoreOf(at, process, pattern, ctx.quiet());
      if (score.meanOfTilts() > 0.0)
        tried.push_back({std::move(cell), std::move(score), places[i].offCentre});
      else if (!meeting)
        meeting = blockingLinks(at, process);
    }
    std::stable_sort(tried.begin(), tried.end(), better);
    for (Tried& one : tried) {
      const robot::Cell cell = cellOf(one.cell, robot, process);
      const auto rest = restPose(cell, process, facts.reachMm);
      if (!rest || rest->clearMm <= 0.0) {
        if (!meeting)
          meeting = blockingLinks(cell, process);
        continue;
      }
      CellLayout layout{std::move(one.cell),  *rest,      pattern,
                        std::move(one.score), meetAtRest, notesOf(facts)};
      layout.cell.home = rest->q;
      layout.cell.note = noteOf(layout, places.size(), search.part);
      ctx.report(1.0, "searching a place for the plate"_text);
      return layout;
    }
    if (!meeting)
      break;
    meetAtRest.push_back(*meeting);
    robot.neverMeet.push_back(*meeting);
  }
  throw base::Error(
      base::ErrorCode::UnusableInput,
      base::message("no place found where the arm reaches above a plate without "
                    "collision (reach {reach} mm)"_text,
                    base::number(std::round(facts.reachMm))),
      robot.id,
      "check the limits and solids in the description, or name its links: --base, --tip"_text);
}

} // namespace voluta::cells
