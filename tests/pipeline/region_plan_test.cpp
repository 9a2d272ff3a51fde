// Parts with regions from the mesh to the replayed program.
#include "base/error.h"
#include "box_request.h"
#include "geometry/prism.h"
#include "helpers/given_parameters.h"
#include "helpers/made_solids.h"
#include "helpers/temporary_folder.h"
#include "layers/layer_stack.h"
#include "pipeline/checked_program.h"
#include "pipeline/plan_reasons.h"
#include "pipeline/road.h"
#include "pipeline/stage_cache.h"
#include "pipeline/stage_options.h"
#include "plan/tool_plan.h"
#include "planar/planar_decomposition.h"
#include "process/bead_model.h"
#include "project/job.h"
#include "regions/region_text.h"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>

namespace voluta::pipeline {
namespace {

using test::reasons;
using test::operator+;

PlanRequest requestWith(const std::vector<std::string>& regions, const std::string& density,
                        const std::string& mode = "flat") {
  PlanRequest request;
  request.item().loaded = test::loadedBox({-20, -16, 0}, {20, 16, 16});
  request.choices.item().mode = mode;
  request.choices.formats = {"gcode-extended"};
  test::giveParameters(request.choices, {{"infillDensity", density}});
  for (const std::string& text : regions)
    request.choices.item().regions.push_back(regions::parsedRegion(text, {}));
  return request;
}

double volumeWithin(const plan::ToolPlan& plan, double lowZ, double highZ) {
  double mm3 = 0.0;
  for (const plan::ToolPath& path : plan.paths) {
    if (plan::isWaste(path.kind))
      continue;
    for (std::size_t w = path.first + 1; w < path.first + path.count; ++w) {
      const Eigen::Vector3d middle = 0.5 * (plan.position[w] + plan.position[w - 1]);
      if (middle.z() > lowZ && middle.z() < highZ)
        mm3 += (plan.position[w] - plan.position[w - 1]).norm() *
               process::beadArea(plan.widthMm[w], plan.heightMm[w]);
    }
  }
  return mm3;
}

// A range of heights is solid, the rest is not: the beads show it.
TEST(RegionPlan, ARangeOfHeightsHasItsDensity) {
  const PlanResult plan = planPart(requestWith({"height:6.4,9.6;infillDensity=1"}, "0.2"), {});
  ASSERT_EQ(plan.checked.size(), 1u);
  EXPECT_TRUE(plan.checked[0]->verdict.passed) << reasons(plan);
  const plan::ToolPlan& paths = *plan.job.toolPlan;
  EXPECT_NEAR(volumeWithin(paths, 6.6, 9.7) / (40.0 * 32.0 * 3.2), 1.0, 0.02);
  EXPECT_LT(volumeWithin(paths, 9.7, 12.9) / (40.0 * 32.0 * 3.2), 0.6);
  const auto& regions = plan.job.report.item().layers.regions;
  ASSERT_EQ(regions.size(), 1u);
  EXPECT_NEAR(regions[0].volumeMm3 / (40.0 * 32.0 * 3.2), 1.0, 0.01);
  EXPECT_EQ(regions[0].stepMaxMm, 0.0);
}

// More walls round a place: beads inside it are walls only.
TEST(RegionPlan, ACylinderHasItsWalls) {
  const PlanResult plan = planPart(requestWith({"cylinder:0,0,8,12,40;walls=6"}, "1"), {});
  EXPECT_TRUE(plan.checked.at(0)->verdict.passed) << reasons(plan);
  const plan::ToolPlan& paths = *plan.job.toolPlan;
  double wallMm = 0.0, otherMm = 0.0;
  for (const plan::ToolPath& path : paths.paths)
    for (std::size_t w = path.first + 1; w < path.first + path.count; ++w) {
      const Eigen::Vector3d a = paths.position[w - 1], b = paths.position[w];
      if ((0.5 * (a + b)).head<2>().norm() < 5.0)
        (path.kind == plan::PathKind::Wall ? wallMm : otherMm) += (b - a).norm();
    }
  EXPECT_GT(wallMm, 20.0 * otherMm);
}

TEST(RegionPlan, CutsAndSkinsPassInTheirModes) {
  for (const auto& [mode, regions] : std::vector<std::pair<std::string, std::vector<std::string>>>{
           {"flat", {"box:0,0,16,10,100,8;use=cut"}},
           {"flat", {"skin:1.6"}},
           {"curved", {"sphere:0,0,16,14;infillDensity=1"}},
           {"planar", {"height:3,8;infillAngle=0"}}}) {
    const PlanResult plan = planPart(requestWith(regions, "1", mode), {});
    ASSERT_EQ(plan.checked.size(), 1u);
    EXPECT_TRUE(plan.checked[0]->verdict.passed) << mode << " " << regions[0] << reasons(plan);
  }
}

// A trunk with an arm to one side: two planar pieces under one curved skin.
TEST(RegionPlan, PlanarPiecesHaveACurvedSkin) {
  const auto underRoof = [](std::vector<Eigen::Vector2d> profile) {
    const double from = profile.back().x(), to = profile.front().x();
    for (int k = 0; k <= 20; ++k) {
      const double x = from + k * (to - from) / 20.0;
      profile.emplace_back(x, 36.0 + 5.0 * std::sin(0.2 + 0.0627 * (35.0 - x)));
    }
    geometry::TriangleMesh solid = geometry::prismOver(profile, -10.0, 10.0);
    for (Eigen::Vector3d& v : solid.vertices)
      v = Eigen::Vector3d(v.x(), -v.z(), v.y());
    return solid;
  };
  geometry::TriangleMesh part = underRoof({{-10, 0}, {10, 0}}) + underRoof({{5, 21}, {35, 27}});
  PlanRequest request = requestWith({"skin:2.4"}, "1", "planar");
  request.item().loaded = project::loadedFrom(
      "seven.stl", std::make_shared<geometry::TriangleMesh>(std::move(part)), {}, true, {});
  request.choices.formats = {"urscript"};
  const PlanResult plan = planPart(request, {});
  ASSERT_EQ(plan.checked.size(), 1u) << reasons(plan);
  EXPECT_TRUE(plan.checked[0]->verdict.passed) << reasons(plan);
  ASSERT_TRUE(plan.job.item().pieces());
  EXPECT_EQ(plan.job.item().pieces()->pieces.size(), 2u);
  const auto& regions = plan.job.report.item().layers.regions;
  ASSERT_EQ(regions.size(), 1u);
  EXPECT_EQ(regions[0].stepMaxMm, 0.0);
}

// Wound around a rod, then a flat lug on it.
TEST(RegionPlan, AFlatLugStandsOnAWoundGrip) {
  PlanRequest request;
  const geometry::TriangleMesh grip =
      test::cylinder({-15, 0, 0}, {15, 0, 0}, 8.0) + test::box({-6, -4, 0}, {6, 4, 14});
  request.item().loaded =
      project::loadedFrom("grip.stl", std::make_shared<geometry::TriangleMesh>(grip), {}, true, {});
  request.choices.item().mode = "lathe";
  request.choices.item().platform = project::Platform("rod:5x200");
  request.choices.cell = "lathe";
  request.choices.formats = {"gcode-extended"};
  test::giveParameters(request.choices, {{"rodAxis", "x"}});
  request.choices.item().regions.push_back(
      regions::parsedRegion("box:0,0,16,20,10,18;use=flat", {}));
  const PlanResult plan = planPart(request, {});
  ASSERT_EQ(plan.checked.size(), 1u) << reasons(plan);
  EXPECT_TRUE(plan.checked[0]->verdict.passed) << reasons(plan);
  const auto& regions = plan.job.report.item().layers.regions;
  ASSERT_EQ(regions.size(), 1u);
  EXPECT_NEAR(regions[0].volumeMm3 / (12.0 * 8.0 * 6.0), 1.0, 0.25); // and the cap below it
}

TEST(RegionPlan, ARegionOutsideThePartIsReported) {
  PlanRequest request = requestWith({"box:100,0,0,5,5,5;name=Far away;walls=3"}, "1");
  request.until = project::Stage::Layers;
  const PlanResult plan = planPart(request, {});
  EXPECT_THAT(reasons(plan), testing::HasSubstr("region box:100,0,0,5,5,5 is outside the part"));
}

// Regions within the part whose settings no bead can have.
TEST(RegionPlan, ARegionWithoutEffectSaysWhy) {
  const auto told = [](const std::vector<std::string>& regions, const std::string& mode) {
    PlanRequest request = requestWith(regions, "0.2", mode);
    request.until = project::Stage::Layers;
    return reasons(planPart(request, {}));
  };
  using testing::HasSubstr;
  EXPECT_THAT(told({"box:0,0,8,0.3,30,16;walls=4"}, "flat"),
              HasSubstr("narrower than half a bead"));
  EXPECT_THAT(told({"height:4.01,4.02;walls=4"}, "flat"), HasSubstr("too thin to meet a layer"));
  EXPECT_THAT(told({"box:0,0,8,0.2,0.2,0.2;walls=4"}, "curved"),
              HasSubstr("too thin to meet a layer"));
  EXPECT_THAT(told({"box:0,0,8,10,10,16;walls=4", "box:0,0,8,12,12,20;walls=1"}, "flat"),
              HasSubstr("later regions hold in all of it"));
  EXPECT_THAT(told({"box:0,0,8,4,20,16;walls=4;interlockMm=6"}, "flat"),
              HasSubstr("reaches through it in 10 of 20 layers"));
  EXPECT_THAT(told({"box:0,0,8,9,20,16;walls=4;interlockMm=3"}, "flat"),
              testing::Not(HasSubstr("no effect")));
}

TEST(RegionPlan, ARegionWithoutPaintHasNoEffect) {
  const auto paths = [](PlanRequest request) {
    request.until = project::Stage::Toolpath;
    return planPart(request, {});
  };
  const PlanResult without = paths(requestWith({}, "0.2"));
  for (const std::string use : {"settings", "cut", "flat", "around"}) {
    PlanRequest request = requestWith({}, "0.2");
    request.choices.item().regions = {
        {.shape = "painted:2", .use = use, .parameters = {{"walls", "5"}}}};
    const PlanResult plan = paths(std::move(request));
    EXPECT_THAT(reasons(plan), testing::HasSubstr("painted:2 is outside the part")) << use;
    ASSERT_TRUE(plan.job.toolPlan) << use;
    EXPECT_EQ(plan.job.toolPlan->position.size(), without.job.toolPlan->position.size()) << use;
  }
}

TEST(RegionPlan, WrongRegionsAreRefusedBeforeThePlan) {
  for (const std::string text :
       {"box:0,0,0,5,5,5;quality=strict", "box:0,0,0,5,5,5;wals=3", "box:0,0,0,5,5,5;walls=99",
        "box:0,0,0,5,5,5;use=surface", "height:1,2;layerHeightMm=0.6", "height:1,2;tool=3"}) {
    PlanRequest request = requestWith({text}, "1");
    EXPECT_THROW(planPart(request, {}), base::Error) << text;
  }
  EXPECT_THROW(planPart(requestWith({"skin:2"}, "1", "trace"), {}), base::Error);
  EXPECT_THROW(planPart(requestWith({"height:-1,3;use=cut"}, "1"), {}), base::Error);
  EXPECT_THROW(planPart(requestWith({"height:-1,3;use=flat"}, "1"), {}), base::Error);
}

// A project keeps regions, meshes included; its results stay those of its choices.
TEST(RegionPlan, AProjectKeepsRegions) {
  const test::TemporaryFolder folder;
  PlanRequest request = requestWith({"height:4,8;infillDensity=0.5;name=Band"}, "0.2");
  request.choices.item().regions.push_back(
      {.name = "Body",
       .shape = "mesh:body.stl",
       .mesh = std::make_shared<geometry::TriangleMesh>(test::box({-5, -5, -1}, {5, 5, 20})),
       .parameters = {{"walls", "4"}}});
  request.until = project::Stage::Layers;
  const PlanResult plan = planPart(request, {});
  project::writeJob(folder.path() / "job.voluta", plan.job);
  const project::Job read = project::readJob(folder.path() / "job.voluta", allParameters());
  EXPECT_EQ(read.choices.item().regions, request.choices.item().regions);
  ASSERT_EQ(read.item().layers->patches.size(), plan.job.item().layers->patches.size());
  for (std::size_t i = 0; i < read.item().layers->patches.size(); ++i)
    EXPECT_EQ(read.item().layers->patches[i].region, plan.job.item().layers->patches[i].region);
  EXPECT_EQ(read.keys(), plan.job.keys());
}

// The key of each stage changes with what it uses, and with nothing else.
TEST(RegionPlan, KeysFollowTheRegions) {
  const auto keysWith = [](const std::string& region) {
    PlanRequest request = requestWith({region}, "0.5");
    request.until = project::Stage::Load;
    return stageKeys(request);
  };
  const auto differ = [&](const std::string& a, const std::string& b, project::Stage first) {
    const auto x = keysWith(a), y = keysWith(b);
    for (std::size_t s = 0; s < x.size(); ++s)
      EXPECT_EQ(x[s] != y[s], s >= project::indexOf(first)) << a << b << s;
  };
  using enum project::Stage;
  differ("height:4,8;use=cut", "height:4,9;use=cut", Load);
  differ("skin:1.6", "skin:2.4", Decompose);
  differ("height:4,8", "height:4,9", Layers);
  differ("height:4,8;walls=3", "height:4,8;walls=4", Toolpath);
  differ("height:4,8;interlockMm=1", "height:4,8;interlockMm=2", Layers);
  differ("height:4,8;supports=always", "height:4,8;supports=auto", Decompose); // lost voxels
  differ("height:4,8;seamHere=always", "height:4,8;walls=4", Layers);
  differ("height:4,8;seamHere=always", "height:4,8;seamHere=never", Toolpath);
  differ("height:4,8;speedFactor=0.5", "height:4,8", Toolpath);
  EXPECT_EQ(keysWith("height:4,8;name=a"), keysWith("height:4,8;name=b"));
}

// Keys state the order of regions and the tool of each: results of one order or tool are not taken
// for another.
TEST(RegionPlan, KeysStateOrderAndTools) {
  const auto keysOf = [](const std::vector<std::string>& regions) {
    PlanRequest request = requestWith(regions, "0.5");
    request.choices.tools.push_back({"fdm-1.0"});
    request.until = project::Stage::Load;
    return stageKeys(request);
  };
  const std::string settings = "cylinder:0,0,8,12,40;walls=5", cut = "box:0,0,16,6,100,4;use=cut",
                    skin = "skin:1.6";
  constexpr std::size_t kLayers = project::indexOf(project::Stage::Layers);
  EXPECT_NE(keysOf({settings, cut})[kLayers], keysOf({cut, settings})[kLayers]);
  EXPECT_NE(keysOf({settings, skin})[kLayers], keysOf({skin, settings})[kLayers]);
  EXPECT_NE(keysOf({settings + ";tool=2"})[kLayers], keysOf({settings + ";tool=1"})[kLayers]);
}

// A second plan with another tool, from the cache of the first.
TEST(RegionPlan, ATouchedToolPrintsTheRegionAgain) {
  StageCache cache;
  const auto toolsWith = [&](const std::string& tool) {
    PlanRequest request = requestWith({"cylinder:0,0,8,16,40;tool=" + tool}, "1");
    request.choices.tools.push_back({"fdm-1.0"});
    request.until = project::Stage::Toolpath;
    const PlanResult plan = planPart(request, {}, &cache);
    std::map<int, double> mm;
    const plan::ToolPlan& paths = *plan.job.toolPlan;
    for (const plan::ToolPath& path : paths.paths)
      for (std::size_t w = path.first + 1; w < path.first + path.count; ++w)
        if (paths.position[w].head<2>().norm() < 6.0)
          mm[path.tool] += (paths.position[w] - paths.position[w - 1]).norm();
    return mm;
  };
  EXPECT_GT(toolsWith("2")[1], 100.0);
  EXPECT_EQ(toolsWith("1")[1], 0.0);
}

// Each of two parts has its own regions, in mode auto too.
TEST(RegionPlan, PartsHaveTheirOwnRegions) {
  PlanRequest request = requestWith({"height:4,8;walls=4"}, "1");
  request.items.push_back(request.items.front());
  request.choices.items.push_back(request.choices.item());
  request.choices.item(1).regions = {regions::parsedRegion("skin:1.6", {})};
  request.choices.item(1).placement.centreMm = {80.0, 0.0};
  for (project::ItemChoices& item : request.choices.items)
    item.automatic = true;
  request.until = project::Stage::Layers;
  const PlanResult plan = planPart(request, {});
  ASSERT_EQ(plan.job.report.item(0).layers.regions.size(), 1u);
  EXPECT_EQ(plan.job.report.item(0).layers.regions[0].use, "settings");
  ASSERT_EQ(plan.job.report.item(1).layers.regions.size(), 1u);
  EXPECT_EQ(plan.job.report.item(1).layers.regions[0].use, "surface");
}

// An earlier region with settings leaves a later skin alone.
TEST(RegionPlan, TheLaterRegionHoldsForLayersToo) {
  PlanRequest request = requestWith({"height:0,100;infillDensity=0.3", "skin:1.6"}, "0.2");
  request.until = project::Stage::Layers;
  const PlanResult plan = planPart(request, {});
  const auto& regions = plan.job.report.item().layers.regions;
  ASSERT_EQ(regions.size(), 2u);
  EXPECT_NEAR(regions[1].volumeMm3 / (40.0 * 32.0 * 1.6), 1.0, 0.02);
}

} // namespace
} // namespace voluta::pipeline
