#include "motion/transfers/transfer.h"

#include "base/run_context.h"
#include "base/units.h"
#include "collision/cell_collision.h"
#include "geometry/least_turn.h"
#include "motion/external_axes.h"
#include "motion/motion_options.h"
#include "motion/nozzle_frame.h"
#include "motion/transfers/rrt_connect.h"

#include <algorithm>
#include <cmath>

namespace voluta::motion {

using Eigen::Quaterniond;
using Eigen::Vector3d;
using plan::MoveKind;
using robot::JointVector;

namespace {

constexpr double kStepMm = 2.0, kStepRad = base::degreesToRadians(1.0);
constexpr double kLinearJointStep = 0.15; // [rad] between checks of a linear move
constexpr double kLinearPieceMm = 25.0;   // longest linear move in the output
constexpr double kJointCheck = base::degreesToRadians(0.5),
                 kCloseJointCheck = base::degreesToRadians(0.2);
constexpr double kJointPiece = base::degreesToRadians(20.0); // longest joint move in the output
constexpr double kAxisPiece = 0.5 * base::kPi, kSlidePieceMm = 200.0; // same for external axes
constexpr double kJointMarginMm = 3.0; // additional clearance, for motion between checks
constexpr double kSameJoints = 1e-6;
constexpr double kArcPiece = base::degreesToRadians(10.0);
constexpr double kBallMarginMm = 5.0;

collision::Margins widened(collision::Margins margins, double byMm) {
  margins.bodiesMm += byMm;
  margins.partMm += byMm;
  margins.headMm += byMm;
  return margins;
}

// Appends the points in reverse order, from the last one to `first`.
void appendReversed(const std::vector<TransferPoint>& points, const RobotState& first,
                    std::vector<TransferPoint>& out) {
  for (std::size_t i = points.size(); i-- > 0;)
    out.push_back({i == 0 ? first : points[i - 1].at, points[i].move, points[i].peakDisplacement});
}

// Merges the pieces of one straight move.
TransferPoint joined(const Vector3d& from, const std::vector<TransferPoint>& pieces) {
  TransferPoint whole = pieces.back();
  const double length = (whole.at.tip - from).norm();
  Vector3d last = from;
  for (const TransferPoint& piece : pieces) {
    const double own = (piece.at.tip - last).norm();
    if (own > 0.0)
      whole.peakDisplacement =
          whole.peakDisplacement.cwiseMax(piece.peakDisplacement * (length / own));
    last = piece.at.tip;
  }
  return whole;
}

Vector3d slerped(const Vector3d& a, const Vector3d& b, double t) {
  return Quaterniond::Identity().slerp(t, geometry::shortestRotation(a, b)) * a;
}

// Returns the distance along a ray from p at which it finally leaves the ball; 0 if it misses the
// ball.
double exitDistance(const Vector3d& p, const Vector3d& direction, const PrintedBounds& ball,
                    double radius) {
  const Vector3d r = p - ball.centre;
  const double b = r.dot(direction), c = r.squaredNorm() - radius * radius;
  const double discriminant = b * b - c;
  return discriminant <= 0.0 ? 0.0 : std::max(0.0, -b + std::sqrt(discriminant));
}

} // namespace

bool TransferPlanner::free(const JointVector& q, std::size_t before,
                           const collision::Margins& margins) const {
  collision::CellCollision::Frames frames;
  scene_.cell.framePoses(q, frames);
  return !scene_.collision.any(frames, scene_.part, before, margins);
}

bool TransferPlanner::linear(const RobotState& from, const Vector3d& tip, const Quaterniond& tool,
                             std::size_t before, const collision::Margins& margins,
                             Points& points) const {
  const double length = (tip - from.tip).norm(), angle = angleBetween(from.tool, tool);
  const int written = std::max(scene_.divisions(from.tip, tip, angle),
                               static_cast<int>(std::ceil(length / kLinearPieceMm)));
  const int checks = std::max(
      1, static_cast<int>(std::ceil(std::max(length / kStepMm, angle / kStepRad) / written)));
  std::vector<JointVector> scratch;
  JointVector q = from.q, peakDisplacement = JointVector::Zero(q.size());
  Vector3d lastTip = from.tip;
  Quaterniond lastTool = from.tool;
  const int steps = written * checks;
  for (int k = 1; k <= steps; ++k) {
    const double t = static_cast<double>(k) / steps;
    const Vector3d p = k == steps ? tip : Vector3d(from.tip + t * (tip - from.tip));
    const Quaterniond r = k == steps ? tool : from.tool.slerp(t, tool);
    const JointVector last = q;
    if (!solveNear(scene_.cell, p, r, last, kLinearJointStep, scratch, q) ||
        !scene_.movesStraight({lastTip, lastTool, last}, {p, r, q}) || !free(q, before, margins))
      return false;
    lastTip = p;
    lastTool = r;
    peakDisplacement = peakDisplacement.cwiseMax((q - last).cwiseAbs());
    if (k % checks == 0) {
      points.push_back(
          {{p, r, q, axesOf(scene_.cell, q)}, MoveKind::Linear, checks * peakDisplacement});
      peakDisplacement.setZero();
    }
  }
  return true;
}

bool TransferPlanner::jointSegmentFree(const JointVector& a, const JointVector& b,
                                       std::size_t before, const collision::Margins& margins,
                                       double checkRad) const {
  const int steps = std::max(1, static_cast<int>(std::ceil(scene_.span(a, b) / checkRad)));
  // Coarse to fine, which finds collisions sooner.
  int stride = 1;
  while (stride < steps)
    stride *= 2;
  for (bool first = true; stride >= 1; stride /= 2, first = false)
    for (int k = first ? 0 : stride; k <= steps; k += first ? stride : 2 * stride)
      if (!free(a + static_cast<double>(k) / steps * (b - a), before, margins))
        return false;
  return free(b, before, margins);
}

std::vector<TransferPlanner::Points> TransferPlanner::lifts(const RobotState& from,
                                                            const std::vector<double>& heights,
                                                            std::size_t before) const {
  std::vector<Points> lifted;
  Points points;
  RobotState last = from;
  for (const double height : heights) {
    if (!linear(last, from.tip + height * from.direction(), from.tool, before,
                scene_.options.printing, points))
      break;
    // The checks divided one straight move into pieces; merge them again.
    if (height <= kLinearPieceMm)
      points = {joined(from.tip, points)};
    last = points.back().at;
    lifted.push_back(points);
  }
  return lifted;
}

bool TransferPlanner::arc(const RobotState& from, const RobotState& to,
                          const PrintedBounds& surround, std::size_t before, Points& points) const {
  const Vector3d a = from.tip - surround.centre, b = to.tip - surround.centre;
  const double angle = std::acos(std::clamp(a.normalized().dot(b.normalized()), -1.0, 1.0));
  const int pieces = std::max(1, static_cast<int>(std::ceil(angle / kArcPiece)));
  // Chords of the arc would cut into the ball; enlarge the radius accordingly.
  const double outward = 1.0 / std::cos(0.5 * angle / pieces);
  RobotState last = from;
  for (int k = 1; k <= pieces; ++k) {
    const double t = static_cast<double>(k) / pieces;
    const double radius = (a.norm() + t * (b.norm() - a.norm())) * (k == pieces ? 1.0 : outward);
    const Vector3d tip =
        k == pieces
            ? to.tip
            : Vector3d(surround.centre + radius * slerped(a.normalized(), b.normalized(), t));
    if (!linear(last, tip, from.tool.slerp(t, to.tool), before, scene_.options.travelling, points))
      return false;
    last = points.back().at;
  }
  return true;
}

void TransferPlanner::appendJointPath(const std::vector<JointVector>& path, const RobotState& to,
                                      Points& points) const {
  for (std::size_t i = 1; i < path.size(); ++i) {
    const JointVector step = path[i] - path[i - 1];
    const double arm = robot::largestRotation(step, scene_.cell.robot().limits);
    double maximum = arm / kJointPiece;
    for (std::size_t k = 0; k < scene_.cell.externalAxes().size(); ++k)
      maximum = std::max(maximum,
                         std::abs(step[scene_.cell.armDof() + static_cast<Eigen::Index>(k)]) /
                             (scene_.cell.externalAxes()[k].limits.kind == robot::JointKind::Turning
                                  ? kAxisPiece
                                  : kSlidePieceMm));
    const int pieces = std::max(1, static_cast<int>(std::ceil(maximum)));
    for (int k = 1; k <= pieces; ++k) {
      const JointVector wanted =
          k == pieces ? path[i] : JointVector(path[i - 1] + static_cast<double>(k) / pieces * step);
      const JointVector q = withAxes(scene_.cell, wanted, axesOf(scene_.cell, wanted));
      const Eigen::Isometry3d pose = scene_.cell.work_T_tool(q);
      points.push_back({{pose.translation(), Quaterniond(pose.linear()), q, axesOf(scene_.cell, q)},
                        MoveKind::Joint});
    }
  }
  points.back().at = to;
}

std::vector<TransferPoint> TransferPlanner::wipe(const Run& run, double lengthMm,
                                                 std::size_t before) const {
  constexpr double kSameMm = 1e-6, kSameToolRad = base::degreesToRadians(5.0);
  const std::size_t n = run.points.size();
  const RobotState &first = run.points.front().at, &end = run.points.back().at;
  const bool continues =
      (end.tip - first.tip).norm() < kSameMm && angleBetween(end.tool, first.tool) < kSameToolRad;
  Points points;
  RobotState last = end;
  for (std::size_t k = 1; k < n && lengthMm > 0.0; ++k) {
    const RobotState& to = run.points[continues ? k : n - 1 - k].at;
    const double step = (to.tip - last.tip).norm();
    const double share = step > lengthMm ? lengthMm / step : 1.0;
    if (!linear(last, last.tip + share * (to.tip - last.tip), last.tool.slerp(share, to.tool),
                before, scene_.options.printing, points))
      break;
    last = points.back().at;
    lengthMm -= step;
  }
  for (TransferPoint& point : points)
    point.move = MoveKind::Wipe;
  return points;
}

std::optional<TransferKind> TransferPlanner::swing(const RobotState& from, const RobotState& to,
                                                   std::size_t before, std::uint64_t seed,
                                                   const base::RunContext& ctx,
                                                   Points& points) const {
  // First with additional clearance for motion between checks, then with finer checks: the ends may
  // be closer to obstacles than the wider margin.
  struct Care {
    collision::Margins margins;
    double checkRad;
  };
  const Care wide{widened(scene_.options.travelling, kJointMarginMm), kJointCheck};
  const Care close{scene_.options.travelling, kCloseJointCheck};
  for (const Care& care : {wide, close})
    if (jointSegmentFree(from.q, to.q, before, care.margins, care.checkRad)) {
      appendJointPath({from.q, to.q}, to, points);
      return TransferKind::Joint;
    }
  for (const Care& care : {wide, close}) {
    if (!free(from.q, before, care.margins) || !free(to.q, before, care.margins))
      continue;
    TreeOptions options;
    options.iterations = effort_ * scene_.options.treeIterations;
    options.seed = seed;
    const auto path = treePath(
        from.q, to.q, scene_.cell.limits(),
        [&](const JointVector& q) { return free(q, before, care.margins); },
        [&](const JointVector& a, const JointVector& b) {
          return jointSegmentFree(a, b, before, care.margins, care.checkRad);
        },
        options, ctx);
    if (!path.empty()) {
      appendJointPath(path, to, points);
      return TransferKind::Tree;
    }
  }
  return std::nullopt;
}

std::optional<Transfer> TransferPlanner::plan(const RobotState& from, const RobotState& to,
                                              Lift lift, std::size_t before,
                                              const PrintedBounds& surround, std::uint64_t seed,
                                              const base::RunContext& ctx) const {
  const MotionOptions& options = scene_.options;
  std::vector<double> heights;
  if (lift == Lift::High) {
    const double high = std::max(kHighLiftMm, options.liftMm);
    heights = {high, 2.0 * high};
  } else {
    if (lift == Lift::Hop)
      heights.push_back(options.hopLiftMm);
    for (const double factor : {1.0, 2.0, 5.0, 10.0})
      heights.push_back(factor * options.liftMm);
  }
  const std::vector<Points> up = lifts(from, heights, before);
  const std::vector<Points> down = lifts(to, heights, before);
  Transfer transfer;
  const bool axesMove = axesOf(scene_.cell, from.q) != axesOf(scene_.cell, to.q);
  if (scene_.cell.rod() || axesMove) {
    // The arm hardly moves while the part is brought to the start of the next path.
    for (std::size_t h = 0; h < std::min(up.size(), down.size()); ++h) {
      ctx.checkpoint();
      const RobotState &high = up[h].back().at, &low = down[h].back().at;
      if (!jointSegmentFree(high.q, low.q, before, options.travelling, kCloseJointCheck))
        continue;
      transfer.points = up[h];
      appendJointPath({high.q, low.q}, low, transfer.points);
      appendReversed(down[h], to, transfer.points);
      transfer.kind = TransferKind::Joint;
      return transfer;
    }
  }
  // With an angle of more than 90 degrees, straight moves would pass near the part's middle.
  if (from.direction().dot(to.direction()) > 0.0)
    for (std::size_t h = 0; h < std::min(up.size(), down.size()); ++h) {
      ctx.checkpoint();
      transfer.points = up[h];
      const RobotState& high = down[h].back().at;
      if (linear(up[h].back().at, high.tip, high.tool, before, options.travelling,
                 transfer.points) &&
          (transfer.points.back().at.q - high.q).cwiseAbs().maxCoeff() < kSameJoints) {
        transfer.points.back().at.q = high.q;
        appendReversed(down[h], to, transfer.points);
        return transfer;
      }
    }
  if (lift == Lift::High)
    return plan(from, to, Lift::Usual, before, surround, seed, ctx);

  const auto outer = [&](const RobotState& state) {
    const double out =
        exitDistance(state.tip, state.direction(), surround, surround.radius + kBallMarginMm);
    std::vector<double> outHeights = {10.0 * options.liftMm};
    if (out > outHeights.back())
      outHeights.push_back(out);
    return lifts(state, outHeights, before);
  };
  std::vector<Points> farUp = outer(from), farDown = outer(to);
  const Points stay; // if no lift is possible, the joint move starts at the state itself
  if (!farUp.empty() && !farDown.empty()) {
    ctx.checkpoint();
    transfer.points = farUp.back();
    const RobotState& high = farDown.back().back().at;
    if (arc(farUp.back().back().at, high, surround, before, transfer.points) &&
        (transfer.points.back().at.q - high.q).cwiseAbs().maxCoeff() < kSameJoints) {
      transfer.points.back().at.q = high.q;
      appendReversed(farDown.back(), to, transfer.points);
      transfer.kind = TransferKind::Arc;
      return transfer;
    }
  }
  const Points& upPath = !farUp.empty() ? farUp.back() : !up.empty() ? up.back() : stay;
  const Points& downPath = !farDown.empty() ? farDown.back() : !down.empty() ? down.back() : stay;
  transfer.points = upPath;
  const RobotState high = upPath.empty() ? from : upPath.back().at;
  const RobotState low = downPath.empty() ? to : downPath.back().at;
  const auto kind = swing(high, low, before, seed, ctx, transfer.points);
  if (!kind)
    return std::nullopt;
  transfer.kind = *kind;
  appendReversed(downPath, to, transfer.points);
  return transfer;
}

std::optional<Transfer> TransferPlanner::approach(const RobotState& home, const RobotState& start,
                                                  std::size_t before, const PrintedBounds& surround,
                                                  std::uint64_t seed,
                                                  const base::RunContext& ctx) const {
  const double out =
      exitDistance(start.tip, start.direction(), surround, surround.radius + kBallMarginMm);
  std::vector<Points> down =
      lifts(start, {10.0 * scene_.options.liftMm, std::max(50.0, out)}, before);
  if (down.empty())
    down = lifts(start, {scene_.options.liftMm}, before);
  Transfer transfer;
  const auto kind =
      swing(home, down.empty() ? start : down.back().back().at, before, seed, ctx, transfer.points);
  if (!kind)
    return std::nullopt;
  transfer.kind = *kind;
  if (!down.empty())
    appendReversed(down.back(), start, transfer.points);
  return transfer;
}

std::optional<Transfer> TransferPlanner::leave(const RobotState& end, const RobotState& home,
                                               std::size_t before, const PrintedBounds& surround,
                                               std::uint64_t seed,
                                               const base::RunContext& ctx) const {
  const auto back = approach(home, end, before, surround, seed, ctx);
  if (!back)
    return std::nullopt;
  Transfer transfer;
  transfer.kind = back->kind;
  appendReversed(back->points, home, transfer.points);
  return transfer;
}

std::optional<Transfer> TransferPlanner::between(const RobotState& from, const RobotState& to,
                                                 std::size_t before, std::uint64_t seed,
                                                 const base::RunContext& ctx) const {
  Transfer transfer;
  const auto kind = swing(from, to, before, seed, ctx, transfer.points);
  if (!kind)
    return std::nullopt;
  transfer.kind = *kind;
  return transfer;
}

std::optional<Transfer> TransferPlanner::straight(const RobotState& from, const RobotState& to,
                                                  std::size_t before) const {
  if (!jointSegmentFree(from.q, to.q, before, scene_.options.travelling, kCloseJointCheck))
    return std::nullopt;
  Transfer transfer;
  appendJointPath({from.q, to.q}, to, transfer.points);
  transfer.kind = TransferKind::Joint;
  return transfer;
}

} // namespace voluta::motion
