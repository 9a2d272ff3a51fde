// Parts into which the operator puts a body while they are printed.
#include "base/files.h"
#include "box_request.h"
#include "geometry/measures.h"
#include "helpers/given_parameters.h"
#include "helpers/temporary_folder.h"
#include "pipeline/checked_program.h"
#include "pipeline/plan_reasons.h"
#include "pipeline/plan_verdict.h"
#include "pipeline/road.h"
#include "pipeline/stage_cache.h"
#include "pipeline/stage_options.h"
#include "plan/finding_kinds.h"
#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "process/bead_model.h"
#include "project/job.h"
#include "regions/region_text.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace voluta::pipeline {
namespace {

using Eigen::Vector3d;
using test::reasons;

// A box 16 high in layers of 0.8.
PlanRequest requestWith(const std::vector<std::string>& regions,
                        const std::map<std::string, std::string>& parameters = {}) {
  PlanRequest request;
  request.item().loaded = test::loadedBox({-20, -16, 0}, {20, 16, 16});
  request.choices.item().mode = "flat";
  request.choices.formats = {"urscript"};
  test::giveParameters(request.choices, parameters);
  for (const std::string& text : regions)
    request.choices.item().regions.push_back(regions::parsedRegion(text, {}));
  return request;
}

// From 3.2 to 8 over the plate, 10 by 10: closed by the eleventh layer.
const std::string kNut = "box:0,0,5.6,10,10,4.8;use=insert;name=M3 nut";

std::vector<plan::TrajectoryEvent> pausesOf(const PlanResult& plan) {
  std::vector<plan::TrajectoryEvent> pauses;
  std::ranges::copy_if(
      plan.job.trajectory->events, std::back_inserter(pauses),
      [](const plan::TrajectoryEvent& event) { return event.kind == plan::EventKind::Pause; });
  return pauses;
}

TEST(InsertPlan, HasItsRoomAndAPauseWhenItIsComplete) {
  const PlanResult plan = planPart(requestWith({kNut}), {});
  EXPECT_EQ(verdictOf(plan.job.report), PlanVerdict::Passed) << reasons(plan);
  for (const plan::Finding& finding : plan.job.report.findings)
    EXPECT_EQ(finding.kind, plan::FindingKind::PrimeFalls)
        << "the insert carries its roof" << reasons(plan);
  const plan::ToolPlan& paths = *plan.job.toolPlan;
  ASSERT_EQ(paths.inserts.size(), 1u);
  EXPECT_EQ(paths.inserts[0].layer, 10) << "from 0";
  EXPECT_NEAR(geometry::volume(*paths.inserts[0].body) / 480.0, 1.0, 1e-6);
  const auto pauses = pausesOf(plan);
  ASSERT_EQ(pauses.size(), 1u);
  EXPECT_EQ(pauses[0].text, "Put in M3 nut (layer 11 of 20, z 8.80 mm)");
  std::size_t inRoom = 0;
  for (std::size_t w = 0; w < paths.waypointCount(); ++w)
    if (paths.position[w].head<2>().cwiseAbs().maxCoeff() < 4.5 && paths.position[w].z() > 3.3 &&
        paths.position[w].z() < 8.1)
      ++inRoom;
  EXPECT_EQ(inRoom, 0u) << "waypoints in the room";
}

TEST(InsertPlan, CarriesTheLayersAboveItWithoutColumns) {
  const PlanResult without = planPart(requestWith({kNut + ";use=cut"}, {{"supports", "auto"}}), {}),
                   with = planPart(requestWith({kNut}, {{"supports", "auto"}}), {});
  const auto columns = [](const PlanResult& plan) {
    return std::ranges::count(plan.job.toolPlan->paths, plan::PathKind::Support,
                              &plan::ToolPath::kind);
  };
  EXPECT_GT(columns(without), 0);
  EXPECT_EQ(columns(with), 0);
  EXPECT_EQ(verdictOf(with.job.report), PlanVerdict::Passed) << reasons(with);
  EXPECT_LT(with.checked.at(0)->verdict.unsupportedFraction, 1e-3);
}

// It stands 20 above the layer before which it is put in: the head cannot print beside it.
TEST(InsertPlan, ATallInsertKeepsTheHeadAway) {
  const PlanResult plan =
      planPart(requestWith({"box:0,0,13.6,10,10,20.8;use=insert:5;name=Pin"}), {});
  ASSERT_EQ(plan.job.toolPlan->inserts.size(), 1u);
  EXPECT_EQ(plan.job.toolPlan->inserts[0].layer, 4);
  EXPECT_NE(verdictOf(plan.job.report), PlanVerdict::Passed);
  EXPECT_THAT(reasons(plan), testing::HasSubstr("printed material"));
}

TEST(InsertPlan, TellsWhatDoesNotFit) {
  for (const auto& [region, reason] : std::vector<std::pair<std::string, std::string>>{
           {"box:0,0,5.6,10,10,4.8;use=insert:15", "beads lie above its place"},
           {"box:0,0,12,10,10,40;use=insert", "nothing is printed after it"},
           {"box:0,0,5.6,10,10,4.8;use=insert:99", "nothing is printed after it"},
           {"box:0,0,0,10,10,8;use=insert", "it reaches below the plate"},
           {"box:0,0,6,10,10,0.3;use=insert", "it is thinner than a layer"},
           {"box:0,0,10,10,10,4;use=insert:3", "nothing is below it"}}) {
    PlanRequest request = requestWith({region});
    request.until = project::Stage::Toolpath;
    const PlanResult plan = planPart(request, {});
    EXPECT_THAT(reasons(plan), testing::HasSubstr(reason)) << region;
    EXPECT_TRUE(std::ranges::any_of(plan.job.report.findings, [](const plan::Finding& finding) {
      return finding.kind == plan::FindingKind::InsertMisplaced && finding.blocking;
    })) << region;
  }
}

TEST(InsertPlan, TwoTakeNoPlaceTogetherButMayStandOnEachOther) {
  const std::string low = "box:0,0,4.8,10,10,3.2;use=insert;name=Low";
  for (const auto& [high, isTold] : std::vector<std::pair<std::string, bool>>{
           {"box:3,0,5.6,10,10,4.8;use=insert", true}, {"box:0,0,8,10,10,3.2;use=insert", false}}) {
    PlanRequest request = requestWith({low, high});
    request.until = project::Stage::Toolpath;
    const std::string told = reasons(planPart(request, {}));
    EXPECT_EQ(told.find("it takes the place of Low") != std::string::npos, isTold) << told;
    EXPECT_EQ(told.find("nothing is below it"), std::string::npos) << told;
  }
}

// It says that it has no effect, and has none.
TEST(InsertPlan, OutsideThePartItDoesNotStopThePrint) {
  const PlanResult plan = planPart(requestWith({"box:60,0,4,6,6,3;use=insert;name=Far"}), {});
  EXPECT_TRUE(plan.job.toolPlan->inserts.empty());
  EXPECT_TRUE(pausesOf(plan).empty());
  EXPECT_THAT(reasons(plan), testing::HasSubstr("outside the part"));
}

TEST(InsertPlan, ANewNameIsSaidAtOnce) {
  StageCache cache;
  PlanRequest request = requestWith({kNut});
  request.until = project::Stage::Motion;
  EXPECT_EQ(pausesOf(planPart(request, {}, &cache)).at(0).text.substr(0, 13), "Put in M3 nut");
  request.choices.item().regions[0].name = "Magnet";
  const PlanResult plan = planPart(request, {}, &cache);
  EXPECT_EQ(pausesOf(plan).at(0).text.substr(0, 13), "Put in Magnet");
  EXPECT_EQ(plan.job.toolPlan->inserts.at(0).name, "Magnet");
}

TEST(InsertPlan, IsKeptInAProject) {
  const PlanResult plan = planPart(requestWith({kNut}), {});
  test::TemporaryFolder folder;
  project::writeJob(folder / "nut.voluta", plan.job);
  const project::Job read = project::readJob(folder / "nut.voluta", allParameters());
  ASSERT_EQ(read.toolPlan->inserts.size(), 1u);
  const plan::Insert &was = plan.job.toolPlan->inserts[0], &now = read.toolPlan->inserts[0];
  EXPECT_EQ(now.name, "M3 nut");
  EXPECT_EQ(now.layer, was.layer);
  EXPECT_EQ(now.body->vertices, was.body->vertices);
  EXPECT_EQ(now.body->triangles, was.body->triangles);
}

// Two in one stop, and the user's own pause before the same layer.
TEST(InsertPlan, OnePauseIsForAllThatIsPutInThere) {
  const PlanResult plan = planPart(requestWith({"box:-8,0,5.6,6,6,4.8;use=insert;name=A",
                                                "box:8,0,5.6,6,6,4.8;use=insert;name=B"},
                                               {{"layerEvents", "11 pause Check"}}),
                                   {});
  EXPECT_EQ(plan.job.toolPlan->inserts.size(), 2u);
  const auto pauses = pausesOf(plan);
  ASSERT_EQ(pauses.size(), 1u);
  EXPECT_EQ(pauses[0].text, "Check / Put in A / Put in B (layer 11 of 20, z 8.80 mm)");
}

} // namespace
} // namespace voluta::pipeline
