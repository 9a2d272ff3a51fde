// Shots into pockets: their material on the grid.
#include "base/run_context.h"
#include "base/units.h"
#include "replay/depositor.h"
#include "replay/shot_fill.h"

#include <gtest/gtest.h>
#include <numeric>
#include <random>

namespace voluta::replay {
namespace {

using Eigen::Vector3d;
constexpr double kPitch = 0.25;

// A block of full cells with an empty round hole about z, from `bottom` to its top at 0.
BeadGrid blockWithHole(double radius, double bottom) {
  BeadGrid beads;
  beads.grid = gridOver({-8, -8, -8}, {8, 8, 2}, kPitch, 1'000'000);
  beads.fill = base::ZeroedArray<float>(beads.grid.cellCount());
  beads.filler = base::ZeroedArray<std::uint32_t>(beads.grid.cellCount());
  beads.rectangle = base::ZeroedArray<std::uint8_t>(beads.grid.cellCount());
  for (std::size_t c = 0; c < beads.grid.cellCount(); ++c) {
    const Eigen::Vector3i at = beads.grid.cell(c);
    const Vector3d p = beads.grid.centre(at.x(), at.y(), at.z());
    const bool isHole = p.head<2>().norm() < radius && p.z() > bottom;
    beads.fill[c] = p.z() > 0.0 || isHole ? 0.0f : 1.0f;
  }
  return beads;
}

BeadPiece shotOf(double mm3, double depth) {
  BeadPiece shot;
  shot.from = shot.to = Vector3d::Zero();
  shot.fromDirection = shot.toDirection = Vector3d::UnitZ();
  shot.fromHeightMm = shot.toHeightMm = static_cast<float>(depth);
  shot.volumeMm3 = static_cast<float>(mm3);
  shot.shot = true;
  return shot;
}

double volumeOf(const BeadGrid& beads) {
  return std::accumulate(beads.fill.begin(), beads.fill.end(), 0.0) * std::pow(kPitch, 3);
}

TEST(ShotFill, FillsItsPocketFromTheBottom) {
  BeadGrid beads = blockWithHole(2.0, -6.0);
  const double before = volumeOf(beads);
  const double half = 0.5 * base::kPi * 4.0 * 6.0;
  EXPECT_DOUBLE_EQ(fillFromTip(beads, shotOf(half, 6.0), 4), 0.0);
  EXPECT_NEAR(volumeOf(beads) - before, half, 1e-3 * half);
  const auto at = [&](double z) {
    const Eigen::Vector3i c = beads.grid.cellOf({0.1, 0.1, z});
    return beads.grid.index(c.x(), c.y(), c.z());
  };
  EXPECT_FLOAT_EQ(beads.fill[at(-5.9)], 1.0f);
  EXPECT_EQ(beads.filledBy(at(-5.9)), 4u);
  EXPECT_FLOAT_EQ(beads.fill[at(-0.2)], 0.0f);
  EXPECT_EQ(beads.filledBy(at(-0.2)), kNeverFilled);
}

// Nothing is lost: the material is on the grid, or excess. None of it is above the tip.
TEST(ShotFill, RandomShotsKeepTheirVolume) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const double cell = std::pow(kPitch, 3);
  for (int k = 0; k < 100; ++k) {
    const double radius = 1.0 + 3.0 * share(random), depth = 2.0 + 5.0 * share(random);
    BeadGrid beads = blockWithHole(radius, -depth);
    const double before = volumeOf(beads);
    double room = 0.0;
    for (std::size_t c = 0; c < beads.grid.cellCount(); ++c)
      if (beads.grid.centre(0, 0, beads.grid.cell(c).z()).z() < 0.0)
        room += cell * (1.0 - static_cast<double>(beads.fill[c]));
    const double mm3 = room * 1.5 * share(random);
    const double left = cell * fillFromTip(beads, shotOf(mm3, depth), 0);
    EXPECT_NEAR(volumeOf(beads) - before + left, mm3, 1e-3 * mm3 + 1e-3);
    EXPECT_NEAR(left, std::max(0.0, mm3 - room), 1e-3 * room);
    for (std::size_t c = 0; c < beads.grid.cellCount(); ++c) {
      const bool isAbove = beads.grid.centre(0, 0, beads.grid.cell(c).z()).z() > 0.0;
      ASSERT_TRUE(!isAbove || beads.fill[c] == 0.0f);
    }
  }
}

TEST(ShotFill, AFullBlockTakesNothing) {
  BeadGrid beads = blockWithHole(0.0, 0.0);
  EXPECT_NEAR(std::pow(kPitch, 3) * fillFromTip(beads, shotOf(50.0, 6.0), 0), 50.0, 1e-3);
}

// As one of the pieces of a print: its volume counts, and material without room is its excess.
TEST(ShotFill, TheDepositorCountsIt) {
  const BeadPiece shot = shotOf(40.0, 3.0);
  const BeadGrid beads = depositBeads(gridOver({-9, -9, -3}, {9, 9, 1}, kPitch, 1'000'000), {shot},
                                      DepositOptions{}, base::RunContext());
  EXPECT_NEAR(beads.depositedMm3, 40.0, 1e-4);
  EXPECT_NEAR(volumeOf(beads) + beads.excessMm3, 40.0, 1e-2);
  EXPECT_FLOAT_EQ(beads.pieceExcessMm3.at(0), static_cast<float>(beads.excessMm3));
}

} // namespace
} // namespace voluta::replay
