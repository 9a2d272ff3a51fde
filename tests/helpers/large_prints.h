// Large made-up prints, for pictures and their times.
#pragma once

#include "base/units.h"
#include "curved/decomposition.h"
#include "layers/layer_stack.h"
#include "plan/tool_plan.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace voluta::test {

// A tower with a waved outline: walls around parallel lines, in steps of a millimetre.
class Tower {
public:
  Tower(int layers, double spacingMm) {
    for (int layer = 0; layer < layers; ++layer) {
      const double radius = 33.0 + 3.0 * std::sin(0.04 * layer);
      for (int ring = 0; ring < 2; ++ring)
        addWall(layer, radius - kWidth * ring);
      addLines(layer, radius - 2.0 * kWidth, layer % 2 == 0,
               layer < 3 || layer >= layers - 3 ? kWidth : spacingMm);
    }
  }

  plan::ToolPlan plan;

private:
  static constexpr double kWidth = 0.8, kHeight = 0.4, kStep = 0.7;

  void add(double x, double y, int layer) {
    plan.position.emplace_back(x, y, kHeight * (layer + 1));
    plan.direction.emplace_back(0.0, 0.0, 1.0);
    plan.widthMm.push_back(kWidth);
    plan.heightMm.push_back(kHeight);
    plan.speedMmPerS.push_back(30.0);
  }
  void close(std::size_t first, int layer, plan::PathKind kind, bool closed) {
    plan.paths.push_back({.first = first,
                          .count = plan.position.size() - first,
                          .kind = kind,
                          .layer = layer,
                          .closed = closed});
  }
  void addWall(int layer, double radius) {
    const std::size_t first = plan.position.size();
    const int steps = static_cast<int>(base::kTwoPi * radius / kStep);
    for (int i = 0; i <= steps; ++i) {
      const double angle = base::kTwoPi * (i % steps) / steps;
      const double r = radius + 1.5 * std::cos(12.0 * angle);
      add(r * std::cos(angle), r * std::sin(angle), layer);
    }
    close(first, layer, plan::PathKind::Wall, true);
  }
  void addLines(int layer, double radius, bool alongX, double spacingMm) {
    const double inner = radius - 2.0;
    for (double across = -inner; across < inner; across += spacingMm) {
      const double half = std::sqrt(inner * inner - across * across);
      const int steps = static_cast<int>(2.0 * half / kStep);
      if (steps < 1)
        continue;
      const std::size_t first = plan.position.size();
      for (int i = 0; i <= steps; ++i) {
        const double along = -half + 2.0 * half * i / steps;
        add(alongX ? along : across, alongX ? across : along, layer);
      }
      close(first, layer,
            spacingMm > kWidth ? plan::PathKind::SparseInfill : plan::PathKind::Infill, false);
    }
  }
};

// A ball with dents on a plate, layers as shells around a point below it.
inline curved::Decomposition lumpyBall(int cells) {
  curved::Decomposition d;
  d.grid.size = {cells, cells, cells};
  d.grid.pitch = 100.0 / cells;
  d.grid.origin = {-50.0, -50.0, 0.0};
  d.rank.assign(d.grid.cellCount(), 0);
  d.field.assign(d.grid.cellCount(), std::nanf(""));
  for (std::size_t c = 0; c < d.rank.size(); ++c) {
    const Eigen::Vector3i cell = d.grid.cell(c);
    const Eigen::Vector3d p = d.grid.centre(cell.x(), cell.y(), cell.z());
    const Eigen::Vector3d q = p - Eigen::Vector3d(0.0, 0.0, 50.0);
    const double dents = std::sin(0.25 * q.x()) * std::sin(0.25 * q.y()) * std::sin(0.25 * q.z());
    if (q.norm() > 46.0 + 3.0 * dents)
      continue;
    const double level = (p - Eigen::Vector3d(0.0, 0.0, -60.0)).norm() - 60.0;
    d.field[c] = static_cast<float>(std::max(0.0, level));
    d.rank[c] = 1 + static_cast<int>(d.field[c] / d.grid.pitch);
    d.layers = std::max(d.layers, d.rank[c]);
    ++d.voxels;
  }
  d.platform = {{-60, -60}, {60, -60}, {60, 60}, {-60, 60}};
  return d;
}

// The layers of such a ball as patches with a triangle for each voxel or so.
inline layers::LayerStack shellsOf(const curved::Decomposition& ball, double heightMm) {
  const double pitch = 1.4 * ball.grid.pitch;
  const Eigen::Vector3d centre(0.0, 0.0, -60.0);
  layers::LayerStack stack;
  for (int layer = 0; layer < static_cast<int>(95.0 / heightMm); ++layer) {
    layers::Patch patch;
    patch.layer = layer;
    const double radius = 60.0 + (layer + 0.5) * heightMm;
    const int n = static_cast<int>(100.0 / pitch);
    std::vector<int> index(static_cast<std::size_t>((n + 1) * (n + 1)), -1);
    const auto at = [&](int i, int j) -> int& {
      return index[static_cast<std::size_t>(j * (n + 1) + i)];
    };
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i) {
        const Eigen::Vector2d flat(i * pitch - 50.0, j * pitch - 50.0);
        const Eigen::Vector3d p =
            centre +
            Eigen::Vector3d(flat.x(), flat.y(), std::sqrt(radius * radius - flat.squaredNorm()));
        const Eigen::Vector3i cell = ball.grid.cellOf(p);
        if (!ball.grid.contains(cell.x(), cell.y(), cell.z()) ||
            ball.rank[ball.grid.index(cell.x(), cell.y(), cell.z())] <= 0)
          continue;
        at(i, j) = static_cast<int>(patch.surface.vertices.size());
        patch.surface.vertices.push_back(p);
        patch.direction.push_back((p - centre).normalized());
      }
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const int a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
        if (a >= 0 && b >= 0 && c >= 0)
          patch.surface.triangles.push_back({a, b, c});
        if (a >= 0 && c >= 0 && d >= 0)
          patch.surface.triangles.push_back({a, c, d});
      }
    patch.thicknessMm.assign(patch.surface.vertices.size(), heightMm);
    patch.clearDirection = patch.direction;
    if (!patch.surface.triangles.empty())
      stack.patches.push_back(std::move(patch));
  }
  stack.layerCount = stack.patches.back().layer + 1;
  return stack;
}

inline plan::ToolPlan wavedTower(int layers, double spacingMm) {
  return Tower(layers, spacingMm).plan;
}

} // namespace voluta::test
