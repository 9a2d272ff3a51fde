// The nozzle-shaped front against every voxel, one by one.
#include "curved/nozzle_reach.h"

#include "curved/decompose.h"
#include "curved/platform_polygon.h"
#include "curved/voxel_shapes.h"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace voluta::curved {
namespace {

const base::RunContext kQuiet;

// A cone of half angle 30 degrees under a block.
process::HeadShape cone(double scale = 1.0) {
  process::HeadShape head;
  head.sections = {{0.0, 0.4 * scale},
                   {8.0 * scale, 5.0 * scale},
                   {8.0 * scale, 9.0 * scale},
                   {80.0 * scale, 9.0 * scale}};
  return head;
}

// Radius of the cone above at a height over the tip; -1: no head there.
double coneRadius(double z) {
  if (z < 0.0 || z > 80.0)
    return -1.0;
  return z < 8.0 ? 0.4 + z * (5.0 - 0.4) / 8.0 : 9.0;
}

bool insideCone(const Eigen::Vector3d& p, const Eigen::Vector3d& tip, const Eigen::Vector3d& d) {
  const double z = (p - tip).dot(d);
  return z > 1e-6 && (p - tip - z * d).norm() < coneRadius(z) - 1e-6;
}

TEST(NozzleReach, AgreesWithAQueryPerVoxel) {
  const voxel::SolidVoxels part = test::blobPart(5);
  const VoxelGraph graph =
      voxelGraph(part.grid, part.solid, part.plateLayer(), platformFit(part, 0.0));
  NozzleReach reach(graph, cone());
  std::mt19937 random(3);
  std::vector<std::uint8_t> present(graph.size(), 0);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::size_t clear = 0, blocked = 0;
  for (int round = 0; round < 6; ++round) {
    for (std::size_t v = 0; v < graph.size(); ++v) {
      const bool stays = random() % 6 < static_cast<unsigned>(round);
      if (stays != (present[v] != 0)) {
        present[v] = stays;
        stays ? reach.insert(v) : reach.remove(v);
      }
    }
    for (int asked = 0; asked < 300; ++asked) {
      const std::size_t v = random() % graph.size();
      const Eigen::Vector3d d =
          Eigen::Vector3d(unit(random), unit(random), 0.3 + unit(random)).normalized();
      const auto at = [&](std::size_t w) {
        return Eigen::Vector3d(graph.cell[w][0], graph.cell[w][1], graph.cell[w][2]);
      };
      bool expected = true;
      for (std::size_t w = 0; w < graph.size() && expected; ++w)
        expected = !present[w] || w == v || !insideCone(at(w), at(v), d);
      // The lowest point of the head over the plate, by its rims.
      const double plate = graph.plateLayer - 0.5, lean = std::sqrt(1.0 - d.z() * d.z());
      for (const process::HeadSection& s : cone().sections)
        expected &= at(v).z() + s.zMm * d.z() - s.radiusMm * lean >= plate - 1e-6;
      EXPECT_EQ(reach.clear(v, d), expected);
      (expected ? clear : blocked) += 1;
    }
  }
  EXPECT_GT(clear, 50u);
  EXPECT_GT(blocked, 50u);
}

TEST(NozzleReach, NothingIsClearUnderARoof) {
  const voxel::SolidVoxels part = test::voxelPart(40, 40, 14, [](int i, int j, int k) {
    return k >= 12 || (std::abs(i - 20) < 2 && std::abs(j - 20) < 2);
  });
  const VoxelGraph graph =
      voxelGraph(part.grid, part.solid, part.plateLayer(), platformFit(part, 0.0));
  NozzleReach reach(graph, cone());
  for (std::size_t v = 0; v < graph.size(); ++v)
    reach.insert(v);
  for (std::size_t v = 0; v < graph.size(); ++v) {
    const auto d = reach.direction(v, Eigen::Vector3d::UnitZ());
    if (graph.cell[v][2] == part.grid.size.z() - 2) {
      ASSERT_TRUE(d.has_value()); // the roof's top
      EXPECT_TRUE(d->isApprox(Eigen::Vector3d::UnitZ()));
    } else if (graph.cell[v][2] == 2) {
      EXPECT_FALSE(d.has_value());
    }
  }
}

TEST(Decompose, AHeadReachesTheHookThatAFlatFrontShadows) {
  const voxel::SolidVoxels part = test::voxelPart(61, 7, 24, [](int i, int, int k) {
    return i < 5 || i >= 56 || k >= 19 || (i >= 28 && i < 33 && k >= 15);
  });
  CurvedOptions options;
  const auto platform = platformFit(part, 0.0);
  const Decomposition flat = decompose(part, platform, options, kQuiet);
  ASSERT_GT(flat.shadowedVoxels, 0u);
  options.head = cone(part.grid.pitch);
  const Decomposition d = decompose(part, platform, options, kQuiet);
  EXPECT_LT(d.missedVoxels, flat.missedVoxels);
  ASSERT_GT(d.headVoxels, 0u);
  std::size_t byHead = 0, inOrder = 0;
  for (std::size_t c = 0; c < d.rank.size(); ++c) {
    byHead += d.byHead[c] != 0;
    if (d.byHead[c] != 1)
      continue;
    ++inOrder;
    ASSERT_GT(d.rank[c], 0);
    const Eigen::Vector3d tip = d.grid.cell(c).cast<double>();
    for (std::size_t w = 0; w < d.rank.size(); ++w)
      if (d.rank[w] > 0 && d.rank[w] < d.rank[c]) {
        EXPECT_FALSE(
            insideCone(d.grid.cell(w).cast<double>(), tip, d.frontNormal[c].cast<double>()));
      }
  }
  EXPECT_EQ(byHead, d.headVoxels);
  EXPECT_GT(inOrder, 0u);
}

// Direction of growth by least squares over the cells around.
Eigen::Vector3d growthAt(const Decomposition& d, const Eigen::Vector3i& cell) {
  const auto value = [&](const Eigen::Vector3i& at) {
    return static_cast<double>(d.field[d.grid.index(at.x(), at.y(), at.z())]);
  };
  Eigen::Matrix3d a = 1e-9 * Eigen::Matrix3d::Identity();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  for (int n = 0; n < 27; ++n) {
    const Eigen::Vector3i step(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
    const double rise = value(cell + step) - value(cell);
    if (std::isnan(rise))
      continue;
    a += (step * step.transpose()).cast<double>();
    b += rise * step.cast<double>();
  }
  return a.ldlt().solve(b).normalized();
}

TEST(Decompose, UnderARoofLayersLeanAsFarAsTheHeadReaches) {
  constexpr double kOut = 22.0, kIn = 17.0;
  const Eigen::Vector3d centre(22.0, 22.0, -0.5);
  const auto inShell = [&](int i, int j, int k) {
    const double r = (Eigen::Vector3d(i, j, k) - centre).norm();
    return r <= kOut && r > kIn;
  };
  const voxel::SolidVoxels part = test::voxelPart(45, 45, 22, inShell);
  // Of the cells under the roof, the share that growth leaves at more than 60 degrees.
  const auto roof = [&](const Decomposition& d) {
    double all = 0.0, flat = 0.0;
    for (int k = 8; k < 22; ++k)
      for (int j = 0; j < 45; ++j)
        for (int i = 0; i < 45; ++i) {
          if (!inShell(i, j, k) || inShell(i, j, k - 1))
            continue;
          const Eigen::Vector3d down = (centre - Eigen::Vector3d(i, j, k)).normalized();
          ++all;
          flat += growthAt(d, {i + 1, j + 1, k + 1}).dot(down) < -0.866;
        }
    return flat / all;
  };
  CurvedOptions options;
  const auto platform = platformFit(part, 0.0);
  const Decomposition flat = decompose(part, platform, options, kQuiet);
  options.head = cone(part.grid.pitch);
  options.headForLosses = false;
  const Decomposition d = decompose(part, platform, options, kQuiet);
  EXPECT_GT(roof(flat), 0.1);
  EXPECT_LT(roof(d), 0.4 * roof(flat));
  EXPECT_TRUE(flat.byHead.empty());
  ASSERT_GT(d.headVoxels, 0u);
  EXPECT_EQ(d.missedVoxels, 0u);
  const auto level = [&](std::size_t c) { return std::floor(d.field[c] / options.layerHeightMm); };
  for (std::size_t c = 0; c < d.rank.size(); ++c) {
    if (!d.byHead[c])
      continue;
    EXPECT_EQ(d.byHead[c], 2);
    const Eigen::Vector3d tip = d.grid.cell(c).cast<double>();
    for (std::size_t w = 0; w < d.rank.size(); ++w)
      if (d.rank[w] > 0 && level(w) < level(c)) {
        EXPECT_FALSE(
            insideCone(d.grid.cell(w).cast<double>(), tip, d.frontNormal[c].cast<double>()));
      }
  }
}

} // namespace
} // namespace voluta::curved
