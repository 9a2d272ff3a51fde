#include "cells/reach_map.h"

#include "base/error.h"
#include "base/index.h"
#include "base/parallel.h"
#include "base/units.h"
#include "collision/cell_collision.h"
#include "geometry/convex_polygon.h"
#include "robot/leaning_tool.h"
#include "robot/plate.h"
#include "robot/upright_axes.h"

#include <algorithm>
#include <cmath>

namespace voluta::cells {

using base::kPi;
using robot::JointVector;

namespace {

const robot::Prism& plateOrThrow(const robot::Cell& cell) {
  const robot::Prism* plate = robot::plateOf(cell);
  if (!plate)
    throw base::Error(base::ErrorCode::Usage,
                      base::message("cell {cell} has no plate to map"_text, cell.id()), {},
                      "use a cell with a plate"_text);
  return *plate;
}

void check(const ReachGrid& grid) {
  const auto ascends = [](const std::vector<double>& values) {
    return !values.empty() && std::ranges::is_sorted(values, std::less_equal{});
  };
  base::require(grid.spacingMm > 0.0 && ascends(grid.heightsMm) && grid.heightsMm.front() > 0.0 &&
                    ascends(grid.tiltsRad) && grid.tiltsRad.front() == 0.0 &&
                    grid.tiltsRad.back() < kPi && grid.azimuths >= 1 && grid.turns >= 1 &&
                    grid.axisPlaces >= 1,
                "a grid of reach: lists that ascend, one of everything");
}

// Searches for a solution for a pose. The combination that solved the last pose is tried first,
// which affects only the speed, not the result.
class Reacher {
public:
  Reacher(const robot::Cell& cell, const collision::CellCollision& collision,
          const collision::Margins& margins, const ReachGrid& grid,
          const std::vector<JointVector>& axes)
      : cell_(cell), collision_(collision), margins_(margins), grid_(grid), axes_(axes),
        near_(cell.home()) {}

  bool reaches(const Eigen::Vector3d& tip, const Direction& direction) {
    // The head is rotationally symmetric: its collision with the plate depends on tip and direction
    // alone.
    if (collision_.headTouchesPlatform(poseOf(tip, direction, 0), margins_.headMm))
      return false;
    const std::vector<JointVector> upright =
        robot::tiltsPart(cell_) ? uprightPlaces(direction) : std::vector<JointVector>();
    const std::vector<JointVector>& axes = robot::tiltsPart(cell_) ? upright : axes_;
    const std::size_t turns = static_cast<std::size_t>(grid_.turns);
    const std::size_t ways = axes.size() * turns, from = last_;
    for (std::size_t n = 0; n < ways; ++n) {
      const std::size_t candidate = (from + n) % ways;
      if (!clear(poseOf(tip, direction, static_cast<int>(candidate % turns)),
                 axes[candidate / turns]))
        continue;
      last_ = candidate;
      return true;
    }
    return false;
  }

private:
  // Returns the places of the axes that turn the direction upright, within their limits; where the
  // second axis is free, as many as those of axes_.
  std::vector<JointVector> uprightPlaces(const Direction& direction) const {
    std::vector<JointVector> places;
    for (const robot::UprightAxes& at : robot::uprightAxes(cell_, direction.build))
      for (const JointVector& any : at.lastIsFree ? axes_ : std::vector<JointVector>{at.axes}) {
        const JointVector axes{{at.axes[0], any[1]}};
        const auto& all = cell_.externalAxes();
        bool within = true;
        for (std::size_t k = 0; k < all.size(); ++k)
          within = within && axes[static_cast<Eigen::Index>(k)] >= all[k].limits.min &&
                   axes[static_cast<Eigen::Index>(k)] <= all[k].limits.max;
        if (within)
          places.push_back(axes);
      }
    return places;
  }

  Eigen::Isometry3d poseOf(const Eigen::Vector3d& tip, const Direction& direction,
                           int rotation) const {
    const Eigen::Isometry3d pose = robot::leaningTool(
        tip, grid_.tiltsRad[direction.tilt], base::kTwoPi * direction.azimuth / grid_.azimuths,
        base::kTwoPi * rotation / grid_.turns);
    base::require(pose.linear().col(2).dot(direction.build) < -0.999,
                  "a tool against its direction");
    return pose;
  }

  bool clear(const Eigen::Isometry3d& work_T_tool, const JointVector& axes) {
    near_.tail(axes.size()) = axes;
    cell_.inverse(work_T_tool, near_, solutions_);
    return std::ranges::any_of(solutions_, [&](const JointVector& q) {
      cell_.framePoses(q, frames_);
      return !collision_.bodies(frames_, margins_);
    });
  }

  const robot::Cell& cell_;
  const collision::CellCollision& collision_;
  const collision::Margins& margins_;
  const ReachGrid& grid_;
  const std::vector<JointVector>& axes_;
  JointVector near_;
  std::vector<JointVector> solutions_;
  std::vector<Eigen::Isometry3d> frames_;
  std::size_t last_ = 0;
};

} // namespace

ReachGrid usualGrid(const robot::Cell& cell, const process::Process& process, double heightMm) {
  constexpr double kAcross = 24.0, kRoundMm = 5.0;
  constexpr int kHeights = 5;
  base::require(heightMm > 0.0, "a height to map");
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& corner : plateOrThrow(cell).polygon)
    box.extend(corner);
  ReachGrid grid;
  grid.spacingMm =
      kRoundMm * std::max(1.0, std::ceil(box.sizes().maxCoeff() / kAcross / kRoundMm - 1e-9));
  grid.heightsMm = {process.layerHeightMm};
  for (int i = 1; i <= kHeights; ++i)
    if (const double height = heightMm * i / kHeights; height > grid.heightsMm.back())
      grid.heightsMm.push_back(height);
  for (const double degrees : {0.0, 15.0, 30.0, 45.0, 60.0})
    grid.tiltsRad.push_back(base::degreesToRadians(degrees));
  return grid;
}

std::vector<Direction> directionsOf(const ReachGrid& grid) {
  std::vector<Direction> directions;
  for (std::size_t tilt = 0; tilt < grid.tiltsRad.size(); ++tilt)
    for (int side = 0; side < (tilt == 0 ? 1 : grid.azimuths); ++side) {
      const double t = grid.tiltsRad[tilt], a = base::kTwoPi * side / grid.azimuths;
      directions.push_back(
          {tilt, side, {std::sin(t) * std::cos(a), std::sin(t) * std::sin(a), std::cos(t)}});
    }
  return directions;
}

std::vector<JointVector> axisPlaces(const robot::Cell& cell, int places) {
  base::require(places >= 1, "a place of each axis");
  const auto& axes = cell.externalAxes();
  const auto count = static_cast<Eigen::Index>(axes.size());
  std::vector<JointVector> all{JointVector::Zero(count)};
  if (axes.empty())
    return all;
  std::vector<JointVector> combined = all;
  for (Eigen::Index k = 0; k < count; ++k) {
    const robot::JointLimits& limits = axes[static_cast<std::size_t>(k)].limits;
    const bool round =
        limits.kind == robot::JointKind::Turning && limits.max - limits.min >= base::kTwoPi;
    const double first = round ? std::max(limits.min, -kPi) : limits.min;
    const double step = round         ? base::kTwoPi / places
                        : places == 1 ? 0.0
                                      : (limits.max - limits.min) / (places - 1);
    std::vector<JointVector> next;
    for (const JointVector& before : combined)
      for (int i = 0; i < places; ++i) {
        next.push_back(before);
        next.back()[k] = std::min(first + step * i, limits.max);
      }
    combined = std::move(next);
  }
  all.insert(all.end(), combined.begin(), combined.end());
  return all;
}

ReachMap::ReachMap(ReachGrid grid, std::vector<Eigen::Vector2d> plate)
    : grid_(std::move(grid)), plate_(std::move(plate)), directions_(directionsOf(grid_)) {
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& corner : plate_)
    box.extend(corner);
  const auto first = [&](double low) {
    return static_cast<int>(std::ceil(low / grid_.spacingMm - 1e-9));
  };
  for (int row = first(box.min().y()); row * grid_.spacingMm <= box.max().y() + 1e-9; ++row)
    for (int column = first(box.min().x()); column * grid_.spacingMm <= box.max().x() + 1e-9;
         ++column) {
      const Eigen::Vector2d point(column * grid_.spacingMm, row * grid_.spacingMm);
      if (!geometry::inConvexPolygon(plate_, point))
        continue;
      points_.push_back(point);
      lattice_.emplace_back(column, row);
    }
  reached_.assign(points_.size() * grid_.heightsMm.size() * directions_.size(), 0);
}

double ReachMap::share(std::size_t point, double heightMm, double tiltRad) const {
  std::size_t asked = 0, met = 0;
  for (std::size_t h = 0; h < grid_.heightsMm.size(); ++h)
    for (std::size_t d = 0; d < directions_.size(); ++d) {
      if ((h > 0 && grid_.heightsMm[h] > heightMm + 1e-9) ||
          grid_.tiltsRad[directions_[d].tilt] > tiltRad + 1e-9)
        continue;
      ++asked;
      met += reached(point, h, d);
    }
  return asked > 0 ? static_cast<double>(met) / static_cast<double>(asked) : 0.0;
}

double ReachMap::shareOfTilt(std::size_t tilt) const {
  std::size_t asked = 0, met = 0;
  for (std::size_t point = 0; point < points_.size(); ++point)
    for (std::size_t h = 0; h < grid_.heightsMm.size(); ++h)
      for (std::size_t d = 0; d < directions_.size(); ++d)
        if (directions_[d].tilt == tilt) {
          ++asked;
          met += reached(point, h, d);
        }
  return asked > 0 ? static_cast<double>(met) / static_cast<double>(asked) : 0.0;
}

ReachMap reachMap(const robot::Cell& cell, const process::Process& process, ReachGrid grid,
                  const collision::Margins& margins, const base::RunContext& ctx) {
  check(grid);
  const robot::Prism& plate = plateOrThrow(cell);
  if (!cell.tilts())
    grid.tiltsRad.resize(1);
  ReachMap map(std::move(grid), plate.polygon);
  const collision::CellCollision collision(cell, process);
  const std::vector<JointVector> axes = axisPlaces(cell, map.grid().axisPlaces);
  constexpr std::size_t kGrain = 4;
  // Points are processed in bands so that progress can be reported.
  const std::size_t count = map.points().size();
  const std::size_t band = kGrain * static_cast<std::size_t>(std::max(1, ctx.threads())) * 4;
  for (std::size_t begin = 0; begin < count; begin += band) {
    const std::size_t length = std::min(band, count - begin);
    base::parallelChunks(ctx.quiet(), length, kGrain, [&](std::size_t from, std::size_t to) {
      Reacher reacher(cell, collision, margins, map.grid(), axes);
      for (std::size_t n = begin + from; n < begin + to; ++n)
        for (std::size_t h = 0; h < map.grid().heightsMm.size(); ++h) {
          ctx.quiet().checkpoint();
          const Eigen::Vector2d& at = map.points()[n];
          const Eigen::Vector3d tip(at.x(), at.y(), map.grid().heightsMm[h]);
          for (std::size_t d = 0; d < map.directions().size(); ++d)
            map.setReached(n, h, d, reacher.reaches(tip, map.directions()[d]));
        }
    });
    ctx.report(static_cast<double>(begin + length) / static_cast<double>(count),
               "reach of the head"_text);
  }
  return map;
}

} // namespace voluta::cells
