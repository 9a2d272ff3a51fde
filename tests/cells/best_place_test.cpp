#include "cells/best_place.h"

#include <gtest/gtest.h>
#include <random>

namespace voluta::cells {
namespace {

using Eigen::Vector2d;

std::vector<Vector2d> square(double half) {
  return {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
}

ReachGrid grid() {
  ReachGrid grid;
  grid.spacingMm = 10;
  grid.heightsMm = {1, 30, 60};
  grid.tiltsRad = {0, 0.5, 1.0};
  grid.azimuths = 2;
  return grid;
}

// Only a disc about (30, -20) is reached: a part that just fits it goes there.
TEST(BestPlace, IsInTheMiddleOfWhatIsReached) {
  ReachMap map(grid(), square(80));
  for (std::size_t n = 0; n < map.points().size(); ++n)
    if ((map.points()[n] - Vector2d(30, -20)).norm() <= 40.5)
      for (std::size_t h = 0; h < 3; ++h)
        for (std::size_t d = 0; d < map.directions().size(); ++d)
          map.setReached(n, h, d, true);
  const Standing part{40.5, 60, 1.0};
  const Place best = bestPlace(map, part);
  EXPECT_EQ(best.at, Vector2d(30, -20));
  EXPECT_EQ(best.share, 1.0);
  EXPECT_TRUE(best.good());
  const Place middle = placeAt(map, part, {0, 0});
  EXPECT_TRUE(middle.onPlate);
  EXPECT_LT(middle.uprightShare, 1.0);
  EXPECT_FALSE(middle.good());
  // A small one stays as near to the middle as it can.
  EXPECT_LT(bestPlace(map, {10, 60, 1.0}).at.norm(), 15.0);
}

TEST(BestPlace, WhatIsTooWideStandsBesideThePlateWherever) {
  ReachMap map(grid(), square(80));
  EXPECT_FALSE(bestPlace(map, {81, 10, 0}).onPlate);
  EXPECT_TRUE(bestPlace(map, {80, 10, 0}).onPlate);
  EXPECT_FALSE(placeAt(map, {20, 10, 0}, {65, 0}).onPlate);
  EXPECT_TRUE(placeAt(map, {20, 10, 0}, {60, 0}).onPlate);
}

// Counted pose by pose for every place, on random maps.
TEST(BestPlace, EqualsCountingEveryPose) {
  std::mt19937_64 random(5);
  for (int round = 0; round < 20; ++round) {
    ReachMap map(grid(), square(45));
    std::bernoulli_distribution is(0.7);
    for (std::size_t n = 0; n < map.points().size(); ++n)
      for (std::size_t h = 0; h < 3; ++h)
        for (std::size_t d = 0; d < map.directions().size(); ++d)
          map.setReached(n, h, d, is(random));
    const Standing part{15, 40, 0.6};
    double best = -1.0;
    for (const Vector2d& at : map.points()) {
      if (at.cwiseAbs().maxCoeff() + part.radiusMm > 45)
        continue;
      int upright = 0, met = 0, asked = 0, askedUpright = 0;
      for (std::size_t n = 0; n < map.points().size(); ++n)
        for (std::size_t h = 0; h < 2; ++h)
          for (std::size_t d = 0; d < 3; ++d) // upright, and half a radian to two sides
            if ((map.points()[n] - at).norm() <= part.radiusMm) {
              met += map.reached(n, h, d);
              ++asked;
              if (d == 0) {
                upright += map.reached(n, h, d);
                ++askedUpright;
              }
            }
      const Place place = placeAt(map, part, at);
      EXPECT_NEAR(place.share, static_cast<double>(met) / asked, 1e-12);
      EXPECT_NEAR(place.uprightShare, static_cast<double>(upright) / askedUpright, 1e-12);
      best = std::max(best, place.uprightShare + 1e-6 * place.share);
    }
    const Place found = bestPlace(map, part);
    EXPECT_NEAR(found.uprightShare + 1e-6 * found.share, best, 1e-9);
  }
}

} // namespace
} // namespace voluta::cells
