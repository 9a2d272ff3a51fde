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

// Only a disc about (30, -20) is reached: a part that just fits is placed there.
TEST(BestPlace, IsAtTheCentreOfTheReachedDisc) {
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

TEST(BestPlace, PartWiderThanThePlateIsNeverOnIt) {
  ReachMap map(grid(), square(80));
  EXPECT_FALSE(bestPlace(map, {81, 10, 0}).onPlate);
  EXPECT_TRUE(bestPlace(map, {80, 10, 0}).onPlate);
  EXPECT_FALSE(placeAt(map, {20, 10, 0}, {65, 0}).onPlate);
  EXPECT_TRUE(placeAt(map, {20, 10, 0}, {60, 0}).onPlate);
}

// A pose more far out is no reason to move there: both places are shown with the same percentage.
TEST(BestPlace, IsNearTheMiddleAmongPlacesThatAreAsGood) {
  ReachGrid fine = grid();
  fine.azimuths = 8;
  ReachMap map(fine, square(80));
  for (std::size_t n = 0; n < map.points().size(); ++n)
    for (std::size_t h = 0; h < 3; ++h)
      for (std::size_t d = 0; d < map.directions().size(); ++d)
        map.setReached(n, h, d, d == 0 || map.points()[n] != Vector2d(0, 0) || h != 1 || d != 3);
  const Standing part{30, 60, 1.0};
  const Place middle = placeAt(map, part, {0, 0});
  EXPECT_LT(middle.share, 1.0);
  EXPECT_GT(middle.share, 1.0 - kSameShare);
  EXPECT_EQ(bestPlace(map, part).at, Vector2d(0, 0));
  EXPECT_FALSE(isBetter(placeAt(map, part, {50, 50}), middle));
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
    double best = -1.0, bestUpright = -1.0;
    std::vector<Place> all;
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
      bestUpright = std::max(bestUpright, place.uprightShare);
      all.push_back(place);
    }
    const double minimum = bestUpright == 1.0 ? 1.0 : bestUpright - kSameShare;
    std::erase_if(all, [&](const Place& place) { return place.uprightShare < minimum; });
    for (const Place& place : all)
      best = std::max(best, place.share);
    const Place found = bestPlace(map, part);
    EXPECT_GE(found.uprightShare, minimum);
    EXPECT_GE(found.share, best - kSameShare);
    for (const Place& place : all) {
      EXPECT_FALSE(isBetter(place, found));
      if (place.share >= best - kSameShare) {
        EXPECT_LE(found.at.norm(), place.at.norm() + 1e-9) << "as good, and nearer to the middle";
      }
    }
  }
}

} // namespace
} // namespace voluta::cells
