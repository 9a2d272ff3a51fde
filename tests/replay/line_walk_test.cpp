// Lines through boxes of cells against shares clipped cell by cell.
#include "replay/line_walk.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>
#include <vector>

namespace voluta::replay {
namespace {

// Of the line from a to b, in the unit cell at `low`.
double shareIn(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& low) {
  double begin = 0.0, end = 1.0;
  for (int k = 0; k < 3; ++k) {
    const double step = b[k] - a[k];
    if (step == 0.0) {
      if (a[k] < low[k] || a[k] >= low[k] + 1.0)
        return 0.0;
      continue;
    }
    const double first = (low[k] - a[k]) / step, second = (low[k] + 1.0 - a[k]) / step;
    begin = std::max(begin, std::min(first, second));
    end = std::min(end, std::max(first, second));
  }
  return std::max(0.0, end - begin);
}

TEST(LineWalk, FourLinesCrossTheirOwnCells) {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> u(0, 1);
  const Eigen::Vector3i size(7, 5, 4);
  for (int round = 0; round < 500; ++round) {
    Lines lines;
    for (std::size_t k = 0; k < 3; ++k) {
      const float maximum = static_cast<float>(size[static_cast<int>(k)]) - 0.02f;
      for (int l = 0; l < kLanes; ++l) {
        lines.from[k][l] = 0.01f + maximum * u(random);
        // Some along the cells' sides, some within a cell.
        lines.to[k][l] = u(random) < 0.2f ? lines.from[k][l] : 0.01f + maximum * u(random);
      }
    }
    std::array<std::vector<double>, kLanes> shares;
    for (auto& of : shares)
      of.assign(static_cast<std::size_t>(size.prod()), 0.0);
    alongLines(lines, size, [&](Ints cell, Floats part) {
      for (int l = 0; l < kLanes; ++l)
        shares[static_cast<std::size_t>(l)].at(static_cast<std::size_t>(cell[l])) +=
            static_cast<double>(part[l]);
    });
    for (int l = 0; l < kLanes; ++l) {
      Eigen::Vector3d from, to;
      for (int k = 0; k < 3; ++k) {
        from[k] = static_cast<double>(lines.from[static_cast<std::size_t>(k)][l]);
        to[k] = static_cast<double>(lines.to[static_cast<std::size_t>(k)][l]);
      }
      std::size_t at = 0;
      for (int z = 0; z < size.z(); ++z)
        for (int y = 0; y < size.y(); ++y)
          for (int x = 0; x < size.x(); ++x, ++at)
            ASSERT_NEAR(shares[static_cast<std::size_t>(l)][at],
                        shareIn(from, to, Eigen::Vector3d(x, y, z)), 1e-4)
                << round << " " << l;
    }
  }
}

TEST(LineWalk, LinesThatEndBeyondTheBoxStayInIt) {
  const Eigen::Vector3i size(3, 2, 1);
  Lines lines;
  lines.from = {Floats{-1e-4f, 3.0f, 1.5f, 0.5f}, Floats{0.5f, 2.0f, -1e-4f, 1.5f},
                Floats{0.5f, 1.0f, 0.0f, 0.5f}};
  lines.to = {Floats{3.0f, 0.0f, 1.5f, 0.5f}, Floats{0.5f, 0.0f, 2.0f, 1.5f},
              Floats{0.5f, 0.0f, 1.0f, 0.5f}};
  std::array<double, kLanes> length = {};
  alongLines(lines, size, [&](Ints cell, Floats part) {
    for (int l = 0; l < kLanes; ++l) {
      EXPECT_GE(cell[l], 0);
      EXPECT_LT(cell[l], 6);
      length[static_cast<std::size_t>(l)] += static_cast<double>(part[l]);
    }
  });
  for (const double of : length)
    EXPECT_NEAR(of, 1.0, 1e-5);
}

} // namespace
} // namespace voluta::replay
