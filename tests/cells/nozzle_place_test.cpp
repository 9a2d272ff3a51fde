#include "cells/nozzle_place.h"

#include <cstdlib>
#include <gtest/gtest.h>
#include <random>

namespace voluta::cells {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

std::size_t counted(const std::vector<Vector3d>& frames, const Vector3d& at, const Vector3d& half) {
  std::size_t count = 0;
  for (const Vector3d& p : frames)
    count += ((p - at + half).array() >= 0.0).all() && ((p - at - half).array() < 0.0).all();
  return count;
}

TEST(NozzlePlace, EqualsCountingEveryPlace) {
  std::mt19937_64 random(9);
  for (int round = 0; round < 10; ++round) {
    std::normal_distribution<double> spread(0.0, 60.0);
    std::vector<Vector3d> frames;
    for (int n = 0; n < 300; ++n)
      frames.emplace_back(spread(random) + 100, spread(random), spread(random) - 40);
    const double step = 20.0;
    const Vector3i box(4, 2, 6);
    const Vector3d half = 0.5 * step * box.cast<double>();
    const NozzlePlace found = bestNozzlePlace(frames, step, box);
    EXPECT_EQ(found.frames, counted(frames, found.at, half));
    std::size_t maximum = 0;
    for (int x = -20; x <= 30; ++x)
      for (int y = -20; y <= 20; ++y)
        for (int z = -25; z <= 20; ++z)
          maximum = std::max(maximum, counted(frames, step * Vector3d(x, y, z), half));
    EXPECT_EQ(found.frames, maximum);
  }
  EXPECT_EQ(bestNozzlePlace({}, 10, {2, 2, 2}).frames, 0u);
}

// Frames that face down are excluded, and the same seed draws the same frames.
TEST(NozzlePlace, FramesOfAnArmFaceUpAndAreDrawnAgain) {
  setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1);
  const robot::RobotModel ur5 = robot::loadRobot("ur5");
  NozzleSearch search;
  search.samples = 4000;
  search.flange_T_work.translation().z() = 100;
  const std::vector<Vector3d> frames = reachableFrames(ur5, search);
  // About half of all directions.
  EXPECT_GT(frames.size(), 1700u);
  EXPECT_LT(frames.size(), 2300u);
  const std::vector<Vector3d> again = reachableFrames(ur5, search);
  ASSERT_EQ(again.size(), frames.size());
  EXPECT_EQ(again.back(), frames.back());
  const NozzlePlace place = bestNozzlePlace(frames, 25, {8, 8, 8});
  EXPECT_EQ(place.frames, counted(frames, place.at, Vector3d::Constant(100)));
  EXPECT_LT(place.at.norm(), 1200.0); // within the arm's reach
}

} // namespace
} // namespace voluta::cells
