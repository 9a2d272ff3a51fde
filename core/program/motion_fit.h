// Whether one motion of the nozzle can replace several motions of a bead within tolerances.
#pragma once

#include "program/common/arc.h"
#include "program/common/motion_targets.h"
#include "program/merged_points.h"
#include "program/program_input.h"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace voluta::program {

// `targets`: one per point of the input. The arguments must outlive the object.
class MotionFit {
public:
  MotionFit(const ProgramInput& input, const MergeLimits& limits,
            const std::vector<MotionTarget>& targets);

  // Returns whether all points in between are within tolerance of the straight motion.
  bool isLine(std::size_t from, std::size_t to) const;
  // Returns a tip in the middle of an arc that the path between both points follows within
  // tolerance: the points in between and the middles of the motions. nullopt if there is none of at
  // most half a turn.
  std::optional<Eigen::Vector3d> arcVia(std::size_t from, std::size_t to) const;

private:
  // Returns whether an amount, given at each point, grows with the length to within this share.
  bool growsEvenly(const std::vector<double>& amount, double share, std::size_t from,
                   std::size_t to, double lengthMm) const;
  bool hasSection(std::size_t from, std::size_t to, double lengthMm) const;
  bool hasSpeed(std::size_t from, std::size_t to, double lengthMm) const;
  bool hasDirection(std::size_t from, std::size_t to, std::size_t point, double share) const;
  Eigen::Vector3d tipOnLine(std::size_t from, std::size_t to, double share) const;
  bool canRotate(std::size_t from, std::size_t to) const;
  bool fits(const Arc& arc, std::size_t from, std::size_t to) const;
  bool turnsPart(std::size_t from, std::size_t to, double rad) const;

  const plan::Trajectory& in_;
  const robot::Cell& cell_;
  const MergeLimits& limits_;
  const std::vector<MotionTarget>& targets_;
  const bool heldInBase_; // the arm holds the part and moves it straight in Base
};

} // namespace voluta::program
