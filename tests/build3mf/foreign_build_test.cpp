// Files of other programs: all that the extension allows, read with the file's values.
#include "base/error.h"
#include "base/run_context.h"
#include "build3mf/build_reader.h"
#include "foreign_package.h"

#include <Eigen/Geometry>
#include <cmath>
#include <gtest/gtest.h>

using namespace voluta;
using Eigen::Vector3d;
using test::foreignLayer;
using test::foreignSegment;
using test::point6d;

namespace {

build3mf::ReadBuild read(const test::ForeignBuild& file) {
  return build3mf::readBuild(file.bytes(), "foreign.build.3mf", base::RunContext());
}

TEST(ForeignBuild, UnitsAreTurnedIntoMillimetres) {
  test::ForeignBuild file;
  file.unit = "inch";
  file.layers = {foreignLayer(
      foreignSegment("polyline6d", point6d(1000, -2000, 500) + point6d(2000, 0, 500)))};
  const build3mf::ReadBuild got = read(file);
  ASSERT_EQ(got.plan.waypointCount(), 2u);
  EXPECT_LT((got.plan.position[0] - Vector3d(25.4, -50.8, 12.7)).norm(), 1e-9);
  EXPECT_FALSE(got.workFrame);
  EXPECT_FALSE(got.hasObject);
  // Process values are metric whatever the unit (Part II).
  EXPECT_FLOAT_EQ(got.plan.widthMm[0], 2.0f);
  EXPECT_FLOAT_EQ(got.plan.heightMm[1], 1.0f);
  EXPECT_FLOAT_EQ(got.plan.speedMmPerS[1], 30.0f);
  EXPECT_EQ(got.plan.paths[0].kind, plan::PathKind::Wall);
}

TEST(ForeignBuild, ALayerThatIsNotListedIsNamed) {
  test::ForeignBuild file;
  file.layers = {
      foreignLayer(foreignSegment("polyline6d", point6d(0, 0, 500) + point6d(2000, 0, 500)))};
  EXPECT_TRUE(read(file).notes.empty());
  file.moreRelations = "<Relationship Target=\"/Slices/L7.xml\" Id=\"l7\" "
                       "Type=\"http://schemas.3mf.io/3dmanufacturing/toolpath/2026/03/layer\"/>";
  EXPECT_EQ(base::english(read(file).notes),
            std::vector<std::string>{
                "not used: the layer '/Slices/L7.xml', which is not in the list of layers"});
}

TEST(ForeignBuild, ThreeAxisPathsGetVerticalDirections) {
  test::ForeignBuild file;
  file.type = "3axis";
  file.layers = {foreignLayer(foreignSegment(
      "polyline3d",
      "<point3d x=\"0\" y=\"0\" z=\"1000\"/><point3d x=\"5000\" y=\"0\" z=\"1500\"/>"))};
  const build3mf::ReadBuild got = read(file);
  ASSERT_EQ(got.plan.waypointCount(), 2u);
  EXPECT_EQ(got.plan.direction[1], Vector3d::UnitZ());
  EXPECT_LT((got.plan.position[1] - Vector3d(5, 0, 1.5)).norm(), 1e-12);
}

// As slicers for filament have them: polylines, loops and hatches of layers at their heights.
TEST(ForeignBuild, PlanarLayersGetTheirHeights) {
  const auto point = [](int x, int y) {
    return "<point x=\"" + std::to_string(x) + "\" y=\"" + std::to_string(y) + "\"/>";
  };
  test::ForeignBuild file;
  file.type = "planar";
  file.profile = "uuid=\"00000000-0000-0000-0000-00000000000A\" name=\"Perimeter\" "
                 "depositionspeed=\"30\" beadwidth=\"2\"";
  file.tops = {800, 1500};
  file.layers = {
      foreignLayer(foreignSegment("polyline", point(0, 0) + point(5000, 0) + point(5000, 4000)) +
                   foreignSegment("loop", point(0, 0) + point(9000, 0) + point(9000, 9000))),
      foreignLayer(foreignSegment("hatch", "<hatch x1=\"0\" y1=\"0\" x2=\"1000\" y2=\"0\"/>"
                                           "<hatch x1=\"1000\" y1=\"200\" x2=\"0\" y2=\"200\"/>"))};
  const build3mf::ReadBuild got = read(file);
  ASSERT_EQ(got.plan.paths.size(), 4u);
  const auto at = [&](std::size_t path, std::size_t i) {
    return got.plan.position[got.plan.paths[path].first + i];
  };
  EXPECT_EQ(got.plan.paths[0].count, 3u);
  EXPECT_FALSE(got.plan.paths[0].closed);
  EXPECT_LT((at(0, 2) - Vector3d(5, 4, 0.8)).norm(), 1e-12);
  // A loop ends where it began.
  EXPECT_EQ(got.plan.paths[1].count, 4u);
  EXPECT_TRUE(got.plan.paths[1].closed);
  EXPECT_LT((at(1, 3) - Vector3d(0, 0, 0.8)).norm(), 1e-12);
  // Each hatch is a path of its own.
  EXPECT_EQ(got.plan.paths[2].count, 2u);
  EXPECT_LT((at(2, 1) - Vector3d(1, 0, 1.5)).norm(), 1e-12);
  EXPECT_LT((at(3, 0) - Vector3d(1, 0.2, 1.5)).norm(), 1e-12);
  EXPECT_EQ(got.plan.paths[0].layer, 0);
  EXPECT_EQ(got.plan.paths[3].layer, 1);
  for (std::size_t i = 0; i < got.plan.waypointCount(); ++i) {
    EXPECT_EQ(got.plan.direction[i], Vector3d::UnitZ());
    EXPECT_FLOAT_EQ(got.plan.widthMm[i], 2.0f);
    EXPECT_FLOAT_EQ(got.plan.heightMm[i], i < 7 ? 0.8f : 0.7f) << "what the layer is thick";
  }
}

TEST(ForeignBuild, ALoopThatRepeatsItsFirstPointHasNoSecondEnd) {
  test::ForeignBuild file;
  file.type = "planar";
  file.tops = {1000};
  file.layers = {foreignLayer(foreignSegment(
      "loop", "<point x=\"0\" y=\"0\"/><point x=\"9000\" y=\"0\"/><point x=\"9000\" y=\"9000\"/>"
              "<point x=\"0\" y=\"0\"/>"))};
  const build3mf::ReadBuild got = read(file);
  ASSERT_EQ(got.plan.waypointCount(), 4u);
  EXPECT_FLOAT_EQ(got.plan.heightMm[0], 1.0f);
}

TEST(ForeignBuild, AFramesZIsTheDirection) {
  test::ForeignBuild file;
  // 90 degrees about x: z is mapped to -y. The quaternion has twice unit length and is normalised.
  const std::string frame = "i=\"1.41421356237\" j=\"0\" k=\"0\" w=\"1.41421356237\"/>";
  file.layers = {foreignLayer(
      foreignSegment("polyline6d", "<point6d x=\"0\" y=\"-9000\" z=\"0\" " + frame +
                                       "<point6d x=\"1000\" y=\"-9000\" z=\"0\" " + frame))};
  const build3mf::ReadBuild got = read(file);
  EXPECT_LT((got.plan.direction[0] - Vector3d(0, -1, 0)).norm(), 1e-9);
}

TEST(ForeignBuild, FramesThatLookIntoThePartAreTurnedOver) {
  test::ForeignBuild file;
  const std::string down = "i=\"1\" j=\"0\" k=\"0\" w=\"0\"/>";
  for (int layer = 0; layer < 3; ++layer) {
    const std::string z = std::to_string(1000 * (layer + 1));
    file.layers.push_back(foreignLayer(
        foreignSegment("polyline6d", "<point6d x=\"0\" y=\"0\" z=\"" + z + "\" " + down +
                                         "<point6d x=\"9000\" y=\"0\" z=\"" + z + "\" " + down)));
  }
  const build3mf::ReadBuild got = read(file);
  EXPECT_LT((got.plan.direction[0] - Vector3d::UnitZ()).norm(), 1e-9);
  EXPECT_EQ(got.notes.size(), 1u);
  EXPECT_EQ(got.plan.paths[2].layer, 2);
}

TEST(ForeignBuild, ModifiersOfEachType) {
  test::ForeignBuild file;
  file.modifiers =
      "<tp:modifier attribute=\"beadwidth\" type=\"nonlinear\" minvalue=\"1\" maxvalue=\"3\" "
      "factor=\"g\"/><tp:modifier attribute=\"beadheight\" type=\"linear\" minvalue=\"0.5\" "
      "maxvalue=\"1\" factor=\"e\"/><tp:modifier attribute=\"depositionspeed\" type=\"constant\" "
      "minvalue=\"10\" maxvalue=\"50\" factor=\"h\"/>";
  const std::string bent =
      "<point6d x=\"10000\" y=\"0\" z=\"0\" i=\"0\" j=\"0\" k=\"0\" w=\"1\" "
      "g1=\"0\" g2=\"1\" e1=\"0\" e2=\"1\" h=\"0.5\"><sub t=\"0.2\" g=\"0.8\"/>"
      "<sub t=\"0.6\" g=\"0.9\"/></point6d>";
  file.layers = {foreignLayer(foreignSegment("polyline6d", point6d(0, 0, 0) + bent))};
  const plan::ToolPlan plan = read(file).plan;
  ASSERT_EQ(plan.waypointCount(), 4u); // the ends and two supports
  EXPECT_FLOAT_EQ(plan.widthMm[0], 1.0f);
  EXPECT_FLOAT_EQ(plan.widthMm[1], 2.6f);
  EXPECT_FLOAT_EQ(plan.widthMm[2], 2.8f);
  EXPECT_FLOAT_EQ(plan.widthMm[3], 3.0f);
  EXPECT_NEAR(plan.position[1].x(), 2.0, 1e-12);
  EXPECT_FLOAT_EQ(plan.heightMm[1], 0.6f);
  EXPECT_FLOAT_EQ(plan.speedMmPerS[3], 30.0f);
}

TEST(ForeignBuild, StepOfASectionIsAtThePoint) {
  test::ForeignBuild file;
  file.modifiers = "<tp:modifier attribute=\"beadwidth\" type=\"constant\" minvalue=\"1\" "
                   "maxvalue=\"3\" factor=\"f\"/>";
  file.layers = {
      foreignLayer(foreignSegment("polyline6d", point6d(0, 0, 0) + point6d(10000, 0, 0, "f=\"0\"") +
                                                    point6d(20000, 0, 0, "f=\"1\"")))};
  const plan::ToolPlan plan = read(file).plan;
  ASSERT_EQ(plan.waypointCount(), 4u);
  EXPECT_FLOAT_EQ(plan.widthMm[1], 1.0f);
  EXPECT_NEAR(plan.position[2].x(), 10.1, 1e-9);
  EXPECT_FLOAT_EQ(plan.widthMm[2], 3.0f);
  EXPECT_FLOAT_EQ(plan.widthMm[3], 3.0f);
}

TEST(ForeignBuild, TheShorterWayBetweenFrames) {
  test::ForeignBuild file;
  file.modifiers = "<tp:modifier attribute=\"beadwidth\" type=\"nonlinear\" minvalue=\"1\" "
                   "maxvalue=\"3\" factor=\"f\"/>";
  // The same frame with the other sign: nothing turns between them.
  const std::string other = "<point6d x=\"10000\" y=\"0\" z=\"0\" i=\"0\" j=\"0\" k=\"0\" w=\"-1\" "
                            "f1=\"0\" f2=\"1\"><sub t=\"0.5\" f=\"0.2\"/></point6d>";
  file.layers = {foreignLayer(foreignSegment("polyline6d", point6d(0, 0, 0) + other))};
  const plan::ToolPlan plan = read(file).plan;
  ASSERT_EQ(plan.waypointCount(), 3u);
  EXPECT_LT((plan.direction[1] - Vector3d::UnitZ()).norm(), 1e-9);
}

TEST(ForeignBuild, WaitsAndOthersDataAreLeftOut) {
  test::ForeignBuild file;
  file.profile += " prewaittime=\"500\" x:codec=\"4\"";
  file.extra = "<tp:toolpathdata><x:secret><x:point6d/></x:secret></tp:toolpathdata>";
  file.layers = {
      "<layer xmlns=\"http://schemas.3mf.io/3dmanufacturing/toolpath/2026/03\" "
      "xmlns:x=\"urn:somebody\"><parts><part id=\"1\" uuid=\"q\"/></parts><profiles><profile "
      "id=\"1\" uuid=\"00000000-0000-0000-0000-00000000000a\"/></profiles><data><x:a><x:b/></x:a>"
      "</data><segments><segment type=\"polyline6d\" profileid=\"1\" partid=\"1\" x:y=\"z\">" +
      point6d(0, 0, 0) + point6d(1000, 0, 0) + "<x:point6d/></segment></segments></layer>"};
  const build3mf::ReadBuild got = read(file);
  EXPECT_EQ(got.plan.waypointCount(), 2u);
  EXPECT_EQ(got.notes.size(), 1u);
}

TEST(ForeignBuild, ValuesMissingInAProfileAreZero) {
  test::ForeignBuild file;
  file.profile = "uuid=\"00000000-0000-0000-0000-00000000000a\" name=\"Support raft\"";
  file.layers = {
      foreignLayer(foreignSegment("polyline6d", point6d(0, 0, 0) + point6d(1000, 0, 0)))};
  const plan::ToolPlan plan = read(file).plan;
  EXPECT_EQ(plan.widthMm[0], 0.0f);
  EXPECT_EQ(plan.speedMmPerS[1], 0.0f);
  EXPECT_EQ(plan.paths[0].kind, plan::PathKind::Support);
}

TEST(ForeignBuild, ABuildChoosesAmongSets) {
  test::ForeignBuild file;
  file.build = "tp:toolpathid=\"3\"";
  file.layers = {
      foreignLayer(foreignSegment("polyline6d", point6d(0, 0, 0) + point6d(1000, 0, 0)))};
  EXPECT_EQ(read(file).plan.waypointCount(), 2u);
  file.build = "tp:toolpathid=\"8\"";
  EXPECT_THROW(read(file), base::Error);
}

} // namespace
