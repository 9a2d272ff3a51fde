// The nozzle-shaped front against every voxel, one by one.
#include "curved/nozzle_reach.h"

#include "curved/decompose.h"
#include "curved/platform.h"
#include "curved/voxel_shapes.h"

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

TEST(NozzleReach, AgreesWithEveryVoxelAskedAlone) {
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
  std::size_t byHead = 0;
  for (std::size_t c = 0; c < d.rank.size(); ++c) {
    if (!d.byHead[c])
      continue;
    ++byHead;
    ASSERT_GT(d.rank[c], 0);
    const Eigen::Vector3d tip = d.grid.cell(c).cast<double>();
    for (std::size_t w = 0; w < d.rank.size(); ++w)
      if (d.rank[w] > 0 && d.rank[w] < d.rank[c]) {
        EXPECT_FALSE(
            insideCone(d.grid.cell(w).cast<double>(), tip, d.frontNormal[c].cast<double>()));
      }
  }
  EXPECT_EQ(byHead, d.headVoxels);
}

} // namespace
} // namespace voluta::curved
