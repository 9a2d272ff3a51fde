// A second opinion on coverage that shares no code with the planner: volume is deposited sample by
// sample under each bead and, where a sample is full, moved to the nearest one with room.
#pragma once

#include "layers/layer_stack.h"
#include "process/bead_model.h"
#include "toolpath/coverage/cover_patch.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace voluta::test {

struct Painted {
  double areaMm2 = 0, coveredMm2 = 0; // of the patch; of it, filled (partly filled counts partly)
  double excessMm2 = 0;               // deposited, but no room within a quarter width of the bead
};

// Beads are painted as rectangles: length x width across, in the tangent plane; their material is
// length x hatch (the section's area by its height).
inline Painted paint(const layers::Patch& patch, const std::vector<toolpath::Bead>& beads) {
  struct Sample {
    Eigen::Vector3d p;
    double area, fill = 0;
  };
  std::vector<Sample> samples;
  Painted result;
  constexpr double kDensity = 100; // per mm2
  for (const auto& t : patch.surface.triangles) {
    const auto at = [&](int k) {
      return patch.surface.vertices[static_cast<std::size_t>(t[static_cast<std::size_t>(k)])];
    };
    const double area = 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).norm();
    const int n = std::max(1, static_cast<int>(std::ceil(std::sqrt(area * kDensity))));
    // Centres of n x n like triangles.
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < 2 * (n - i) - 1; ++j) {
        const double third = j % 2 == 0 ? 1.0 / 3 : 2.0 / 3;
        const double u = (i + third) / n, v = (j / 2 + third) / n;
        samples.push_back({at(0) + u * (at(1) - at(0)) + v * (at(2) - at(0)), area / (n * n)});
      }
    result.areaMm2 += area;
  }
  const auto key = [](const Eigen::Vector3d& p) {
    return std::tuple(static_cast<int>(std::floor(p.x())), static_cast<int>(std::floor(p.y())),
                      static_cast<int>(std::floor(p.z())));
  };
  std::map<std::tuple<int, int, int>, std::vector<std::size_t>> cells;
  for (std::size_t i = 0; i < samples.size(); ++i)
    cells[key(samples[i].p)].push_back(i);
  for (const toolpath::Bead& b : beads)
    for (std::size_t i = 1; i < b.points.size(); ++i) {
      const auto &p = b.points[i - 1], &q = b.points[i];
      const Eigen::Vector3d along = q.middle - p.middle;
      const double length = along.norm(), w = 0.5 * (p.widthMm + q.widthMm),
                   h = 0.5 * (p.heightMm + q.heightMm);
      const Eigen::Vector3d side = p.direction.cross(along / length).normalized();
      const double tipLength =
          (along + 0.5 * (q.heightMm * q.direction - p.heightMm * p.direction)).norm();
      double material = tipLength * process::beadArea(w, h) / h;
      std::vector<std::pair<double, std::size_t>> near; // by distance aside
      const Eigen::Vector3d middle = 0.5 * (p.middle + q.middle);
      const int r = 2;
      const auto [cx, cy, cz] = key(middle);
      for (int x = cx - r; x <= cx + r; ++x)
        for (int y = cy - r; y <= cy + r; ++y)
          for (int z = cz - r; z <= cz + r; ++z)
            if (const auto it = cells.find({x, y, z}); it != cells.end())
              for (const std::size_t s : it->second) {
                const Eigen::Vector3d d = samples[s].p - p.middle;
                const double u = d.dot(along) / length, x0 = std::abs(d.dot(side));
                if (u >= 0 && u <= length && x0 <= 0.75 * w)
                  near.emplace_back(x0, s);
              }
      std::ranges::sort(near);
      for (const auto& [offset, s] : near) {
        const double put = std::min(material, samples[s].area - samples[s].fill);
        samples[s].fill += put;
        material -= put;
      }
      result.excessMm2 += material;
    }
  for (const Sample& s : samples)
    result.coveredMm2 += s.fill;
  return result;
}

} // namespace voluta::test
