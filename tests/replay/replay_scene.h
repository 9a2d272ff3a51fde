// A small print by hand: tool-paths, and a trajectory of the ur5-fixed cell along them.
#pragma once

#include "base/error.h"
#include "base/units.h"
#include "helpers/lathe_parts.h"
#include "helpers/shapes.h"
#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "process/bead_model.h"
#include "replay/distances.h"
#include "robot/cell.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

namespace voluta::test {

struct Scene {
  process::Process process;
  robot::Cell cell;
  geometry::TriangleMesh part;
  plan::ToolPlan plan;
  plan::Trajectory trajectory;
  platform::PlatformSolid platform;
};

inline void usesSourceTreeResources() {
  setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1);
}

// A bead of waypoints a millimetre apart between the corners.
inline void addPath(plan::ToolPlan& plan, const std::vector<Eigen::Vector3d>& corners, double width,
                    double height, double speed, int layer) {
  plan::ToolPath path;
  path.first = plan.position.size();
  path.layer = layer;
  const auto add = [&](const Eigen::Vector3d& p) {
    plan.position.push_back(p);
    plan.direction.push_back(Eigen::Vector3d::UnitZ());
    plan.widthMm.push_back(static_cast<float>(width));
    plan.heightMm.push_back(static_cast<float>(height));
    plan.speedMmPerS.push_back(static_cast<float>(speed));
  };
  add(corners.front());
  for (std::size_t k = 1; k < corners.size(); ++k) {
    const Eigen::Vector3d step = corners[k] - corners[k - 1];
    const int n = std::max(1, static_cast<int>(std::lround(step.norm())));
    for (int i = 1; i <= n; ++i)
      add(corners[k - 1] + step * i / n);
  }
  path.count = plan.position.size() - path.first;
  plan.paths.push_back(path);
}

// A box of 100 % infill, centred over the plate: zigzags, alternating between x and y.
inline plan::ToolPlan boxPlan(double side, int lines, int layers, const process::Process& p,
                              double z0 = 0.0) {
  plan::ToolPlan plan;
  const double hatch = side / lines, h = p.layerHeightMm, w = process::widthOfHatch(hatch, h);
  for (int k = 0; k < layers; ++k)
    for (int l = 0; l < lines; ++l) {
      const double across = (l + 0.5) * hatch - 0.5 * side;
      const double from = l % 2 ? 0.5 * side : -0.5 * side, z = z0 + (k + 1) * h;
      std::vector<Eigen::Vector3d> ends = {{from, across, z}, {-from, across, z}};
      if (k % 2)
        for (Eigen::Vector3d& e : ends)
          std::swap(e.x(), e.y());
      addPath(plan, ends, w, h, p.speedMmPerS, k);
    }
  return plan;
}

// Least distance of the bodies that are not to meet; only chooses where a walk begins.
inline double clearance(const robot::Cell& cell, const robot::JointVector& q) {
  std::vector<Eigen::Isometry3d> frames;
  cell.framePoses(q, frames);
  double minimum = 1e9;
  for (const auto& [a, b] : cell.checkedPairs()) {
    const robot::Body &x = cell.bodies()[static_cast<std::size_t>(a)],
                      &y = cell.bodies()[static_cast<std::size_t>(b)];
    const bool nozzleOnPlate = x.role == robot::BodyRole::Head || y.role == robot::BodyRole::Head;
    for (const robot::Shape& s : x.shapes)
      for (const robot::Shape& t : y.shapes)
        if (!nozzleOnPlate)
          minimum = std::min(minimum,
                             replay::distanceBetween(s, frames[static_cast<std::size_t>(x.frame)],
                                                     t, frames[static_cast<std::size_t>(y.frame)]));
  }
  return minimum;
}

// The cell's axes with a rod turned so that `direction` is up, at a whole number of its steps, the
// short way round; as they are where there is no rod.
inline robot::JointVector turnedUp(const robot::Cell& cell, const Eigen::Vector3d& direction,
                                   robot::JointVector q) {
  if (!cell.rod())
    return q;
  const double rotation = 2.0 * base::kPi, step = cell.externalAxes().front().step;
  double& angle = q[cell.armDof()];
  const double up = std::atan2(direction.y(), direction.z());
  angle = step * std::round((up + rotation * std::round((angle - up) / rotation)) / step);
  return q;
}

// A level shift of the nozzle on the part.
inline Eigen::Vector3d lateralOffset(const Eigen::Vector3d& direction, double mm) {
  return mm * direction.cross(Eigen::Vector3d::UnitX()).normalized();
}
// The same from the first waypoint, so far that drops fall beside the print.
inline Eigen::Vector3d besidePrint(const plan::ToolPlan& plan) {
  constexpr double kSpareMm = 15.0;
  const Eigen::Vector3d offset = lateralOffset(plan.direction.front(), 1.0);
  double mm = 0.0;
  for (const Eigen::Vector3d& p : plan.position)
    mm = std::max(mm, (p - plan.position.front()).dot(offset));
  return (mm + kSpareMm) * offset;
}

// Shifts the nozzle aside at a point; the motions there and from there take a second longer.
inline void moveSideways(plan::Trajectory& t, const robot::Cell& cell, std::size_t point) {
  Eigen::Map<robot::JointVector> q(t.joints.data() + point * static_cast<std::size_t>(t.dof),
                                   t.dof);
  Eigen::Isometry3d pose = cell.work_T_tool(q);
  constexpr double kOffsetMm = 30.0; // beside a small print
  pose.translation() += lateralOffset(-pose.linear().col(2), kOffsetMm);
  std::vector<robot::JointVector> solutions;
  cell.inverse(pose, q, solutions);
  base::require(!solutions.empty(), "scene: in reach");
  const auto nearest = std::ranges::min_element(
      solutions, {}, [&](const robot::JointVector& s) { return (s - q).squaredNorm(); });
  q = robot::JointVector(*nearest);
  for (std::size_t i = point; i < t.pointCount(); ++i)
    t.timeS[i] += i > point ? 2.0 : 1.0;
}

// Walks the paths with a fixed turn about the nozzle, the one with most clearance at the start;
// between them back over the bead for `wipeMm`, waypoint by waypoint, up, over and down, straight.
// The first point is beside the print, for a prime.
inline plan::Trajectory walk(const plan::ToolPlan& plan, const robot::Cell& cell,
                             const process::Process& process, double liftMm = 3.0,
                             double wipeMm = 0.0) {
  plan::Trajectory t;
  t.dof = cell.dof();
  robot::JointVector q = cell.home();
  std::vector<robot::JointVector> solutions;
  double time = 0.0, extruded = 0.0;
  Eigen::Vector3d last = Eigen::Vector3d::Zero();
  const auto poseAt = [](const Eigen::Vector3d& tip, const Eigen::Vector3d& direction,
                         double rotation) {
    Eigen::Isometry3d work_T_tool = Eigen::Isometry3d::Identity();
    const Eigen::Vector3d x = (Eigen::Vector3d::UnitX() - direction.x() * direction).normalized();
    work_T_tool.linear() << x, (-direction).cross(x), -direction;
    work_T_tool.translation() = tip;
    work_T_tool.rotate(Eigen::AngleAxisd(rotation, Eigen::Vector3d::UnitZ()));
    return work_T_tool;
  };
  double rotation = 0.0, best = -1.0;
  for (int k = 0; k < 12; ++k) {
    solutions.clear();
    cell.inverse(poseAt(plan.position.front(), plan.direction.front(), k * 0.5235987755982988),
                 turnedUp(cell, plan.direction.front(), cell.home()), solutions);
    for (const robot::JointVector& s : solutions)
      if (const double c = clearance(cell, s); c > best) {
        best = c;
        rotation = k * 0.5235987755982988;
        q = robot::JointVector(s);
      }
  }
  const auto put = [&](plan::MoveKind move, const Eigen::Vector3d& tip,
                       const Eigen::Vector3d& direction, std::size_t waypoint, double speed) {
    solutions.clear();
    cell.inverse(poseAt(tip, direction, rotation), turnedUp(cell, direction, q), solutions);
    base::require(!solutions.empty(), "scene: in reach");
    const bool first = t.timeS.empty();
    const robot::JointVector* nearest = &solutions.front();
    for (const auto& s : solutions)
      if ((s - q).squaredNorm() < (*nearest - q).squaredNorm())
        nearest = &s;
    q = robot::JointVector(*nearest);
    if (!first)
      time += (tip - last).norm() / speed;
    last = tip;
    t.joints.insert(t.joints.end(), q.data(), q.data() + q.size());
    t.timeS.push_back(time);
    t.move.push_back(move);
    t.waypoint.push_back(waypoint);
    t.extrudedMm3.push_back(extruded);
  };
  for (const plan::ToolPath& path : plan.paths) {
    const std::size_t a = path.first, b = path.first + path.count - 1;
    const bool start = t.timeS.empty();
    put(start ? plan::MoveKind::Joint : plan::MoveKind::Linear,
        plan.position[a] + liftMm * plan.direction[a] +
            (start ? besidePrint(plan) : Eigen::Vector3d(0, 0, 0)),
        plan.direction[a], plan::kNoWaypoint, process.travelSpeedMmPerS);
    put(plan::MoveKind::Linear, plan.position[a], plan.direction[a], a, process.travelSpeedMmPerS);
    for (std::size_t w = a + 1; w <= b; ++w) {
      extruded += (plan.position[w] - plan.position[w - 1]).norm() *
                  process::beadArea(plan.widthMm[w], plan.heightMm[w]);
      put(plan::MoveKind::Print, plan.position[w], plan.direction[w], w, plan.speedMmPerS[w]);
    }
    std::size_t end = b;
    for (double left = wipeMm; end > a && left > 0.0 && b + 1 < plan.waypointCount(); --end) {
      left -= (plan.position[end] - plan.position[end - 1]).norm();
      put(plan::MoveKind::Wipe, plan.position[end - 1], plan.direction[end - 1], plan::kNoWaypoint,
          process.travelSpeedMmPerS);
    }
    put(plan::MoveKind::Linear, plan.position[end] + liftMm * plan.direction[end],
        plan.direction[end], plan::kNoWaypoint, process.travelSpeedMmPerS);
  }
  return t;
}

inline std::vector<Eigen::Vector2d> squarePlatform(double side) {
  const double a = 0.5 * side;
  return {{-a, -a}, {a, -a}, {a, a}, {-a, a}};
}

// Rings round a rod of 5 mm, `layers` of 8: 5.17 mm of tube.
inline Scene rodScene(int layers = 2) {
  usesSourceTreeResources();
  process::Process p = process::loadProcess("fdm-0.35");
  platform::PlatformSolid rod;
  rod.rod = platform::straightRod(5.0, 200.0);
  robot::Cell cell = robot::loadCell("lathe", p, rod);
  const double h = p.layerHeightMm, w = p.beadWidthMm, hatch = process::hatchOf(w, h);
  constexpr int kRings = 8, kCorners = 90;
  plan::ToolPlan plan;
  for (int k = 0; k < layers; ++k)
    for (int ring = 0; ring < kRings; ++ring) {
      // The layer's middle is shorter than the nozzle's way.
      const double r = 2.5 + (k + 1) * h, shorter = (r - 0.5 * h) / r;
      const double x = (ring + 0.5 - 0.5 * kRings) * hatch;
      plan::ToolPath path;
      path.first = plan.position.size();
      path.count = kCorners + 1;
      path.layer = k;
      path.closed = true;
      for (int i = 0; i <= kCorners; ++i) {
        const double a = 2.0 * base::kPi * i / kCorners;
        plan.direction.emplace_back(0.0, std::cos(a), std::sin(a));
        plan.position.push_back(Eigen::Vector3d(x, 0, 0) + r * plan.direction.back());
        plan.widthMm.push_back(static_cast<float>(process::widthOfHatch(hatch * shorter, h)));
        plan.heightMm.push_back(static_cast<float>(h));
        plan.speedMmPerS.push_back(static_cast<float>(p.speedMmPerS));
      }
      plan.paths.push_back(path);
    }
  plan::Trajectory t = walk(plan, cell, p);
  const double x = 0.5 * kRings * hatch, top = 2.5 + layers * h;
  return {p,
          cell,
          revolved({{-x, 2.5}, {-x, top}, {x, top}, {x, 2.5}}, 256),
          std::move(plan),
          std::move(t),
          rod};
}

// The cell of a format's own robot, if it states joints of no other; else the scenes'.
inline std::string cellFor(const std::string& format) {
  return format == "melfa-stream" ? "rv2f-moving" : "ur5-fixed";
}

// A solid box of 12 x 12 x (0.8 x layers) mm, printed.
inline Scene boxScene(int layers = 4, const std::string& cellId = "ur5-fixed") {
  usesSourceTreeResources();
  process::Process p = process::loadProcess("fdm-1.0");
  robot::Cell cell = robot::loadCell(cellId, p, squarePlatform(12.0));
  plan::ToolPlan plan = boxPlan(12.0, 11, layers, p);
  plan::Trajectory t = walk(plan, cell, p);
  return {p,
          cell,
          box({-6, -6, 0}, {6, 6, layers * p.layerHeightMm}),
          std::move(plan),
          std::move(t),
          squarePlatform(12.0)};
}

} // namespace voluta::test
