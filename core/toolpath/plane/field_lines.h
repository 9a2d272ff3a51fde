// Isolines of a function of the plane.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

namespace voluta::toolpath {

struct PlaneLine {
  std::vector<Eigen::Vector2d> points; // a closed line does not repeat its first point
  bool isClosed = false;
};

// Where isolines are sought [mm].
struct PlaneBox {
  Eigen::Vector2d low = Eigen::Vector2d::Zero(), high = Eigen::Vector2d::Zero();
};

// Returns the lines in the box where `value` is an integer plus one half: on the edges of a grid of
// `stepMm`, each point found to a small share of the step. Details finer than the step are lost.
// Deterministic order. `isWanted`: lines are only sought in cells with a corner where it holds.
std::vector<PlaneLine> fieldLines(const PlaneBox& box, double stepMm,
                                  const std::function<double(const Eigen::Vector2d&)>& value,
                                  const std::function<bool(const Eigen::Vector2d&)>& isWanted);

} // namespace voluta::toolpath
