#include "motion/axis_schedule.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/run_context.h"
#include "base/units.h"
#include "collision/cell_collision.h"
#include "motion/external_axes.h"
#include "motion/motion_options.h"
#include "motion/nozzle_frame.h"
#include "motion/smoothing/even_turns.h"
#include "motion/upright_schedule.h"
#include "robot/upright_axes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>

namespace voluta::motion {

using Eigen::Vector3d;
using robot::JointVector;

namespace {

constexpr double kStep = base::degreesToRadians(15.0);
constexpr double kFreeLean = base::degreesToRadians(20.0);
// Cost of a rung's tilt from upright: small for any tilt, larger beyond kFreeLean.
constexpr double kLeanScale = base::degreesToRadians(30.0), kAnyLean = 0.001, kMuchLean = 0.2;
constexpr double kFreeSlideOffsetMm = 100.0,
                 kSlideOffsetScaleMm = 100.0; // The same for the offset by slides
constexpr double kStartTravel = 0.3; // Per radian, with the nozzle lifted; 1 while printing
constexpr double kBlocked = 20.0;    // Of a position that the arm cannot reach
constexpr int kSearches = 6;
constexpr int kRotationStride = 2;   // Only every kRotationStride-th nozzle rotation is tried
constexpr double kSmoothing = 200.0; // Removes waves shorter than about 24 waypoints
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The positions of the axes that are tried: all combinations of whole steps within the limits.
class Grid {
public:
  explicit Grid(const robot::Cell& cell) : cell_(cell) {
    const Vector3d up =
        cell.externalAxes().front().before_T_axis.linear().transpose() * Vector3d::UnitZ();
    for (const robot::ExternalAxis& axis : cell.externalAxes()) {
      // A continuous axis needs at most one turn either way.
      const double low = axis.runsOn ? -base::kTwoPi : axis.limits.min;
      const double high = axis.runsOn ? base::kTwoPi : axis.limits.max;
      steps_.push_back(robot::fromAngle(axis.limits.kind, kStep));
      first_.push_back(static_cast<int>(std::ceil(low / steps_.back() - 1e-9)));
      counts_.push_back(static_cast<int>(std::floor(high / steps_.back() + 1e-9)) - first_.back() +
                        1);
      strides_.push_back(nodes_);
      nodes_ *= counts_.back();
    }
    for (int n = 0; n < nodes_; ++n)
      up_.push_back(axesRotation(cell, at(n)).conjugate() * up);
    findSlides();
    addMoves(0, 0, 0.0, {});
  }

  int size() const { return nodes_; }
  JointVector at(int node) const {
    JointVector axes(static_cast<Eigen::Index>(counts_.size()));
    for (std::size_t k = 0; k < counts_.size(); ++k)
      axes[static_cast<Eigen::Index>(k)] = steps_[k] * (first_[k] + place(node, k));
    return axes;
  }
  // Returns how far [mm] slides move a point of the work frame away from the arm at home; the
  // maximum over the slides.
  double slideOffsetMm(int node, const Vector3d& point) const {
    double offset = 0.0;
    for (const Slide& slide : slides_) {
      const auto n = static_cast<std::size_t>(node);
      offset = std::max(offset, std::abs(slide.along[n].dot(point) + slide.offsetMm[n]));
    }
    return offset;
  }
  // Returns the direction of the work frame that points up in this position.
  const Vector3d& upAt(int node) const { return up_[static_cast<std::size_t>(node)]; }

  struct Move {
    int by = 0; // Difference of the node numbers
    double cost = 0.0;
    std::vector<int> steps; // Per axis: -1, 0, 1
  };
  const std::vector<Move>& moves() const { return moves_; }
  bool allows(int node, const Move& move) const {
    for (std::size_t k = 0; k < counts_.size(); ++k) {
      const int to = place(node, k) + move.steps[k];
      if (to < 0 || to >= counts_[k])
        return false;
    }
    return true;
  }

private:
  // The coordinate of a point of the work frame along a slide, relative to the tip at home: along .
  // point + offset.
  struct Slide {
    std::vector<Vector3d> along; // Per node
    std::vector<double> offsetMm;
  };

  int place(int node, std::size_t axis) const { return node / strides_[axis] % counts_[axis]; }
  void findSlides() {
    const JointVector home = cell_.home();
    const auto inBase = [&](const JointVector& axes) {
      return cell_.base_T_work(withAxes(cell_, home, axes));
    };
    const Vector3d tip = cell_.base_T_work(home) * cell_.work_T_tool(home).translation();
    for (std::size_t k = 0; k < counts_.size(); ++k) {
      if (cell_.externalAxes()[k].limits.kind != robot::JointKind::Sliding)
        continue;
      Slide slide;
      for (int n = 0; n < nodes_; ++n) {
        const Eigen::Isometry3d pose = inBase(at(n));
        const int other = place(n, k) > 0 ? n - strides_[k] : n + strides_[k];
        if (counts_[k] < 2)
          break;
        const Vector3d toOther =
            (inBase(at(other)).translation() - pose.translation()).normalized();
        slide.along.push_back(pose.linear().transpose() * toOther);
        slide.offsetMm.push_back(toOther.dot(pose.translation() - tip));
      }
      if (!slide.along.empty())
        slides_.push_back(std::move(slide));
    }
  }
  void addMoves(std::size_t axis, int by, double cost, std::vector<int> steps) {
    if (axis == counts_.size()) {
      moves_.push_back({by, cost, std::move(steps)});
      return;
    }
    for (const int step : {0, -1, 1}) {
      steps.push_back(step);
      addMoves(axis + 1, by + step * strides_[axis], cost + kStep * std::abs(step), steps);
      steps.pop_back();
    }
  }

  const robot::Cell& cell_;
  std::vector<double> steps_; // Per axis [rad or mm]
  std::vector<int> first_, counts_, strides_;
  int nodes_ = 1;
  std::vector<Slide> slides_;
  std::vector<Vector3d> up_;
  std::vector<Move> moves_; // The first is no move
};

double leanOf(const Vector3d& direction, const Vector3d& up) {
  return std::acos(std::clamp(direction.dot(up), -1.0, 1.0));
}

// A part that a slide holds off to the side of the arm will get out of reach.
double slideOffsetCost(double mm) {
  const double all = mm / kSlideOffsetScaleMm,
               much = std::max(0.0, mm - kFreeSlideOffsetMm) / kSlideOffsetScaleMm;
  return kAnyLean * all * all + kMuchLean * much * much;
}

double leanCost(double lean) {
  const double all = lean / kLeanScale, much = std::max(0.0, lean - kFreeLean) / kLeanScale;
  return kAnyLean * all * all + kMuchLean * much * much;
}

class Schedule {
public:
  Schedule(const MotionScene& scene, std::size_t first, std::size_t count, const RobotState& from,
           const base::RunContext& ctx)
      : scene_(scene), ctx_(ctx), first_(first), count_(count), from_(from) {
    rungs_ = {first_};
    double distance = 0.0, angle = 0.0;
    for (std::size_t i = first_ + 1; i < first_ + count_; ++i) {
      distance += (scene_.plan.position[i] - scene_.plan.position[i - 1]).norm();
      angle += leanOf(scene_.plan.direction[i], scene_.plan.direction[i - 1]);
      if (distance > scene_.options.rungMm || angle > scene_.options.rungRotationRad ||
          i + 1 == first_ + count_) {
        rungs_.push_back(i);
        distance = angle = 0.0;
      }
    }
  }

  std::vector<JointVector> find() {
    if (stays())
      return std::vector<JointVector>(count_, from_.axes);
    const Grid grid(scene_.cell);
    std::vector<int> path;
    for (int search = 0; search < kSearches; ++search) {
      ctx_.checkpoint();
      path = cheapest(grid);
      if (!lookAt(grid, path))
        break;
    }
    return along(grid, path);
  }

private:
  bool stays() const {
    const Vector3d up =
        axesRotation(scene_.cell, from_.axes).conjugate() *
        (scene_.cell.externalAxes().front().before_T_axis.linear().transpose() * Vector3d::UnitZ());
    for (const std::size_t w : rungs_)
      if (leanOf(scene_.plan.direction[w], up) > kFreeLean)
        return false;
    std::vector<char> reached(rungs_.size(), 0);
    base::parallelChunks(ctx_, rungs_.size(), 4, [&](std::size_t b, std::size_t e) {
      for (std::size_t r = b; r < e; ++r)
        reached[r] = getsThere(rungs_[r], from_.axes);
    });
    return std::find(reached.begin(), reached.end(), 0) == reached.end();
  }

  bool getsThere(std::size_t waypoint, const JointVector& axes) const {
    const JointVector near = withAxes(scene_.cell, from_.q, axes);
    const Eigen::Quaterniond tool = carried(from_.tool, scene_.plan.direction[waypoint]);
    std::vector<JointVector> solutions;
    collision::CellCollision::Frames frames;
    for (int k = 0; k < scene_.options.samples; k += kRotationStride) {
      scene_.cell.inverse(toolPose(scene_.plan.position[waypoint],
                                   turned(tool, base::kTwoPi * k / scene_.options.samples)),
                          near, solutions);
      for (const JointVector& q : solutions) {
        scene_.cell.framePoses(q, frames);
        if (!scene_.collision.bodies(frames, scene_.options.printing) &&
            !scene_.collision.bodiesAndPart(frames, scene_.part, waypoint, scene_.options.printing))
          return true;
      }
    }
    return false;
  }

  // Returns the travel [rad]; slides count by robot::asAngle.
  double travelTo(const JointVector& axes) const {
    double travel = 0.0;
    for (std::size_t k = 0; k < scene_.cell.externalAxes().size(); ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      travel += std::abs(
          robot::asAngle(scene_.cell.externalAxes()[k].limits.kind, axes[axis] - from_.axes[axis]));
    }
    return travel;
  }

  // Returns one node per rung.
  std::vector<int> cheapest(const Grid& grid) const {
    const auto nodes = static_cast<std::size_t>(grid.size());
    std::vector<double> cost(nodes), before(nodes);
    std::vector<std::vector<std::uint8_t>> came(rungs_.size());
    for (std::size_t r = 0; r < rungs_.size(); ++r) {
      const Vector3d& direction = scene_.plan.direction[rungs_[r]];
      came[r].assign(nodes, 0);
      for (std::size_t n = 0; n < nodes; ++n) {
        const int node = static_cast<int>(n);
        double best = kInfinity;
        if (r == 0)
          best = kStartTravel * travelTo(grid.at(node));
        else
          for (std::size_t m = 0; m < grid.moves().size(); ++m) {
            // The moves contain the opposite of each move.
            const Grid::Move& move = grid.moves()[m];
            if (!grid.allows(node, move))
              continue;
            const double total = before[static_cast<std::size_t>(node + move.by)] + move.cost;
            if (total < best) {
              best = total;
              came[r][n] = static_cast<std::uint8_t>(m);
            }
          }
        cost[n] = best + leanCost(leanOf(direction, grid.upAt(node))) +
                  slideOffsetCost(grid.slideOffsetMm(node, scene_.plan.position[rungs_[r]]));
        if (const auto known = reached_.find({r, node}); known != reached_.end() && !known->second)
          cost[n] += kBlocked;
      }
      before.swap(cost);
    }
    std::vector<int> path(rungs_.size());
    int node = static_cast<int>(std::min_element(before.begin(), before.end()) - before.begin());
    for (std::size_t r = rungs_.size(); r-- > 0;) {
      path[r] = node;
      node += grid.moves()[came[r][static_cast<std::size_t>(node)]].by;
    }
    return path;
  }

  // Tests whether the arm reaches the untested positions along the path. Returns whether one of
  // them is blocked.
  bool lookAt(const Grid& grid, const std::vector<int>& path) {
    std::vector<std::size_t> todo;
    for (std::size_t r = 0; r < path.size(); ++r)
      if (!reached_.contains({r, path[r]}))
        todo.push_back(r);
    std::vector<char> reached(todo.size(), 0);
    base::parallelChunks(ctx_, todo.size(), 2, [&](std::size_t b, std::size_t e) {
      for (std::size_t t = b; t < e; ++t)
        reached[t] = getsThere(rungs_[todo[t]], grid.at(path[todo[t]]));
    });
    bool blocked = false;
    for (std::size_t t = 0; t < todo.size(); ++t) {
      reached_[{todo[t], path[todo[t]]}] = reached[t] != 0;
      blocked = blocked || reached[t] == 0;
    }
    return blocked;
  }

  // Returns the axes at each waypoint: linear between rungs, then smoothed.
  std::vector<JointVector> along(const Grid& grid, const std::vector<int>& path) const {
    std::vector<JointVector> axes{grid.at(path.front())};
    for (std::size_t r = 1; r < rungs_.size(); ++r) {
      const JointVector from = grid.at(path[r - 1]), to = grid.at(path[r]);
      const std::size_t b = rungs_[r - 1], e = rungs_[r];
      for (std::size_t i = b + 1; i <= e; ++i)
        axes.push_back(from +
                       static_cast<double>(i - b) / static_cast<double>(e - b) * (to - from));
    }
    for (std::size_t k = 0; k < scene_.cell.externalAxes().size(); ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      std::vector<double> course;
      for (const JointVector& a : axes)
        course.push_back(a[axis]);
      if (std::adjacent_find(course.begin(), course.end(), std::not_equal_to<>()) == course.end())
        continue;
      course = evened(course, kSmoothing);
      const robot::JointLimits& limits = scene_.cell.externalAxes()[k].limits;
      for (std::size_t i = 0; i < axes.size(); ++i)
        axes[i][axis] = std::clamp(course[i], limits.min, limits.max);
    }
    return axes;
  }

  const MotionScene& scene_;
  const base::RunContext& ctx_;
  std::size_t first_, count_;
  const RobotState& from_;
  std::vector<std::size_t> rungs_; // Waypoints
  // Per rung and node: whether the arm reaches it
  std::map<std::pair<std::size_t, int>, bool> reached_;
};

} // namespace

std::vector<JointVector> axisSchedule(const MotionScene& scene, std::size_t first,
                                      std::size_t count, const RobotState& from,
                                      const base::RunContext& ctx) {
  base::require(!scene.cell.externalAxes().empty() && !scene.cell.rod() && count > 0,
                "external axes that carry the platform, and a path");
  if (robot::tiltsPart(scene.cell))
    return uprightSchedule(scene.plan, scene.cell, first, count, from.axes);
  return Schedule(scene, first, count, from, ctx).find();
}

} // namespace voluta::motion
