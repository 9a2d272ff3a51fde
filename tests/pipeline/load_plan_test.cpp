// Parts that are held and pushed: beads along the stress, from the regions to the report.
#include "base/error.h"
#include "base/units.h"
#include "box_request.h"
#include "helpers/given_parameters.h"
#include "helpers/loaded_box.h"
#include "helpers/made_solids.h"
#include "helpers/shapes.h"
#include "pipeline/checked_program.h"
#include "pipeline/compare_figures.h"
#include "pipeline/plan_reasons.h"
#include "pipeline/road.h"
#include "plan/finding_kinds.h"
#include "plan/tool_plan.h"
#include "process/own_materials.h"
#include "project/job.h"
#include "project/report.h"
#include "regions/region_text.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace voluta::pipeline {
namespace {

using Eigen::Vector3d;
using test::reasons;
using test::operator+;

const std::vector<std::string> kBending{"box:-42,0,2,6,20,4;use=hold",
                                        "box:42,0,2,6,20,4;use=load:0,-20,0"};

PlanRequest bar(const std::vector<std::string>& regions, const std::string& infill) {
  PlanRequest request;
  request.item().loaded = test::loadedBox({-45, -10, 0}, {45, 10, 4});
  request.choices.item().mode = "flat";
  request.choices.formats = {"gcode-extended"};
  test::giveParameters(request.choices, {{"infill", infill}});
  for (const std::string& text : regions)
    request.choices.item().regions.push_back(regions::parsedRegion(text, {}));
  request.until = project::Stage::Toolpath;
  return request;
}

TEST(LoadPlan, FieldInfillRunsAlongTheStressOfABentBar) {
  const PlanResult zigzag = planPart(bar(kBending, "zigzag"), {}),
                   field = planPart(bar(kBending, "field"), {});
  const plan::LoadStatistics &before = zigzag.job.report.toolpath.load,
                             &after = field.job.report.toolpath.load;
  EXPECT_EQ(after.forceN, 20.0);
  EXPECT_GE(after.infillAlignedFraction, 2.0 * before.infillAlignedFraction);
  EXPECT_GT(after.alignedFraction, before.alignedFraction);
  EXPECT_GT(after.stiffnessNPerMm, before.stiffnessNPerMm);
  EXPECT_LT(after.acrossBeadsMPa, 0.7 * before.acrossBeadsMPa);
  EXPECT_GE(field.job.report.toolpath.coveredFraction, 0.985);
  // Euler and Bernoulli, between the moduli across and along.
  const double bending = std::pow(20.0, 3) * 4.0 / 12.0 * 3.0 / std::pow(81.0, 3);
  EXPECT_GT(after.stiffnessNPerMm, 0.8 * 2770.0 * bending);
  EXPECT_LT(after.stiffnessNPerMm, 1.1 * 3120.0 * bending);
}

// A post that stands is bent: its layers would be torn apart. Lying, they are not.
TEST(LoadPlan, ThePartIsTurnedToTheLeastTensionAcrossItsLayers) {
  PlanRequest request =
      bar({"box:0,0,2,20,20,4;use=hold", "box:0,0,58,20,20,4;use=load:20,0,0"}, "zigzag");
  request.item().loaded = test::loadedBox({-6, -4, 0}, {6, 4, 60});
  request.until = project::Stage::Load;
  test::giveParameters(request.choices, {{"orient", "leastTension"}});
  const PlanResult plan = planPart(request, {});
  const Eigen::Vector3d axis = plan.job.item().placement->rotation * Eigen::Vector3d::UnitZ();
  EXPECT_LT(std::abs(axis.z()), 0.1) << reasons(plan);
  const auto turned = std::ranges::find(
      plan.job.report.findings, plan::FindingKind::TurnedLeastTension, &plan::Finding::kind);
  ASSERT_NE(turned, plan.job.report.findings.end()) << reasons(plan);
  const auto value = [&](const std::string& name) {
    return std::get<base::Quantity>(turned->value(name)->data()).number;
  };
  EXPECT_LT(value("tension"), 0.3 * value("tensionBefore"));
  // Bending: the stress falls from M / W at the hold, half of the section is in tension.
  const double most = 20.0 * 56.0 / (8.0 * 12.0 * 12.0 / 6.0);
  EXPECT_NEAR(value("tensionBefore") / (most / std::sqrt(18.0)), 1.0, 0.15);
  request.choices.item().regions.pop_back();
  EXPECT_THROW(planPart(request, {}), base::Error);
}

TEST(LoadPlan, AForceTurnsWithThePart) {
  PlanRequest request = bar(kBending, "field");
  const double straight = planPart(request, {}).job.report.toolpath.load.stiffnessNPerMm;
  request.choices.item().placement.rotation = Eigen::AngleAxisd(0.5 * base::kPi, Vector3d::UnitZ());
  const double turned = planPart(request, {}).job.report.toolpath.load.stiffnessNPerMm;
  EXPECT_NEAR(turned, straight, 0.05 * straight);
}

TEST(LoadPlan, AGivenDirectionNeedsNoLoad) {
  PlanRequest request = bar({}, "field");
  test::giveParameters(request.choices, {{"infill", "field"}, {"infillField", "1,0.2,0"}});
  const PlanResult result = planPart(request, {});
  const plan::ToolPlan& plan = *result.job.toolPlan;
  const Vector3d along = Vector3d(1, 0.2, 0).normalized();
  double length = 0.0, aligned = 0.0;
  for (const plan::ToolPath& path : plan.paths)
    for (std::size_t i = path.first + 1; i < path.first + path.count; ++i)
      if (path.kind == plan::PathKind::Infill) {
        const Vector3d step = plan.position[i] - plan.position[i - 1];
        length += step.norm();
        aligned += std::abs(step.dot(along)) > std::cos(0.1) * step.norm() ? step.norm() : 0.0;
      }
  EXPECT_GT(aligned, 0.8 * length);
  EXPECT_EQ(result.job.report.toolpath.load.forceN, 0.0);
}

TEST(LoadPlan, WholePlansWithFieldInfillPass) {
  PlanRequest request = bar(kBending, "field");
  request.until = project::Stage::Replay;
  const PlanResult result = planPart(request, {});
  ASSERT_EQ(result.checked.size(), 1u);
  EXPECT_TRUE(result.checked[0]->verdict.passed) << reasons(result);
}

// Expects that the request itself is refused, before anything is planned.
void expectRefused(const PlanRequest& request, const std::string& part) {
  project::Stage made = project::Stage::Load;
  PlanObservers observers;
  observers.onStage = [&](project::Stage stage, const PlanResult&) { made = stage; };
  try {
    planPart(request, {}, nullptr, observers);
    ADD_FAILURE() << part;
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ErrorCode::Usage) << error.what();
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
  EXPECT_EQ(made, project::Stage::Load) << part;
}

TEST(LoadPlan, NamesTheHoldTheForceOrTheFieldThatIsMissing) {
  expectRefused(bar({kBending[1]}, "field"), "none that holds");
  expectRefused(bar({kBending[0]}, "field"), "no field of directions");
  expectRefused(bar({}, "field"), "no field of directions");
  expectRefused(bar({kBending[0], "box:42,0,2,6,20,4;use=load:0,0,0"}, "zigzag"), "no direction");
  expectRefused(bar({kBending[0], "box:90,0,2,6,20,4;use=load:0,0,-1"}, "zigzag"),
                "nothing of the part");
  expectRefused(bar({kBending[0], kBending[1] + ";walls=3"}, "zigzag"), "no settings");
}

TEST(LoadPlan, RefusesAFieldThatCannotBeRead) {
  for (const std::string field : {"1,0", "1,0,nan", "0,0,0", "0,0,0,1,0,inf"}) {
    PlanRequest request = bar({}, "field");
    test::giveParameters(request.choices, {{"infill", "field"}, {"infillField", field}});
    expectRefused(request, field);
  }
}

TEST(LoadPlan, RefusesNumbersAsTheyAreWritten) {
  for (const std::string number : {"1e300", "nan", "inf", "-1e7", "x"})
    try {
      regions::parsedRegion("box:42,0,2,6,20,4;use=load:0," + number + ",0", {});
      ADD_FAILURE() << number;
    } catch (const base::Error& error) {
      const std::string what = error.what();
      EXPECT_EQ(error.code(), base::ErrorCode::Usage) << what;
      EXPECT_NE(what.find("FY"), std::string::npos) << what;
      EXPECT_NE(what.find(number), std::string::npos) << what;
      EXPECT_LT(what.size(), 150u) << what;
    }
}

TEST(LoadPlan, NamesThePartThatLacksAField) {
  PlanRequest request = bar(kBending, "field");
  request.item().loaded = test::loadedBox({-45, -10, 0}, {45, 10, 4}, "bar.stl");
  request.items.push_back({});
  request.item(1).loaded = test::loadedBox({-10, -10, 0}, {10, 10, 4}, "cube.stl");
  request.choices.items.push_back(request.choices.items.front());
  request.choices.item(1).regions.clear();
  expectRefused(request, "cube.stl: infillField: there is no field");
}

// The material is unknown to the estimate: a plan with figures that are unknown, not 0.
TEST(LoadPlan, FiguresThatAreUnknownAreNullAndTold) {
  PlanRequest request = bar(kBending, "zigzag");
  request.choices.tool().process = process::processTextWith("fdm-1.0", "petg");
  const PlanResult result = planPart(request, {});
  const plan::LoadStatistics& load = result.job.report.toolpath.load;
  EXPECT_EQ(load.forceN, 20.0);
  EXPECT_GT(load.alignedFraction, 0.0);
  EXPECT_TRUE(std::isnan(load.stiffnessNPerMm));
  EXPECT_NE(reasons(result).find("material PETG states no elasticity"), std::string::npos)
      << reasons(result);
  const std::string json = project::reportJson(result.job.report);
  EXPECT_NE(json.find("\"stiffnessNPerMm\": null"), std::string::npos);
  EXPECT_TRUE(std::isnan(project::readReportJson(json).toolpath.load.stiffnessNPerMm));
}

TEST(LoadPlan, SaysWhereAFieldHasNoEffect) {
  PlanRequest unused = bar({}, "zigzag");
  test::giveParameters(unused.choices, {{"infillField", "1,0.2,0"}});
  EXPECT_NE(reasons(planPart(unused, {})).find("no effect of infillField"), std::string::npos);
  PlanRequest ofRegion = bar({"box:0,0,2,30,30,30;infill=field"}, "zigzag");
  test::giveParameters(ofRegion.choices, {{"infillField", "1,0.2,0"}});
  EXPECT_EQ(reasons(planPart(ofRegion, {})).find("no effect"), std::string::npos);
  PlanRequest upright = bar({}, "field");
  test::giveParameters(upright.choices, {{"infill", "field"}, {"infillField", "0,0,1"}});
  EXPECT_NE(reasons(planPart(upright, {})).find("the field is perpendicular to 5 patches"),
            std::string::npos);
}

TEST(LoadPlan, CompareWeighsTheDeflection) {
  int found = 0;
  for (const Figure& figure : figures())
    if (figure.key == "deflectionMm" || figure.key == "acrossLayersMPa") {
      EXPECT_GT(figure.weight, 0.0);
      ++found;
    }
  EXPECT_EQ(found, 2);
}

} // namespace
} // namespace voluta::pipeline
