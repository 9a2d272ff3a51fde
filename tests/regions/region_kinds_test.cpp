// Shapes of regions: their texts, and bodies with volumes in closed form.
#include "base/error.h"
#include "base/units.h"
#include "geometry/measures.h"
#include "geometry/repair/repair.h"
#include "regions/part_regions.h"
#include "regions/region_kinds.h"
#include "regions/region_text.h"
#include "regions/region_uses.h"

#include "helpers/shapes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace voluta::regions {
namespace {

using Eigen::Vector3d;

geometry::TriangleMesh bodyInBox(const std::string& shape) {
  const geometry::TriangleMesh part = test::box({-20, -20, 0}, {20, 20, 30});
  return bodyOf(project::Region{.shape = shape}, {part}, {0.8, 0.4, 1.0, 0.0, 1.2}, {});
}

TEST(RegionKinds, BodiesAreClosedAndHaveTheirVolume) {
  const std::vector<std::pair<std::string, double>> cases{
      {"box:1,2,3,4,5,6", 120.0},
      {"cylinder:0,0,5,8,10", base::kPi * 16.0 * 10.0},
      {"sphere:3,0,10,12", 4.0 / 3.0 * base::kPi * 216.0},
      {"height:5,9", 60.0 * 60.0 * 4.0}};
  for (const auto& [shape, mm3] : cases) {
    const geometry::TriangleMesh body = bodyInBox(shape);
    EXPECT_TRUE(geometry::isWatertight(body)) << shape;
    EXPECT_NEAR(geometry::volume(body) / mm3, 1.0, 0.002) << shape;
  }
  const Eigen::AlignedBox3d box = geometry::bounds(bodyInBox("box:1,2,3,4,5,6"));
  EXPECT_TRUE(box.min().isApprox(Vector3d(-1.0, -0.5, 0.0)));
  EXPECT_TRUE(box.max().isApprox(Vector3d(3.0, 4.5, 6.0)));
}

// A shape in the coordinates of the file moves with the part; a range of heights does not.
TEST(RegionKinds, ShapesOfTheFileFollowThePart) {
  const geometry::TriangleMesh part = test::box({0, 0, 0}, {80, 40, 20});
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.linear() = Eigen::AngleAxisd(base::kPi / 2.0, Vector3d::UnitZ()).toRotationMatrix();
  motion.translation() = Vector3d(10.0, 0.0, 5.0);
  const PlacedPart placed{part, motion, 2.0};
  const substrate::LevelOptions levels{0.8, 0.4, 1.0, 0.0, 1.2};
  const auto box =
      geometry::bounds(bodyOf(project::Region{.shape = "box:10,0,0,2,4,6"}, placed, levels, {}));
  EXPECT_TRUE(box.center().isApprox(Vector3d(10.0, 20.0, 5.0)));
  EXPECT_TRUE(box.sizes().isApprox(Vector3d(8.0, 4.0, 12.0)));
  const auto slab =
      geometry::bounds(bodyOf(project::Region{.shape = "height:5,9"}, placed, levels, {}));
  EXPECT_DOUBLE_EQ(slab.min().z(), 5.0);
  EXPECT_DOUBLE_EQ(slab.max().z(), 9.0);
}

TEST(RegionKinds, EveryFormIsReadAndEveryWrongTextIsRefused) {
  for (const RegionKind& kind : regionKinds()) {
    EXPECT_FALSE(kind.label.empty());
    EXPECT_NO_THROW(findUse(kind.usualUse)) << kind.word;
    if (kind.mesh == ShapeMesh::File)
      continue;
    std::string text(kind.word);
    std::string numbers;
    for (const ShapeField& field : kind.fields)
      numbers += (numbers.empty() ? ":" : ",") + std::to_string(field.usual.value_or(5.0));
    const Shape shape = parsedShape(text + numbers);
    EXPECT_EQ(shape.kind, &kind);
    EXPECT_EQ(shape.numbers.size(), kind.fields.size());
    for (const std::string& wrong :
         {text, text + ":", text + numbers + ",7", text + ":a", text + ":1e9" + numbers.substr(2)})
      EXPECT_THROW(parsedShape(wrong), base::Error) << wrong;
  }
  EXPECT_THROW(parsedShape("bux:1"), base::Error);
  EXPECT_THROW(bodyInBox("height:9,5"), base::Error);
}

// A painted square of a flat top: the body is a slab with a rounded edge.
TEST(RegionKinds, APaintedSurfaceHasItsDepth) {
  geometry::TriangleMesh square;
  square.vertices = {{-6, -6, 30}, {6, -6, 30}, {6, 6, 30}, {-6, 6, 30}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  const geometry::TriangleMesh part = test::box({-20, -20, 0}, {20, 20, 30});
  const project::Region region{.shape = "painted:2",
                               .mesh = std::make_shared<geometry::TriangleMesh>(square)};
  const auto body = bodyOf(region, {part}, {0.8, 0.4, 1.0, 0.0, 1.2}, {});
  // Both sides: slab, half cylinders along four edges, a ball at the corners.
  const double mm3 = 144.0 * 4.0 + 4.0 * 12.0 * base::kPi * 2.0 + 4.0 / 3.0 * base::kPi * 8.0;
  EXPECT_NEAR(geometry::volume(body) / mm3, 1.0, 0.01);
  EXPECT_THROW(parsedRegion("painted:2", {}), base::Error);
}

TEST(RegionText, ReadsUseNameAndSettings) {
  const project::Region region =
      parsedRegion("sphere:0,0,5,8;use=cut;name=Hole;walls=3;infill=fermat", {});
  EXPECT_EQ(region.shape, "sphere:0,0,5,8");
  EXPECT_EQ(region.use, "cut");
  EXPECT_EQ(region.name, "Hole");
  EXPECT_THAT(region.parameters, testing::UnorderedElementsAre(testing::Pair("walls", "3"),
                                                               testing::Pair("infill", "fermat")));
  EXPECT_EQ(parsedRegion("skin:2", {}).use, "surface");
  EXPECT_EQ(parsedRegion("height:1,5;use=flat:0,1,1", {}).use, "flat:0,1,1");
  for (const std::string wrong : {"flat:1,2", "flat:2,0,0", "turn:a", "cut:1", "flat:"})
    EXPECT_THROW(parsedRegion("height:1,5;use=" + wrong, {}), base::Error) << wrong;
  EXPECT_THROW(directionOf("flat:0,0,0"), base::Error);
  EXPECT_TRUE(directionOf("turn:0,1,1").isApprox(Vector3d(0, 1, 1).normalized()));
  EXPECT_TRUE(directionOf("flat").isApprox(Vector3d::UnitZ()));
  EXPECT_THROW(parsedRegion("sphere:0,0,5,8;walls", {}), base::Error);
  EXPECT_THROW(parsedRegion("sphere:0,0,5,8;use=cat", {}), base::Error);
  EXPECT_THROW(parsedRegion("mesh:", {}), base::Error);
  EXPECT_THROW(parsedRegion("mesh:/no/such.stl", {}), base::Error);
}

} // namespace
} // namespace voluta::regions
