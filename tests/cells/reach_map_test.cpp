// The map against every pose tried one by one, without the shortcuts of the map, and against a
// reach that is known in closed form.
#include "cells/reach_map.h"
#include "collision/cell_collision.h"

#include "base/error.h"
#include "base/units.h"

#include <cstdlib>
#include <gtest/gtest.h>

namespace voluta::cells {
namespace {

using base::kPi;
using collision::Margins;

// From -width / 2 to width / 2 + more along x.
std::vector<Eigen::Vector2d> rectangle(double width, double depth, double more = 0.0) {
  return {{-width / 2, -depth / 2},
          {width / 2 + more, -depth / 2},
          {width / 2 + more, depth / 2},
          {-width / 2, depth / 2}};
}

class Reach : public ::testing::Test {
protected:
  void SetUp() override { setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1); }

  static process::Process process() { return process::loadProcess("fdm-1.0"); }
  static robot::Cell cell(const std::string& id, double width, double depth, double more = 0.0) {
    return robot::loadCell(id, process(), rectangle(width, depth, more));
  }
};

// Every turn, every branch, every place of the axes; no body is looked at before another.
bool reachedOneByOne(const robot::Cell& cell, const process::Process& process,
                     const ReachGrid& grid, const Eigen::Vector3d& tip, double tilt,
                     double azimuth) {
  const collision::CellCollision collision(cell, process);
  const Margins margins;
  bool reached = false;
  for (const robot::JointVector& axes : axisPlaces(cell, grid.axisPlaces))
    for (int n = 0; n < grid.turns; ++n) {
      const double angle = 2 * kPi * n / grid.turns;
      // Rz(azimuth) Ry(pi + tilt) Rz(turn), multiplied out.
      const double ca = std::cos(azimuth), sa = std::sin(azimuth), ct = std::cos(tilt),
                   st = std::sin(tilt), cn = std::cos(angle), sn = std::sin(angle);
      Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
      pose.linear() << -ca * ct * cn - sa * sn, ca * ct * sn - sa * cn, -ca * st, //
          -sa * ct * cn + ca * sn, sa * ct * sn + ca * cn, -sa * st,              //
          st * cn, -st * sn, -ct;
      pose.translation() = tip;
      robot::JointVector near = cell.home();
      near.tail(axes.size()) = axes;
      std::vector<robot::JointVector> solutions;
      cell.inverse(pose, near, solutions);
      for (const robot::JointVector& q : solutions) {
        std::vector<Eigen::Isometry3d> frames;
        cell.framePoses(q, frames);
        if (collision.clearance(frames, 1000.0) > margins.bodiesMm &&
            !collision.headTouchesPlatform(pose, margins.headMm))
          reached = true;
      }
    }
  return reached;
}

TEST_F(Reach, equalsEveryPoseTriedOneByOne) {
  struct Case {
    const char* cell;
    double width, depth, more, spacing;
    std::vector<double> heights, tiltsDeg;
    int azimuths, turns, axisPlaces;
  };
  // Plates at whose edges the reach ends.
  const Case cases[] = {
      {"ur5-fixed", 360, 360, 0, 90, {0.8, 120, 300}, {0, 40}, 3, 5, 1},
      {"ur5-moving", 200, 400, 500, 100, {0.8, 200}, {0, 25, 60}, 4, 4, 1},
      {"irb2400-moving", 300, 900, 900, 150, {0.8, 500}, {0, 60}, 4, 4, 1},
      {"irb1200-irbp", 400, 400, 0, 100, {60}, {0, 50}, 3, 3, 3},
      {"t3", 700, 700, 0, 70, {0.8, 60}, {0}, 1, 1, 1},
  };
  for (const Case& c : cases) {
    const robot::Cell cell = this->cell(c.cell, c.width, c.depth, c.more);
    ReachGrid grid;
    grid.spacingMm = c.spacing;
    grid.heightsMm = c.heights;
    for (const double tilt : c.tiltsDeg)
      grid.tiltsRad.push_back(base::degreesToRadians(tilt));
    grid.azimuths = c.azimuths;
    grid.turns = c.turns;
    grid.axisPlaces = c.axisPlaces;
    const ReachMap map = reachMap(cell, process(), grid, {}, {});
    std::size_t met = 0, asked = 0;
    for (std::size_t n = 0; n < map.points().size(); ++n)
      for (std::size_t h = 0; h < grid.heightsMm.size(); ++h)
        for (std::size_t d = 0; d < map.directions().size(); ++d) {
          const Direction& direction = map.directions()[d];
          const bool reached = reachedOneByOne(
              cell, process(), grid, {map.points()[n].x(), map.points()[n].y(), grid.heightsMm[h]},
              grid.tiltsRad[direction.tilt], 2 * kPi * direction.azimuth / grid.azimuths);
          EXPECT_EQ(map.reached(n, h, d), reached)
              << c.cell << " at " << map.points()[n].transpose() << ", " << grid.heightsMm[h]
              << ", direction " << d;
          met += reached;
          ++asked;
        }
    // Some of both, or nothing was compared.
    EXPECT_GT(met, asked / 10) << c.cell;
    EXPECT_LT(met, asked) << c.cell;
  }
}

TEST_F(Reach, isTheSameForAnyNumberOfThreads) {
  const robot::Cell cell = this->cell("ur5-moving", 200, 600, 600);
  ReachGrid grid;
  grid.spacingMm = 100;
  grid.heightsMm = {0.8, 150};
  grid.tiltsRad = {0, 0.8};
  grid.azimuths = 4;
  grid.turns = 6;
  std::optional<ReachMap> first;
  for (const int threads : {1, 2, 5}) {
    const ReachMap map =
        reachMap(cell, process(), grid, {}, base::RunContext(base::CancelToken(), threads));
    if (!first)
      first = map;
    for (std::size_t n = 0; n < map.points().size(); ++n)
      for (std::size_t h = 0; h < 2; ++h)
        for (std::size_t d = 0; d < map.directions().size(); ++d)
          ASSERT_EQ(map.reached(n, h, d), first->reached(n, h, d));
  }
}

// A SCARA's two links reach just the ring that its second joint leaves them, where its first gets.
TEST_F(Reach, ofAScaraIsARing) {
  const robot::Cell cell = this->cell("t3", 700, 700);
  std::vector<Eigen::Isometry3d> links;
  robot::JointVector q = robot::JointVector::Zero(cell.dof());
  cell.robot().kinematics->linkPoses(q, links);
  const auto flat = [](const Eigen::Vector3d& p) { return p.head<2>().norm(); };
  const double first = flat(links[2].translation() - links[1].translation()),
               both = flat(cell.robot().kinematics->flange(q).translation());
  const double second = both - first;
  const robot::JointLimits &j1 = cell.limits()[0], &j2 = cell.limits()[1];
  ReachGrid grid;
  grid.spacingMm = 25;
  grid.heightsMm = {40};
  grid.tiltsRad = {0, 0.5};
  const ReachMap map = reachMap(cell, process(), grid, {-1e3, -1e3, -1e3}, {}); // no body counts
  EXPECT_EQ(map.grid().tiltsRad.size(), 1u);                                    // it cannot tilt
  std::size_t inside = 0, outside = 0;
  for (std::size_t n = 0; n < map.points().size(); ++n) {
    const Eigen::Vector3d p =
        cell.base_T_fixed() * Eigen::Vector3d(map.points()[n].x(), map.points()[n].y(), 40);
    const double r = flat(p),
                 cosine = (r * r - first * first - second * second) / (2 * first * second);
    bool reached = false;
    for (const double sign : {-1.0, 1.0}) {
      if (std::abs(cosine) > 1.0)
        continue;
      const double elbow = sign * std::acos(cosine);
      double shoulder = std::atan2(p.y(), p.x()) -
                        std::atan2(second * std::sin(elbow), first + second * std::cos(elbow));
      for (const double whole : {-2 * kPi, 0.0, 2 * kPi})
        reached = reached || (elbow >= j2.min && elbow <= j2.max && shoulder + whole >= j1.min &&
                              shoulder + whole <= j1.max);
    }
    (reached ? inside : outside) += 1;
    EXPECT_EQ(map.reached(n, 0, 0), reached) << map.points()[n].transpose();
  }
  EXPECT_GT(inside, 50u);
  EXPECT_GT(outside, 50u);
}

TEST_F(Reach, pointsAreThoseOnThePlateAndSharesAreCounted) {
  ReachGrid grid;
  grid.spacingMm = 10;
  grid.heightsMm = {1, 50};
  grid.tiltsRad = {0, 0.5};
  grid.azimuths = 4;
  ReachMap map(grid, rectangle(40, 20));
  ASSERT_EQ(map.points().size(), 15u);
  EXPECT_EQ(map.points().front(), Eigen::Vector2d(-20, -10));
  EXPECT_EQ(map.directions().size(), 5u);
  for (std::size_t d = 0; d < 5; ++d) {
    const Eigen::Vector3d build = map.directions()[d].build;
    EXPECT_NEAR(build.z(), d == 0 ? 1.0 : std::cos(0.5), 1e-12);
  }
  map.setReached(3, 0, 0, true);
  EXPECT_EQ(map.share(3, 1, 0), 1.0);
  EXPECT_EQ(map.share(3, 0.2, 0), 1.0); // the lowest always counts
  EXPECT_EQ(map.share(3, 50, 0), 0.5);
  EXPECT_EQ(map.share(3, 50, 0.5), 0.1);
  EXPECT_EQ(map.shareOfTilt(0), 1.0 / 30);
  EXPECT_EQ(map.shareOfTilt(1), 0.0);
}

TEST_F(Reach, aRodHasNoMap) {
  platform::PlatformSolid rod;
  rod.rod = platform::straightRod(5, 200);
  const process::Process process = process::loadProcess("fdm-0.35");
  const robot::Cell lathe = robot::loadCell("lathe", process, rod);
  EXPECT_THROW(usualGrid(lathe, process, 100), base::Error);
}

} // namespace
} // namespace voluta::cells
