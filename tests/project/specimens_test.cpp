// The samples for tapes: closed, outward, and of the published sizes.
#include "project/accuracy_plate.h"
#include "project/rib_samples.h"
#include "project/specimens.h"

#include "base/units.h"
#include "geometry/boundary.h"
#include "geometry/measures.h"
#include "project/loaded_part.h"

#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>

namespace voluta::project {
namespace {

Eigen::Vector3d sizesOf(const geometry::TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& v : mesh.vertices)
    box.extend(v);
  return box.sizes();
}

TEST(Specimens, AreClosedAndOfTheirVolume) {
  // The fillets of the dumb-bell: between y = 6.5 and 9.5, of radius 76.
  const double run = std::sqrt(76.0 * 76 - 73.0 * 73);
  const double underArc =
      6.5 * run + 76.0 * run - 0.5 * (run * 73.0 + 76.0 * 76.0 * std::asin(run / 76.0));
  const double dumbbell =
      3.0 * 2.0 * (57.0 * 6.5 + 2.0 * underArc + (165.0 - 57.0 - 2.0 * run) * 9.5);
  const double arc = base::degreesToRadians(75.0);
  const struct {
    geometry::TriangleMesh mesh;
    double mm3;
  } cases[] = {{barSpecimen(), 250.0 * 10 * 5},
               {dumbbellSpecimen(), dumbbell},
               {plateSpecimen(), 3.0 * (120.0 * 60 - base::kPi * 100)},
               {curvedSpecimen(), 10.0 * 0.5 * arc * (64.2 * 64.2 - 60.0 * 60.0)}};
  for (const auto& c : cases) {
    EXPECT_TRUE(geometry::boundaryLoops(c.mesh).empty());
    EXPECT_NEAR(geometry::volume(c.mesh), c.mm3, 1e-3 * c.mm3);
  }
  EXPECT_NEAR((sizesOf(dumbbellSpecimen()) - Eigen::Vector3d(165, 19, 3)).norm(), 0.0, 1e-9);
  EXPECT_GT(geometry::volume(mouldOfCurvedSpecimen()), 0.0);
  EXPECT_TRUE(geometry::boundaryLoops(mouldOfCurvedSpecimen()).empty());
}

// Table 5.1: base 40 mm, ten layers of 0.2 mm, the first 0.25, ten beads of 0.657 mm.
TEST(Specimens, RibsAreOnTheirBodies) {
  const double height = 2.05, width = 6.57, slope = 40.0 - 2.0 * 8.0 / std::sqrt(3.0);
  const double angle = base::kPi - 2.0 * std::asin(1.1 / 20.0);
  const struct {
    geometry::TriangleMesh mesh;
    double mm3;
  } cases[] = {{gableRoof(), 0.25 * std::sqrt(3.0) * 1600 * 30},
               {ribOnRoof(), width * (2 * slope * height + base::kPi / 3 * height * height)},
               {halfCylinder(), 0.5 * base::kPi * 400 * 30},
               {ribOnCylinder(), width * 0.5 * angle * (22.05 * 22.05 - 400)}};
  for (const auto& c : cases) {
    EXPECT_TRUE(geometry::boundaryLoops(c.mesh).empty());
    EXPECT_NEAR(geometry::volume(c.mesh), c.mm3, 1e-3 * c.mm3);
  }
}

TEST(AccuracyPlate, HasTheSourcesSizes) {
  for (const double length : {50.0, 100.0, 210.0, 260.0, 310.0, 360.0}) {
    const AccuracyPlate plate = accuracyPlate(length);
    EXPECT_EQ(plate.slotLengthMm, length - (length < 200.0 ? 40.0 : 50.0));
    const geometry::TriangleMesh mesh = accuracyPlateMesh(plate);
    EXPECT_TRUE(geometry::boundaryLoops(mesh).empty());
    EXPECT_NEAR((sizesOf(mesh) - Eigen::Vector3d(length, 20, 5)).norm(), 0.0, 1e-9);
    const double area = length * 20.0 - (1.0 - base::kPi / 4.0) * 25.0 - base::kPi * 25.0 -
                        plate.slotLengthMm * 5.0;
    EXPECT_NEAR(geometry::volume(mesh), 5.0 * area, 0.2);
  }
}

TEST(Specimens, AreLoadedByTheirNames) {
  for (const std::string& name : sampleNames()) {
    const auto part = loadPart("sample:" + name, true, {});
    EXPECT_EQ(part->name, name + ".stl");
    EXPECT_FALSE(part->source->triangles.empty());
  }
}

} // namespace
} // namespace voluta::project
