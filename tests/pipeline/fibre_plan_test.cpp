// Parts with tapes of continuous fibre from the mesh to the replayed program (Dai 5.4).
#include "helpers/given_parameters.h"
#include "pipeline/checked_program.h"
#include "pipeline/road.h"
#include "plan/tool_plan.h"
#include "plan/trajectory.h"

#include "base/error.h"
#include "base/files.h"
#include "base/run_context.h"
#include "geometry/formats/mesh_reader.h"
#include "helpers/temporary_folder.h"
#include "pipeline/plan_reasons.h"
#include "project/specimens.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>

namespace voluta::pipeline {
namespace {

using test::reasons;

using Values = std::map<std::string, std::string>;

PlanRequest fibreRequest(const char* sample, const char* mode, const Values& values) {
  setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1);
  PlanRequest request;
  request.item().part = sample;
  request.choices.tools = {{"fdm-1.0"}, {"tape-5"}};
  request.choices.cell = "irb2400-moving";
  request.choices.formats = {"gcode-extended"};
  request.choices.item().mode = mode;
  test::giveParameters(request.choices, values);
  request.choices.parameters["fibreLayers"] = "1";
  request.choices.parameters["output.proof"] = "false";
  return request;
}

std::size_t eventsOf(const plan::Trajectory& trajectory, plan::EventKind kind) {
  return static_cast<std::size_t>(
      std::ranges::count(trajectory.events, kind, &plan::TrajectoryEvent::kind));
}

// Checks every example: tapes of that length, each cut, as many grams as planned.
void expectTapes(const PlanResult& plan, std::size_t tapes, double lengthMm) {
  const plan::ToolpathStatistics& s = plan.job.report.toolpath;
  EXPECT_EQ(s.tapes, tapes);
  EXPECT_NEAR(s.tapeMm, static_cast<double>(tapes) * lengthMm,
              0.005 * static_cast<double>(tapes) * lengthMm);
  EXPECT_GE(s.tapeCoveredFraction, 0.9);
  EXPECT_EQ(s.tapeBareMm, 0.0);
  ASSERT_EQ(plan.checked.size(), 1u);
  const project::ReplayReport& verdict = plan.checked[0]->verdict;
  EXPECT_TRUE(plan.checked[0]->verdict.passed) << reasons(plan);
  EXPECT_NEAR(verdict.tapeMm3, s.tapeMm * 5.0 * 0.08, 0.002 * verdict.tapeMm3);
  EXPECT_EQ(eventsOf(*plan.job.trajectory, plan::EventKind::Cut), tapes);
  EXPECT_EQ(eventsOf(*plan.job.trajectory, plan::EventKind::ToolChange), 2 * tapes);
}

TEST(FibrePlans, ADumbbellWithFiveTapes) {
  expectTapes(
      planPart(fibreRequest("sample:dumbbell", "flat",
                            {{"layerHeightMm", "0.5"}, {"fibreCount", "1"}, {"fibreEndMm", "7.5"}}),
               {}),
      5, 150.0);
}

TEST(FibrePlans, ABarWithNineTapes) {
  expectTapes(
      planPart(fibreRequest("sample:bar", "flat",
                            {{"layerHeightMm", "0.5"}, {"fibreCount", "1"}, {"fibreEndMm", "5"}}),
               {}),
      9, 240.0);
}

TEST(FibrePlans, APlateWithAHole) {
  const PlanResult plan =
      planPart(fibreRequest("sample:plate", "flat", {{"layerHeightMm", "0.6"}}), {});
  const plan::ToolpathStatistics& s = plan.job.report.toolpath;
  EXPECT_GT(s.tapes, 4u * 12u) << "those beside the hole are whole, the others in two pieces";
  EXPECT_GE(s.tapeCoveredFraction, 0.9);
  EXPECT_TRUE(plan.checked.at(0)->verdict.passed) << reasons(plan);
  EXPECT_NEAR(plan.checked[0]->verdict.tapeMm3, s.tapeMm * 5.0 * 0.08, 0.002 * s.tapeMm * 0.4);
}

// Seven layers on a mould, with six tapes between.
TEST(FibrePlans, ACurvedBarOnItsMould) {
  const test::TemporaryFolder folder;
  base::writeFile(folder / "mould.stl", geometry::writeStl(project::mouldOfCurvedSpecimen()));
  PlanRequest request =
      fibreRequest("sample:curved-bar", "substrate",
                   {{"layerHeightMm", "0.6"}, {"fibreCount", "1"}, {"fibreEndMm", "5.3"}});
  request.choices.item().platform = project::Platform("mesh:" + (folder / "mould.stl").string());
  const PlanResult plan = planPart(request, {});
  const plan::ToolpathStatistics& s = plan.job.report.toolpath;
  EXPECT_EQ(plan.job.report.item().layers.count, 7);
  EXPECT_EQ(s.tapes, 6u);
  EXPECT_GE(s.tapeMm, 6 * 68.0);
  EXPECT_LE(s.tapeMm, 6 * 73.0) << "longer on the outer layers";
  EXPECT_EQ(s.tapeBareMm, 0.0);
  EXPECT_TRUE(plan.checked.at(0)->verdict.passed) << reasons(plan);
  // Normal to the surface: the axis of its cylinder is y, as in the sample's frame, raised.
  const plan::ToolPlan& toolPlan = *plan.job.toolPlan;
  for (const plan::ToolPath& path : toolPlan.paths)
    if (path.kind == plan::PathKind::Tape) {
      const std::size_t last = path.first + path.count - 1;
      const double angle = std::acos(toolPlan.direction[path.first].dot(toolPlan.direction[last]));
      double length = 0.0;
      for (std::size_t w = path.first + 1; w <= last; ++w)
        length += (toolPlan.position[w] - toolPlan.position[w - 1]).norm();
      const double radius = 60.0 + 0.6 * (path.layer + 1) + 0.08;
      EXPECT_NEAR(length / angle, radius, 0.02 * radius);
    }
}

TEST(FibrePlans, ATapeToolPrintsNoPart) {
  PlanRequest request = fibreRequest("sample:bar", "flat", {});
  request.choices.tools = {{"tape-5"}};
  EXPECT_THROW(planPart(request, {}), base::Error);
  request.choices.tools = {{"fdm-1.0"}};
  EXPECT_THROW(planPart(request, {}), base::Error) << "no tool lays tape";
}

} // namespace
} // namespace voluta::pipeline
