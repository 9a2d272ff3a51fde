// Spiral vases: one bead that rises. The solid is the wall between two helices, checked at random
// points by its closed form; the first turn is as high as the gap that it fills.
#include "base/run_context.h"
#include "geometry/measures.h"
#include "geometry/mesh_query.h"
#include "geometry/repair/diagnosis.h"
#include "process/bead_model.h"
#include "sliced/gcode_machine.h"
#include "sliced/plan_measures.h"
#include "sliced/rising_heights.h"
#include "sliced/sliced_reader.h"
#include "sliced/spiral_writer.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

using namespace voluta;
using Eigen::Vector3d;
using test::Manner, test::Spiral;

namespace {

const base::RunContext kCtx;

struct Case {
  const char* name;
  Spiral spiral;
};
const Case kCases[] = {{"cylinder", test::cylinderSpiral()},
                       {"square", test::squareSpiral()},
                       {"twisted", test::twistedSpiral()}};

sliced::ReadSliced readOf(Manner manner, const Spiral& spiral) {
  return sliced::readSliced(test::spiralBy(manner, spiral).text, "vase.gcode", kCtx);
}

TEST(SpiralVase, LengthVolumeAndSolidAreTheFiles) {
  for (const Case& c : kCases)
    for (const Manner manner : test::kManners) {
      const test::Written written = test::spiralBy(manner, c.spiral);
      const sliced::ReadSliced read = sliced::readSliced(written.text, "vase.gcode", kCtx);
      const std::string name = std::string(c.name) + ", " + std::string(nameOf(manner));
      EXPECT_NEAR(test::lengthOf(read.plan), written.lengthMm, 1e-6 * written.lengthMm) << name;
      EXPECT_NEAR(read.volumeMm3, written.volumeMm3, 1e-5 * written.volumeMm3) << name;
      EXPECT_TRUE(geometry::isWatertight(read.solid)) << name;
      EXPECT_NEAR(geometry::volume(read.solid), written.volumeMm3, 0.03 * written.volumeMm3)
          << name;
      EXPECT_EQ(read.plan.paths.back().kind, plan::PathKind::Wall) << name;
    }
}

// How far a point is within the wall of the cylinder, or outside of it if negative [mm].
double depthInWall(const Spiral& spiral, const Vector3d& p, double topMm) {
  const double half = 0.5 * process::hatchOf(spiral.widthMm, spiral.heightMm);
  const double radius = spiral.outline(0.0, 0.0).x();
  const double floor = spiral.bottomLayers * spiral.heightMm;
  const double offset = half - std::abs(std::hypot(p.x(), p.y()) - radius);
  return std::min({offset, p.z() - floor, topMm - p.z()});
}

TEST(SpiralVase, TheSolidIsTheWallBetweenTwoHelices) {
  const Spiral spiral = test::cylinderSpiral();
  const double floor = spiral.bottomLayers * spiral.heightMm;
  const double radius = spiral.outline(0.0, 0.0).x();
  for (const Manner manner : test::kManners) {
    const geometry::MeshQuery query(readOf(manner, spiral).solid);
    std::mt19937 random(11);
    std::uniform_real_distribution<double> share(0.05, 0.95), offset(-1.0, 1.0),
        height(floor + 1.5 * spiral.heightMm, floor + (spiral.turns + 0.5) * spiral.heightMm);
    for (int k = 0; k < 4000; ++k) {
      const double s = share(random), angle = 2.0 * base::kPi * s, r = radius + offset(random);
      const Vector3d p(r * std::cos(angle), r * std::sin(angle), height(random));
      const double turns = manner == Manner::PrusaSlicer ? spiral.turns : spiral.turns - 1 + s;
      const double depth = depthInWall(spiral, p, floor + turns * spiral.heightMm);
      constexpr double kNear = 0.1;
      if (std::abs(depth) > kNear) {
        EXPECT_EQ(query.inside(p), depth > 0.0) << nameOf(manner) << " " << p.transpose();
      }
    }
  }
}

TEST(SpiralVase, TheFirstTurnIsAsHighAsItsGap) {
  for (const Case& c : kCases) {
    const plan::ToolPlan plan = readOf(Manner::PrusaSlicer, c.spiral).plan;
    const plan::ToolPath& wall = plan.paths.back();
    const double floor = c.spiral.bottomLayers * c.spiral.heightMm;
    const double end = floor + c.spiral.turns * c.spiral.heightMm;
    for (std::size_t i = wall.first; i < wall.first + wall.count; ++i) {
      const double rise = plan.position[i].z() - floor;
      if (rise < 0.2 * c.spiral.heightMm || plan.position[i].z() > end - 0.001)
        continue;
      const double height = std::min(rise, c.spiral.heightMm);
      const double hatch = process::hatchOf(c.spiral.widthMm, c.spiral.heightMm);
      // Within a segment of its ends
      const double slack = 0.02 + c.spiral.heightMm / c.spiral.facets;
      EXPECT_NEAR(plan.heightMm[i], height, slack) << c.name << rise;
      EXPECT_NEAR(plan.widthMm[i], process::widthOfHatch(hatch, height), 0.1 * c.spiral.widthMm)
          << c.name << rise;
    }
  }
}

TEST(SpiralVase, HeightsNeedNoComments) {
  std::string text = test::spiralBy(Manner::Slic3r, test::cylinderSpiral()).text;
  const std::string stated = "\n; layer_height = 0.6";
  text.erase(text.find(stated), stated.size());
  const sliced::ReadSliced read = sliced::readSliced(text, "vase.gcode", kCtx);
  const plan::ToolPath& wall = read.plan.paths.back();
  EXPECT_NEAR(read.plan.heightMm[wall.first + wall.count / 2], 0.6, 0.01);
  EXPECT_NEAR(read.plan.widthMm[wall.first + wall.count / 2], 1.2, 0.02);
}

} // namespace
