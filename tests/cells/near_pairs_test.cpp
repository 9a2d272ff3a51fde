// Distances of bodies and pairs near one another, by share of poses, against closed forms.
#include "cells/near_pairs.h"

#include <gtest/gtest.h>

namespace voluta::cells {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using robot::Body;
using robot::BodyRole;

Body ball(int frame, double radius) {
  return {
      "ball", BodyRole::Link, frame, {robot::Capsule{Vector3d::Zero(), Vector3d::Zero(), radius}}};
}
Frames apart(double mm) {
  Isometry3d away = Isometry3d::Identity();
  away.translation() = Vector3d(mm, 0, 0);
  return {Isometry3d::Identity(), away};
}

TEST(NearPairs, DistancesAreThoseOfTheSolids) {
  EXPECT_NEAR(distanceOf(ball(0, 10), ball(1, 20), apart(100), 1e9), 70.0, 1e-3);
  EXPECT_NEAR(distanceOf(ball(0, 10), ball(1, 20), apart(100), 50.0), 50.0, 1e-9); // the cap
  const Body box{
      "box", BodyRole::Obstacle, 1, {robot::Box{Isometry3d::Identity(), Vector3d(1000, 1000, 25)}}};
  Frames above = apart(0);
  above[1].translation() = Vector3d(300, -200, -80);
  EXPECT_NEAR(distanceOf(ball(0, 10), box, above, 1e9), 45.0, 1e-3);
  const Body rod{
      "rod", BodyRole::Link, 0, {robot::Frustum{Vector3d(0, 0, 0), Vector3d(0, 0, 400), 15, 15}}};
  // Over a large plate, along it: the rod counts as the thin one.
  above[1].translation() = Vector3d(0, 0, 460);
  EXPECT_NEAR(distanceOf(rod, box, above, 1e9), 35.0, 0.5);
}

TEST(NearPairs, SharesCountThePoses) {
  const std::vector<Frames> poses{apart(20), apart(32), apart(34), apart(90)};
  EXPECT_DOUBLE_EQ(nearShare(ball(0, 10), ball(1, 20), poses, 3.0), 0.5);
  EXPECT_DOUBLE_EQ(nearShare(ball(0, 10), ball(1, 20), {}, 3.0), 0.0);
}

} // namespace
} // namespace voluta::cells
