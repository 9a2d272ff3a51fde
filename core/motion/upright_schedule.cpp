#include "motion/upright_schedule.h"

#include "base/error.h"
#include "base/units.h"
#include "geometry/directions.h"
#include "robot/upright_axes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace voluta::motion {

using robot::JointVector;

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
// Rotation before the path, with the nozzle lifted, relative to rotation along it
constexpr double kBefore = 0.3;
constexpr std::size_t kSides = 2;
// Steps between two waypoints, of the first axis beyond the angle between their directions: no
// change of sides amid a bead. Near the second axis that axis may turn far, up to where the other
// side is nearer.
constexpr double kMaxTilt = base::degreesToRadians(20.0),
                 kMaxRotation = base::degreesToRadians(100.0);

// The best way to a position of the axes at a waypoint.
struct State {
  JointVector axes;
  double cost = kInfinity;
  std::size_t before = 0; // side at the waypoint before
  bool lastIsFree = false;
};
using States = std::array<State, kSides>;

bool within(double value, const robot::JointLimits& limits) {
  return value >= limits.min && value <= limits.max;
}

class Schedule {
public:
  Schedule(const plan::ToolPlan& plan, const robot::Cell& cell, std::size_t first,
           std::size_t count, const JointVector& from)
      : plan_(plan), cell_(cell), first_(first), count_(count), from_(from) {}

  std::vector<JointVector> find() {
    for (std::size_t i = 0; i < count_; ++i) {
      States states = statesAt(i);
      if (states[0].cost == kInfinity && states[1].cost == kInfinity)
        break;
      states_.push_back(std::move(states));
    }
    std::vector<JointVector> axes(states_.size());
    if (states_.empty())
      return axes;
    std::vector<char> isFree(states_.size(), 0);
    std::size_t side = states_.back()[1].cost < states_.back()[0].cost ? 1 : 0;
    for (std::size_t i = states_.size(); i-- > 0;) {
      const State& state = states_[i][side];
      axes[i] = state.axes;
      isFree[i] = state.lastIsFree ? 1 : 0;
      side = state.before;
    }
    spread(isFree, axes);
    return axes;
  }

private:
  // Returns the axes of waypoint i nearest to `last` by whole turns. At the path's start they may
  // be further, to be within the limits. nullopt if they are not, or if the table would swing amid
  // the path.
  std::optional<JointVector> near(const robot::UprightAxes& at, const JointVector& last,
                                  std::size_t i) const {
    const bool starts = i == 0;
    const double direction = starts ? 0.0
                                    : geometry::angleBetween(plan_.direction[first_ + i - 1],
                                                             plan_.direction[first_ + i]);
    const double maximum[] = {kMaxTilt + direction, kMaxRotation};
    JointVector axes = at.axes;
    if (at.lastIsFree)
      axes[1] = last[1];
    for (Eigen::Index k = 0; k < axes.size(); ++k) {
      const robot::JointLimits& limits = cell_.externalAxes()[static_cast<std::size_t>(k)].limits;
      axes[k] += base::kTwoPi * std::round((last[k] - axes[k]) / base::kTwoPi);
      while (starts && axes[k] > limits.max)
        axes[k] -= base::kTwoPi;
      while (starts && axes[k] < limits.min)
        axes[k] += base::kTwoPi;
      if (!within(axes[k], limits) || (!starts && std::abs(axes[k] - last[k]) > maximum[k]))
        return std::nullopt;
    }
    return axes;
  }

  States statesAt(std::size_t i) const {
    const std::vector<robot::UprightAxes> sides =
        robot::uprightAxes(cell_, plan_.direction[first_ + i]);
    States states;
    for (std::size_t s = 0; s < kSides && !sides.empty(); ++s) {
      const robot::UprightAxes& side = sides[std::min(s, sides.size() - 1)];
      const std::size_t ways = i == 0 ? 1 : kSides;
      for (std::size_t b = 0; b < ways; ++b) {
        const double before = i == 0 ? 0.0 : states_[i - 1][b].cost;
        // Where the second axis is free both states go on, each with its own angle.
        if (before == kInfinity || (side.lastIsFree && i > 0 && b != s))
          continue;
        const JointVector& last = i == 0 ? from_ : states_[i - 1][b].axes;
        const auto axes = near(side, last, i);
        if (!axes)
          continue;
        const double cost = before + (i == 0 ? kBefore : 1.0) * (*axes - last).cwiseAbs().sum();
        if (cost < states[s].cost)
          states[s] = {*axes, cost, b, side.lastIsFree};
      }
    }
    return states;
  }

  // Moves the second axis evenly where it is free; before the first required angle it has that
  // angle.
  void spread(const std::vector<char>& isFree, std::vector<JointVector>& axes) const {
    for (std::size_t i = 0; i < axes.size(); ++i) {
      if (!isFree[i])
        continue;
      std::size_t next = i;
      while (next < axes.size() && isFree[next])
        ++next;
      if (next == axes.size())
        return;
      const double to = axes[next][1], from = i == 0 ? to : axes[i - 1][1];
      const auto steps = static_cast<double>(next - i + 1);
      for (std::size_t k = i; k < next; ++k)
        axes[k][1] = from + (to - from) * static_cast<double>(k - i + 1) / steps;
      i = next;
    }
  }

  const plan::ToolPlan& plan_;
  const robot::Cell& cell_;
  std::size_t first_, count_;
  const JointVector& from_;
  std::vector<States> states_; // per waypoint
};

} // namespace

std::vector<JointVector> uprightSchedule(const plan::ToolPlan& plan, const robot::Cell& cell,
                                         std::size_t first, std::size_t count,
                                         const JointVector& from) {
  base::require(robot::tiltsPart(cell) && from.size() == 2 && count > 0,
                "a table that tilts and turns the part along a path");
  return Schedule(plan, cell, first, count, from).find();
}

} // namespace voluta::motion
