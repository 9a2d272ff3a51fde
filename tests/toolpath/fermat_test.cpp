#include "base/run_context.h"
#include "base/units.h"
#include "helpers/all_seeds.h"
#include "helpers/rod_level.h"
#include "layers/patches.h"
#include "process/bead_model.h"
#include "toolpath/coverage/cover_patch.h"
#include "toolpath/painter.h"
#include "toolpath/patch_shapes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <string>
#include <vector>

namespace {
using namespace voluta;
using Eigen::Vector2d;
using Eigen::Vector3d;
using plan::PathKind;

using base::kPi;

toolpath::PatchCover fermat(const layers::Patch& patch, int walls = 2) {
  toolpath::ToolpathOptions o;
  o.infill = "fermat";
  o.walls = walls;
  return toolpath::coverPatch(patch, process::Process{}, o, base::RunContext{});
}

std::vector<const toolpath::Bead*> infillOf(const toolpath::PatchCover& c) {
  std::vector<const toolpath::Bead*> beads;
  for (const toolpath::Bead& b : c.beads)
    if (b.kind == PathKind::Infill)
      beads.push_back(&b);
  return beads;
}
auto gapBeads(const toolpath::PatchCover& c) {
  return std::ranges::count(c.beads, PathKind::GapFill, &toolpath::Bead::kind);
}

// An outline around `centre` whose radius varies smoothly by about `rough`.
test::Loop blob(std::mt19937& random, double radius, double rough, bool hole = false,
                Vector2d centre = {0, 0}) {
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  std::vector<Vector2d> wave(5);
  for (Vector2d& w : wave)
    w = Vector2d(any(random), any(random));
  test::Loop loop = test::circle(radius, hole);
  for (Vector2d& p : loop) {
    const double angle = std::atan2(p.y(), p.x());
    double r = 1.0;
    for (std::size_t k = 0; k < wave.size(); ++k) {
      const double turns = static_cast<double>(k + 1);
      r += rough / (turns + 0.5) *
           wave[k].dot(Vector2d(std::cos(turns * angle), std::sin(turns * angle)));
    }
    p = centre + r * p;
  }
  return loop;
}

double distanceTo(const std::vector<test::Loop>& loops, const Vector2d& p) {
  double minimum = 1e9;
  for (const test::Loop& l : loops)
    for (std::size_t i = 0; i < l.size(); ++i) {
      const Vector2d &a = l[i], ab = l[(i + 1) % l.size()] - a;
      const double t = std::clamp(ab.dot(p - a) / ab.squaredNorm(), 0.0, 1.0);
      minimum = std::min(minimum, (a + t * ab - p).norm());
    }
  return minimum;
}

bool cross(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d) {
  const auto side = [](const Vector2d& o, const Vector2d& p, const Vector2d& q) {
    return (p.x() - o.x()) * (q.y() - o.y()) - (p.y() - o.y()) * (q.x() - o.x());
  };
  return (side(a, b, c) > 0) != (side(a, b, d) > 0) && (side(c, d, a) > 0) != (side(c, d, b) > 0);
}

// Number of pairs of segments of a closed bead on a plane that cross.
int selfCrossings(const toolpath::Bead& bead) {
  std::vector<Vector2d> p;
  for (const toolpath::BeadPoint& q : bead.points)
    p.push_back(q.middle.head<2>());
  int count = 0;
  for (std::size_t i = 0; i + 1 < p.size(); ++i)
    for (std::size_t k = i + 2; k + 1 < p.size(); ++k)
      if ((p[i] - p[k]).squaredNorm() < 9.0 && !(i == 0 && k + 2 == p.size()))
        count += cross(p[i], p[i + 1], p[k], p[k + 1]);
  return count;
}

struct Shape {
  const char* name;
  layers::Patch patch;
};

std::vector<Shape> planeShapes() {
  return {
      {"square", test::patchOver({test::rectangle(30, 30)})},
      {"bar", test::patchOver({test::rectangle(50, 14)})},
      {"disc", test::patchOver({test::circle(15)})},
      {"L", test::patchOver({test::ell(40, 15)})},
      {"star", test::patchOver({test::star(5, 30, 14)})},
      {"ring", test::patchOver({test::circle(20), test::circle(8, true)})},
      {"narrow ring", test::patchOver({test::circle(15), test::circle(9, true)})},
      {"three holes",
       test::patchOver({test::rectangle(46, 36), test::circle(6, true, {11, 3}),
                        test::circle(4, true, {-11, 6}), test::circle(3, true, {-6, -9})})},
  };
}
std::vector<Shape> curvedShapes() {
  return {
      {"cap", test::patchOver({test::circle(20 * kPi / 3)}, 0.8, test::onSphere(20))},
      {"cap with a hole",
       test::patchOver({test::circle(22), test::circle(6, true, {5, 3})}, 0.8, test::onSphere(30))},
      {"saddle", test::patchOver({test::circle(15)}, 0.8, test::onSaddle(15))},
      {"cylinder", test::patchOver({test::rectangle(40, 20)}, 0.8, test::onCylinder(15))},
  };
}

void expectOnePathEach(const std::vector<Shape>& shapes) {
  for (const Shape& s : shapes) {
    SCOPED_TRACE(s.name);
    const toolpath::PatchCover c = fermat(s.patch);
    const auto infill = infillOf(c);
    ASSERT_EQ(infill.size(), 1U);
    EXPECT_TRUE(infill.front()->closed);
    EXPECT_LE(gapBeads(c), 1);
    EXPECT_GE(c.coveredMm2 / c.areaMm2, 0.99);
    EXPECT_LE(c.overlapMm2 / c.areaMm2, 0.02);
    EXPECT_NEAR(c.beadVolumeMm3 / c.volumeMm3, 1.0, 0.001);
    const test::Painted p = test::paint(s.patch, c.beads);
    EXPECT_GE(p.coveredMm2 / p.areaMm2, 0.965);
  }
}

TEST(FermatInfill, IsOneClosedPathARegion) {
  expectOnePathEach(planeShapes());
}

TEST(FermatInfill, IsOneClosedPathARegionOfACurvedLayer) {
  expectOnePathEach(curvedShapes());
}

// The loops at both ends of a sleeve are a chain from one end to the other.
TEST(FermatInfill, WindsAroundARod) {
  const layers::LevelSurface level = test::rodLevel(3.625, -15.0, 15.0, 0.3, 0.25);
  layers::Patch sleeve = layers::makePatches(level, {0.7}).patches.at(0);
  sleeve.innerRim.clear(); // Its boundary is the part's
  for (const int walls : {0, 2}) {
    const toolpath::PatchCover c = fermat(sleeve, walls);
    ASSERT_EQ(infillOf(c).size(), 1U);
    EXPECT_EQ(gapBeads(c), 0);
    EXPECT_GE(c.coveredMm2 / c.areaMm2, 0.99);
    EXPECT_LE(c.overlapMm2 / c.areaMm2, 0.03);
    double turns = 0.0, maximum = 0.0;
    const auto& points = infillOf(c).front()->points;
    for (std::size_t i = 1; i < points.size(); ++i) {
      const auto angle = [&](std::size_t k) {
        return std::atan2(points[k].middle.z(), points[k].middle.y());
      };
      turns += std::remainder(angle(i) - angle(i - 1), 2 * kPi) / (2 * kPi);
      maximum = std::max(maximum, std::abs(turns));
    }
    EXPECT_NEAR(turns, 0.0, 1e-6);
    EXPECT_GT(maximum, walls == 0 ? 11.0 : 10.0); // Half of the turns run the other way
  }
}

// Half of the lines at half the density, twice as far apart.
// Without walls the spiral is the only bead.
TEST(FermatInfill, AFlatRingWithoutWallsHasOneStart) {
  const auto ring = test::patchOver({test::circle(25), test::circle(15, true)});
  const toolpath::PatchCover c = fermat(ring, 0);
  ASSERT_EQ(c.beads.size(), 1U);
  EXPECT_GE(c.coveredMm2 / c.areaMm2, 0.99);
  // The length of beads a hatch apart.
  const process::Process process;
  const double hatch = process::hatchOf(process.beadWidthMm, 0.8);
  double length = 0.0;
  const auto& points = c.beads.front().points;
  for (std::size_t i = 1; i < points.size(); ++i)
    length += (points[i].middle - points[i - 1].middle).norm();
  EXPECT_NEAR(length * hatch / c.areaMm2, 1.0, 0.06);
}

TEST(FermatInfill, ApartRegionsGetAPathEach) {
  test::Loop left = test::circle(9), right = test::circle(12);
  for (Vector2d& p : left)
    p.x() -= 15;
  for (Vector2d& p : right)
    p.x() += 15;
  const toolpath::PatchCover c = fermat(test::patchOver({left, right}));
  EXPECT_EQ(infillOf(c).size(), 2U);
  EXPECT_GE(c.coveredMm2 / c.areaMm2, 0.99);
}

TEST(FermatInfill, FillsRandomOutlinesByOnePathThatNowhereCrossesItself) {
  std::mt19937 random(2016);
  const double walls = 2 * process::hatchOf(1.2, 0.8);
  for (int i = 0; i < test::ofSeeds(25, 100); ++i) {
    SCOPED_TRACE(i);
    std::vector<test::Loop> loops{blob(random, 9.0 + i % 8, 0.35)};
    // A ring of at least five beads; where one is narrower than two, it has room for walls only.
    if (i % 3 == 1 && i % 8 > 2)
      loops.push_back(blob(random, 2.2, 0.2, true, {0.5, -0.5}));
    const toolpath::PatchCover c = fermat(test::patchOver(loops));
    const auto infill = infillOf(c);
    ASSERT_EQ(infill.size(), 1U);
    const toolpath::Bead& path = *infill.front();
    EXPECT_TRUE(path.closed);
    EXPECT_EQ(selfCrossings(path), 0);
    for (const toolpath::BeadPoint& p : path.points)
      EXPECT_GE(distanceTo(loops, p.middle.head<2>()), walls);
    EXPECT_GE(c.coveredMm2 / c.areaMm2, 0.99);
    EXPECT_LE(c.overlapMm2 / c.areaMm2, 0.03);
  }
}

} // namespace
