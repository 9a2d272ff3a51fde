// Paths on other grounds: lengths, areas and volumes by their closed forms.
#include "base/error.h"
#include "base/run_context.h"
#include "base/units.h"
#include "geometry/measures.h"
#include "geometry/repair/diagnosis.h"
#include "process/bead_model.h"
#include "sliced/ground_body.h"
#include "sliced/path_shape.h"
#include "sliced/plan_measures.h"
#include "sliced/sliced_reader.h"
#include "sliced/slicer_writer.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

using namespace voluta;
using Eigen::Vector2d, Eigen::Vector3d;
using sliced::CurvedGround;
using sliced::GroundShape;

namespace {

const base::RunContext kCtx;

TEST(CurvedGround, HeightsAreDistancesFromTheGround) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> at(-40.0, 40.0), height(0.0, 20.0), radius(60.0, 200.0);
  for (int round = 0; round < 300; ++round) {
    CurvedGround ground;
    ground.shape = round % 2 ? GroundShape::Cylinder : GroundShape::Sphere;
    ground.radiusMm = (round % 4 < 2 ? 1.0 : -1.0) * radius(random);
    ground.keepsAngles = round % 3 == 0;
    const Vector3d level(at(random), at(random), height(random));
    const CurvedGround::Mapped mapped = ground.map(level);
    Vector3d fromCentre = mapped.position + Vector3d(0.0, 0.0, ground.radiusMm);
    if (ground.shape == GroundShape::Cylinder)
      fromCentre.x() = 0.0;
    EXPECT_NEAR(fromCentre.norm(), std::abs(ground.radiusMm + level.z()), 1e-9);
    // The nozzle is normal to the ground.
    const Vector3d up = mapped.rotation * Vector3d::UnitZ();
    EXPECT_NEAR(up.dot(fromCentre.normalized()), ground.radiusMm > 0.0 ? 1.0 : -1.0, 1e-9);
    // Small steps grow as stated.
    constexpr double kStep = 1e-4;
    const Vector3d axis(mapped.axis.x(), mapped.axis.y(), 0.0), beside(-axis.y(), axis.x(), 0.0);
    EXPECT_NEAR((ground.map(level + kStep * axis).position - mapped.position).norm() / kStep,
                mapped.along, 1e-3);
    EXPECT_NEAR((ground.map(level + kStep * beside).position - mapped.position).norm() / kStep,
                mapped.across, 1e-3);
  }
}

TEST(CurvedGround, ACylinderKeepsLengthsOfLayersAndSpheresDoNot) {
  CurvedGround cylinder{GroundShape::Cylinder, 50.0, false};
  const auto mapped = cylinder.map({3.0, 20.0, 8.0});
  EXPECT_DOUBLE_EQ(hatchFactor(mapped, Vector2d(1.0, 0.3)), 1.0);
  cylinder.keepsAngles = true;
  const auto grown = cylinder.map({3.0, 20.0, 10.0});
  EXPECT_NEAR(hatchFactor(grown, Vector2d::UnitX()), 60.0 / 50.0, 1e-12); // Rows move apart
  EXPECT_NEAR(hatchFactor(grown, Vector2d::UnitY()), 1.0, 1e-12);
}

TEST(GroundBody, HasTheVolumeOfItsShape) {
  const Eigen::AlignedBox3d box(Vector3d(-20, -15, 0), Vector3d(20, 15, 10));
  const geometry::TriangleMesh slab = sliced::groundBody({GroundShape::Plane, 100.0, false}, box);
  EXPECT_TRUE(geometry::isWatertight(slab));
  EXPECT_NEAR(geometry::volume(slab), 60.0 * 50.0 * 5.0, 1e-6);
  for (const double radius : {40.0, -40.0}) {
    const geometry::TriangleMesh body =
        sliced::groundBody({GroundShape::Cylinder, radius, false}, box);
    EXPECT_TRUE(geometry::isWatertight(body));
    // Below the chord of an arc of 50 mm: the segment, and a block.
    const double angle = 50.0 / 40.0, chord = 2.0 * 40.0 * std::sin(0.5 * angle);
    const double segment = 0.5 * 40.0 * 40.0 * (angle - std::sin(angle));
    const double rise = 40.0 * (1.0 - std::cos(0.5 * angle));
    const double section = radius > 0.0 ? segment + 5.0 * chord : (5.0 + rise) * chord - segment;
    EXPECT_NEAR(geometry::volume(body), 60.0 * section, 0.002 * 60.0 * section) << radius;
    const geometry::TriangleMesh round =
        sliced::groundBody({GroundShape::Sphere, radius, false}, box);
    EXPECT_TRUE(geometry::isWatertight(round));
    EXPECT_GT(geometry::volume(round), 0.0);
  }
}

// Straight rows in three layers.
sliced::ReadSliced rows() {
  std::string text = "; filament_diameter = 1.75\n; layer_height = 0.5\nG28\nM83\n";
  for (int layer = 1; layer <= 3; ++layer)
    for (int row = 0; row < 12; ++row)
      text += "G1 X0 Y" + std::to_string(row) + " Z" + std::to_string(0.5 * layer) +
              " F600\nG1 X30 E6\n";
  return sliced::readSliced(text, "rows.gcode", kCtx);
}

TEST(PathShape, ACylinderKeepsLengthVolumeAndSections) {
  const sliced::ReadSliced read = rows();
  sliced::PathShape shape;
  shape.ground = {GroundShape::Cylinder, 40.0, false};
  const sliced::ShapedPaths bent = sliced::shaped(read.plan, read.solid, shape, kCtx);
  EXPECT_NEAR(test::lengthOf(bent.plan), test::lengthOf(read.plan),
              1e-3 * test::lengthOf(read.plan));
  EXPECT_NEAR(test::volumeOf(bent.plan), test::volumeOf(read.plan),
              1e-3 * test::volumeOf(read.plan));
  EXPECT_NEAR(geometry::volume(bent.solid), geometry::volume(read.solid),
              2e-3 * geometry::volume(read.solid));
  ASSERT_TRUE(bent.ground);
  EXPECT_EQ(bent.plan.paths.size(), read.plan.paths.size());
}

TEST(PathShape, KeptAnglesGrowWithTheRadius) {
  const sliced::ReadSliced read = rows();
  sliced::PathShape shape;
  shape.ground = {GroundShape::Cylinder, 40.0, true};
  const sliced::ShapedPaths bent = sliced::shaped(read.plan, read.solid, shape, kCtx);
  // Rows are along the axis: the lengths stay, areas grow by (r + h) / r.
  EXPECT_NEAR(test::lengthOf(bent.plan), test::lengthOf(read.plan),
              1e-9 * test::lengthOf(read.plan));
  const double mean = (40.5 + 41.0 + 41.5) / 3.0 / 40.0;
  EXPECT_NEAR(test::volumeOf(bent.plan), mean * test::volumeOf(read.plan),
              1e-4 * test::volumeOf(read.plan));
}

TEST(PathShape, LayersTurnAndTurnBack) {
  const sliced::ReadSliced read = rows();
  sliced::PathShape shape;
  shape.rotationPerLayerRad = base::degreesToRadians(10.0);
  shape.reverseMm = 1.0;
  const sliced::ShapedPaths turned = sliced::shaped(read.plan, read.solid, shape, kCtx);
  std::vector<double> angles;
  int layer = -1;
  for (const plan::ToolPath& path : turned.plan.paths)
    if (path.layer != layer) {
      layer = path.layer;
      const Vector3d step = turned.plan.position[path.first + 1] - turned.plan.position[path.first];
      angles.push_back(base::radiansToDegrees(std::atan2(step.y(), step.x())));
    }
  ASSERT_EQ(angles.size(), 3u);
  EXPECT_NEAR(angles[0], 0.0, 1e-9);
  EXPECT_NEAR(angles[1], 10.0, 1e-9); // Up to 1 mm
  EXPECT_NEAR(angles[2], 0.0, 1e-9);
  EXPECT_NEAR(test::volumeOf(turned.plan), test::volumeOf(read.plan),
              1e-9 * test::volumeOf(read.plan));
}

TEST(PathShape, AmountsAndFramesAreTaken) {
  const sliced::ReadSliced read = rows();
  sliced::PathShape shape;
  shape.amountFactor = 1.5;
  shape.frame = Eigen::Translation3d(1.0, 2.0, 3.0) *
                Eigen::AngleAxisd(base::degreesToRadians(90.0), Vector3d::UnitX());
  const sliced::ShapedPaths made = sliced::shaped(read.plan, read.solid, shape, kCtx);
  EXPECT_NEAR(test::volumeOf(made.plan), 1.5 * test::volumeOf(read.plan),
              1e-5 * test::volumeOf(read.plan));
  EXPECT_LT((made.plan.direction[0] - Vector3d(0.0, -1.0, 0.0)).norm(), 1e-12);
  EXPECT_FALSE(made.ground);
  EXPECT_TRUE(sliced::PathShape().changesNothing());
}

TEST(PathShape, UnsuitableGroundIsRefusedWithARemedy) {
  const sliced::ReadSliced read = rows();
  sliced::PathShape shape;
  shape.ground = {GroundShape::Cylinder, 3.0, false};
  const auto refusal = [&] {
    try {
      static_cast<void>(sliced::shaped(read.plan, read.solid, shape, kCtx));
    } catch (const base::Error& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_NE(refusal().find("round the ground"), std::string::npos) << refusal();
  shape.ground.radiusMm = -3.0;
  EXPECT_NE(refusal().find("pathsRadius"), std::string::npos) << refusal();
}

} // namespace
