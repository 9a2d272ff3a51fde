// Tool plans in closed form.
#pragma once

#include "base/units.h"
#include "plan/tool_plan.h"

#include <cmath>
#include <functional>
#include <vector>

namespace voluta::test {

// Appends a path of points with directions, in steps of about 1 mm where `points` are closer.
inline void appendPath(plan::ToolPlan& plan, const std::vector<Eigen::Vector3d>& points,
                       const std::vector<Eigen::Vector3d>& directions, int layer,
                       bool closed = false) {
  plan::ToolPath path;
  path.first = plan.waypointCount();
  path.count = points.size();
  path.layer = layer;
  path.patch = layer;
  path.closed = closed;
  for (std::size_t i = 0; i < points.size(); ++i) {
    plan.position.push_back(points[i]);
    plan.direction.push_back(directions[i].normalized());
    plan.widthMm.push_back(1.2f);
    plan.heightMm.push_back(0.8f);
    plan.speedMmPerS.push_back(20.0f);
  }
  plan.paths.push_back(path);
}

// Rings of a surface of revolution, one path a layer: radius and direction's tilt by height.
inline plan::ToolPlan rings(int layers, const std::function<double(int)>& radius,
                            const std::function<double(int)>& height,
                            const std::function<double(int)>& tilt) {
  plan::ToolPlan plan;
  for (int l = 0; l < layers; ++l) {
    const int steps = std::max(12, static_cast<int>(std::ceil(2 * base::kPi * radius(l))));
    std::vector<Eigen::Vector3d> points, directions;
    for (int i = 0; i <= steps; ++i) {
      const double a = 2 * base::kPi * (i % steps) / steps;
      const Eigen::Vector3d out(std::cos(a), std::sin(a), 0);
      points.push_back(radius(l) * out + Eigen::Vector3d(0, 0, height(l)));
      directions.push_back(std::sin(tilt(l)) * out + Eigen::Vector3d(0, 0, std::cos(tilt(l))));
    }
    appendPath(plan, points, directions, l, true);
  }
  return plan;
}

inline plan::ToolPlan cylinder(double radius, int layers) {
  return rings(
      layers, [=](int) { return radius; }, [](int l) { return 0.8 * (l + 1); },
      [](int) { return 0.0; });
}

// A shell on a hemisphere, rings from its foot (tilt 90 degrees) towards its top.
inline plan::ToolPlan hemisphere(double radius, double lift, double tiltFrom, double tiltTo) {
  const int layers = std::max(2, static_cast<int>(radius * (tiltFrom - tiltTo) / 1.0));
  const auto angle = [=](int l) { return tiltFrom - (tiltFrom - tiltTo) * l / (layers - 1); };
  return rings(
      layers, [=](int l) { return radius * std::sin(angle(l)); },
      [=](int l) { return lift + radius * std::cos(angle(l)); }, angle);
}

// A flat layer of parallel lines, joined into a zigzag.
inline plan::ToolPlan slab(double size, int layers) {
  plan::ToolPlan plan;
  for (int l = 0; l < layers; ++l) {
    std::vector<Eigen::Vector3d> points;
    const int lines = static_cast<int>(size / 1.1);
    for (int y = 0; y < lines; ++y)
      for (int x = 0; x <= static_cast<int>(size); ++x) {
        const double along = (y % 2 ? size - x : x) - size / 2, across = 1.1 * y - size / 2;
        points.push_back(l % 2 ? Eigen::Vector3d(across, along, 0.8 * (l + 1))
                               : Eigen::Vector3d(along, across, 0.8 * (l + 1)));
      }
    appendPath(plan, points, std::vector<Eigen::Vector3d>(points.size(), Eigen::Vector3d::UnitZ()),
               l);
  }
  return plan;
}

inline std::vector<Eigen::Vector2d> disc(double radius) {
  std::vector<Eigen::Vector2d> polygon;
  for (int i = 0; i < 32; ++i)
    polygon.emplace_back(radius * std::cos(i * base::kPi / 16),
                         radius * std::sin(i * base::kPi / 16));
  return polygon;
}

} // namespace voluta::test
