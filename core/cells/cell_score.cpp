#include "cells/cell_score.h"

#include "base/parallel.h"
#include "base/units.h"
#include "collision/cell_collision.h"
#include "collision/shape_distance.h"
#include "geometry/directions.h"
#include "robot/leaning_tool.h"
#include "robot/nozzle_turns.h"

#include <cmath>
#include <numeric>

namespace voluta::cells {

namespace {

using base::kPi;
using Eigen::Vector3d;
using robot::JointVector;

// radius of the ball for the part, relative to the ball of poses
constexpr double kPartShare = 0.77;

std::vector<Vector3d> pointsOf(const PosePattern& pattern) {
  std::vector<Vector3d> points{{0, 0, 1}, {15, 0, 1}};
  for (int i = 0; i < pattern.shells; ++i) {
    const Vector3d d = geometry::onSpiral(i, 1.0 - 2.0 * (i + 0.5) / pattern.shells);
    points.emplace_back(pattern.radiusMm * (d + Vector3d::UnitZ()));
    points.emplace_back(pattern.radiusMm * (0.5 * d + Vector3d::UnitZ()));
  }
  return points;
}

class Clear {
public:
  Clear(const robot::Cell& cell, const collision::CellCollision& bodies, double partRadius)
      : cell_(cell), bodies_(bodies), radius_(partRadius) {}

  bool operator()(const JointVector& q) {
    cell_.framePoses(q, frames_);
    if (touchesPart())
      return false;
    return !bodies_.bodies(frames_, {kClearMm, kClearMm, 0.0});
  }

private:
  bool touchesPart() const {
    const Vector3d part =
        frames_[static_cast<std::size_t>(cell_.workFrame())] * Vector3d(0, 0, radius_ + 2.0);
    for (const int b : cell_.bodiesAgainstPart()) {
      const robot::Body& body = cell_.bodies()[static_cast<std::size_t>(b)];
      if (body.role != robot::BodyRole::Link)
        continue;
      const Vector3d at = frames_[static_cast<std::size_t>(body.frame)].inverse() * part;
      for (const robot::Shape& shape : body.shapes)
        if (collision::signedDistance(shape, at) < radius_ + kClearMm)
          return true;
    }
    return false;
  }

  const robot::Cell& cell_;
  const collision::CellCollision& bodies_;
  double radius_;
  std::vector<Eigen::Isometry3d> frames_;
};

} // namespace

double CellScore::share(std::size_t tilt) const {
  return poses[tilt] > 0 ? static_cast<double>(clear[tilt]) / poses[tilt] : 0.0;
}

double CellScore::share() const {
  const int all = std::accumulate(poses.begin(), poses.end(), 0);
  return all > 0 ? std::accumulate(clear.begin(), clear.end(), 0) / static_cast<double>(all) : 0.0;
}

double CellScore::meanOfTilts() const {
  double sum = 0.0;
  for (std::size_t t = 0; t < poses.size(); ++t)
    sum += share(t);
  return poses.empty() ? 0.0 : sum / static_cast<double>(poses.size());
}

CellScore& CellScore::operator+=(const CellScore& other) {
  for (std::size_t t = 0; t < poses.size(); ++t) {
    poses[t] += other.poses[t];
    reached[t] += other.reached[t];
    clear[t] += other.clear[t];
  }
  return *this;
}

std::vector<Eigen::Vector2d> smallPlate() {
  std::vector<Eigen::Vector2d> disc;
  for (int i = 0; i < 16; ++i)
    disc.emplace_back(20.0 * std::cos(kPi * i / 8), 20.0 * std::sin(kPi * i / 8));
  return disc;
}

CellScore scoreOf(const robot::Cell& cell, const process::Process& process,
                  const PosePattern& pattern, const base::RunContext& ctx) {
  const collision::CellCollision bodies(cell, process);
  const std::vector<Vector3d> points = pointsOf(pattern);
  const std::size_t tilts = cell.tilts() ? pattern.tiltDeg.size() : 1;
  const std::vector<int> none(tilts, 0);
  return base::parallelSum<CellScore>(
      ctx, points.size(), 1, {none, none, none}, [&](std::size_t begin, std::size_t end) {
        CellScore score{none, none, none};
        Clear clear(cell, bodies, kPartShare * pattern.radiusMm);
        std::vector<JointVector> solutions;
        int lastRotation = 0; // a turn that was clear is likely to be clear at the next pose
        for (std::size_t p = begin; p < end; ++p)
          for (std::size_t tilt = 0; tilt < tilts; ++tilt) {
            const double lean = base::degreesToRadians(pattern.tiltDeg[tilt]);
            for (int side = 0; side < (lean == 0.0 ? 1 : pattern.sides); ++side) {
              const robot::NozzleTurns turns(
                  cell, robot::leaningTool(points[p], lean, 2.0 * kPi * side / pattern.sides),
                  cell.home());
              bool reached = false, isClear = false;
              for (int i = 0; i < pattern.turns && !isClear; ++i) {
                const int rotation = (lastRotation + i) % pattern.turns;
                turns.at(2.0 * kPi * rotation / pattern.turns, solutions);
                reached = reached || !solutions.empty();
                for (std::size_t s = 0; s < solutions.size() && !isClear; ++s)
                  isClear = clear(solutions[s]);
                if (isClear)
                  lastRotation = rotation;
              }
              ++score.poses[tilt];
              score.reached[tilt] += reached ? 1 : 0;
              score.clear[tilt] += isClear ? 1 : 0;
            }
          }
        return score;
      });
}

} // namespace voluta::cells
