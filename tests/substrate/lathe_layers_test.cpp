// Layers around rods against the volumes and areas of the solids that parts approximate.
#include "base/error.h"
#include "base/units.h"
#include "geometry/measures.h"
#include "geometry/repair/diagnosis.h"
#include "helpers/lathe_parts.h"
#include "helpers/layer_volume.h"
#include "helpers/shapes.h"
#include "layers/layer_checks.h"
#include "plan/finding_kinds.h"
#include "substrate/lathe_layers.h"

#include <cmath>
#include <gtest/gtest.h>
#include <string>

namespace voluta {
namespace {

using geometry::TriangleMesh;
using platform::RodShape;
using substrate::LatheLayers;
using substrate::LatheOptions;

const RodShape kRod = platform::straightRod(5, 200);

LatheLayers layersOf(const TriangleMesh& part, const RodShape& rod, double volumeMm3,
                     const LatheOptions& options = {}) {
  const TriangleMesh left = substrate::partAroundRod(part, rod);
  EXPECT_TRUE(geometry::diagnose(left).watertight);
  LatheLayers made = substrate::latheLayers(left, rod, options, {});
  EXPECT_NEAR(test::volumeOf(made.stack) / volumeMm3, 1.0, 1e-3);
  const geometry::MeshQuery query(left);
  for (const auto& check : layers::checkBoundaries(made.stack, query, 1e-3, {})) {
    EXPECT_LE(check.farthestMm, 1e-3);
    EXPECT_EQ(check.onSurface, 1.0);
    EXPECT_TRUE(check.simple);
  }
  for (const auto& check :
       layers::checkSupport(made.stack, 1.25, {}, {}, substrate::rodGround(rod)))
    EXPECT_GT(check.supportedFraction, 0.95);
  EXPECT_GE(made.statistics.withinLimitsFraction, 0.999);
  EXPECT_EQ(made.unsupportedPatches, 0u);
  EXPECT_EQ(made.slivers, 0u);
  int last = 0;
  for (const layers::Patch& p : made.stack.patches) {
    EXPECT_GE(p.layer, last);
    last = p.layer;
  }
  return made;
}

// The parts of lathe_parts.h, but 20 mm long.
std::vector<Eigen::Vector2d> shortened(std::vector<Eigen::Vector2d> section) {
  for (Eigen::Vector2d& p : section)
    p.x() *= 0.4;
  return section;
}
TriangleMesh shortTube() {
  return test::revolved(shortened(test::tubeSection()), 256);
}

double revolvedOnRod(const std::vector<Eigen::Vector2d>& section) {
  return test::revolvedVolume(test::onRod(section, 2.5));
}

TEST(LatheLayers, Tube) {
  const auto made = layersOf(shortTube(), kRod, revolvedOnRod(shortened(test::tubeSection())));
  EXPECT_EQ(made.stack.layerCount, 10);
  EXPECT_EQ(made.stack.patches.size(), 10u);
  EXPECT_NEAR(made.outerMm.front(), 2.75, 1e-6);
  EXPECT_NEAR(made.outerMm.back(), 5.0, 1e-6);
  EXPECT_TRUE(made.findings.empty());
  EXPECT_EQ(substrate::latheOverhang(shortTube(), kRod, {}, {}).areaMm2, 0.0);
}

TEST(LatheLayers, FirstLayerOfItsOwnHeight) {
  LatheOptions options;
  options.firstLayerMm = 0.3;
  options.layerHeightMm = 0.2;
  const auto made =
      layersOf(shortTube(), kRod, revolvedOnRod(shortened(test::tubeSection())), options);
  EXPECT_EQ(made.stack.layerCount, 12);
  EXPECT_NEAR(made.outerMm.front(), 2.8, 1e-6);
  EXPECT_NEAR(made.outerMm[1], 3.0, 1e-6);
}

TEST(LatheLayers, ShouldersAreLayeredFromTheRodOutwards) {
  const auto section = shortened(test::shoulderSection());
  const auto made = layersOf(test::revolved(section, 256), kRod, revolvedOnRod(section));
  EXPECT_EQ(made.stack.layerCount, 10);
  // 1.5 mm at the seats are six layers of the whole length, the others are between them.
  for (const layers::Patch& p : made.stack.patches)
    EXPECT_NEAR(geometry::bounds(p.surface).sizes().x(), p.layer < 6 ? 20.0 : 12.0, 1e-3);
}

TEST(LatheLayers, ShouldersBetweenLevels) {
  const std::vector<Eigen::Vector2d> section = {{-10, 2.4}, {-10, 3.6}, {-4, 3.6}, {-4, 4.1},
                                                {4, 4.1},   {4, 3.6},   {10, 3.6}, {10, 2.4}};
  layersOf(test::revolved(section, 256), kRod, revolvedOnRod(section));
}

TEST(LatheLayers, TwoCollarsGrowTogether) {
  const std::vector<Eigen::Vector2d> section = {{-10, 2.4}, {-10, 4}, {-6, 4}, {-6, 3},
                                                {6, 3},     {6, 4},   {10, 4}, {10, 2.4}};
  const auto made = layersOf(test::revolved(section, 256), kRod, revolvedOnRod(section));
  EXPECT_EQ(made.stack.layerCount, 6);
  EXPECT_EQ(made.stack.patches.size(), 2u + 2u * 4u);
}

TEST(LatheLayers, TaperedEnds) {
  layersOf(test::revolved(test::taperedSection(), 256), kRod,
           revolvedOnRod(test::taperedSection()));
}

TEST(LatheLayers, HalfTurnSector) {
  const auto made = layersOf(test::halfTube(4.8, 10, 20), kRod, 0.5 * base::kPi * (25 - 6.25) * 20);
  EXPECT_EQ(made.stack.layerCount, 10);
}

TEST(LatheLayers, HexagonalRod) {
  const RodShape hex = platform::straightRod(5, 200, 6);
  const auto made =
      layersOf(test::hexagonalTube(4.8, 10, 20), hex, test::hexagonalTubeVolume(5, 10, 20));
  EXPECT_GE(made.stack.layerCount, 10);
}

TEST(LatheLayers, ThatFollowAHexagonalRod) {
  const RodShape hex = platform::straightRod(5, 200, 6);
  LatheOptions options;
  options.followsRod = true;
  layersOf(test::hexagonalTube(4.8, 10, 20), hex, test::hexagonalTubeVolume(5, 10, 20), options);
}

TEST(LatheLayers, SteppedRod) {
  const RodShape rod{{{-60, 2.5}, {0, 2.5}, {0, 3.5}, {60, 3.5}}, 0};
  layersOf(shortTube(), rod, base::kPi * 10 * (2 * 25 - 6.25 - 12.25));
}

TEST(LatheLayers, OverhangGivesAFindingWithItsPlace) {
  // A rim that reaches out 3 mm on both sides of a stem, its undersides at radius 4.
  const std::vector<Eigen::Vector2d> section = {{-3, 2.4}, {-3, 4}, {-6, 4}, {-6, 5},
                                                {6, 5},    {6, 4},  {3, 4},  {3, 2.4}};
  const TriangleMesh part = substrate::partAroundRod(test::revolved(section, 256), kRod);
  const substrate::Overhang found = substrate::latheOverhang(part, kRod, {}, {});
  EXPECT_NEAR(found.areaMm2 / (2 * 2 * base::kPi * 4 * 3), 1.0, 1e-3);
  EXPECT_NEAR(found.worstAt.tail<2>().norm(), 4.0, 0.01);
  EXPECT_GT(std::abs(found.worstAt.x()), 3.0);
  const auto finding = substrate::overhangFinding(found, {}, substrate::GroundKind::Rod);
  ASSERT_TRUE(finding);
  EXPECT_EQ(voluta::plan::reportId(*finding), "overhang");
  EXPECT_FALSE(finding->blocking);
  EXPECT_EQ(finding->where, found.worstAt);
  EXPECT_FALSE(substrate::overhangFinding({}, {}, substrate::GroundKind::Rod));
  // Cones of 40 degrees under it are steep enough, of 50 they are not.
  for (const bool risky : {false, true}) {
    const double reach = 1.5 * std::tan(base::degreesToRadians(risky ? 50 : 40));
    const std::vector<Eigen::Vector2d> cone = {{-3, 2.4},       {-3, 2.5},      {-3 - reach, 4},
                                               {-3 - reach, 5}, {3 + reach, 5}, {3 + reach, 4},
                                               {3, 2.5},        {3, 2.4}};
    const auto cones = substrate::latheOverhang(
        substrate::partAroundRod(test::revolved(cone, 256), kRod), kRod, {}, {});
    EXPECT_EQ(cones.areaMm2 > 0.0, risky);
  }
}

void expectRefusal(const TriangleMesh& part, const RodShape& rod, const std::string& what) {
  try {
    substrate::latheLayers(substrate::partAroundRod(part, rod), rod, {}, {});
    ADD_FAILURE() << what;
  } catch (const base::Error& e) {
    EXPECT_EQ(e.code(), base::ErrorCode::UnusableInput);
    EXPECT_NE(std::string(e.what()).find(what), std::string::npos) << e.what();
    EXPECT_EQ(std::string(e.what()).find('\n'), std::string::npos);
    EXPECT_FALSE(e.remedy().empty());
  }
}

TEST(LatheLayers, BadInputGivesAnErrorOfOneLine) {
  const TriangleMesh tube = test::revolved(test::tubeSection(), 128);
  expectRefusal(tube, platform::straightRod(12, 200), "the rod is thicker than the part");
  expectRefusal(tube, platform::straightRod(10, 200), "the rod is thicker than the part");
  expectRefusal(tube, platform::straightRod(9.9, 200), "beyond the rod, less than a layer");
  expectRefusal(tube, platform::straightRod(5, 40), "beyond an end of the rod");
  TriangleMesh beside = tube;
  for (auto& p : beside.vertices)
    p.y() += 12;
  expectRefusal(beside, kRod, "the part misses the rod");
  expectRefusal(test::revolved({{-25, 4}, {-25, 5}, {25, 5}, {25, 4}}, 128), kRod,
                "the part misses the rod");
  TriangleMesh open = tube;
  open.triangles.resize(open.triangles.size() - 2);
  expectRefusal(open, kRod, "not closed");
  expectRefusal(tube, RodShape{{{0, 1}}, 0}, "at least two points");
}

TEST(LatheLayers, SameForAnyNumberOfThreads) {
  const TriangleMesh part =
      substrate::partAroundRod(test::revolved(test::taperedSection(), 96), kRod);
  const auto one = substrate::latheLayers(part, kRod, {}, {});
  const auto four = substrate::latheLayers(part, kRod, {}, base::RunContext({}, 4));
  ASSERT_EQ(one.stack.patches.size(), four.stack.patches.size());
  for (std::size_t p = 0; p < one.stack.patches.size(); ++p) {
    EXPECT_EQ(one.stack.patches[p].surface.triangles, four.stack.patches[p].surface.triangles);
    EXPECT_EQ(one.stack.patches[p].thicknessMm, four.stack.patches[p].thicknessMm);
  }
}

} // namespace
} // namespace voluta
