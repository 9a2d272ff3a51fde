// Beads of glue along the seam of a body (Castelli 7.1), from the mesh to the replayed program.
#include "base/error.h"
#include "helpers/given_parameters.h"
#include "layers/layer_stack.h"
#include "pipeline/checked_program.h"
#include "pipeline/road.h"
#include "plan/tool_plan.h"

#include "base/run_context.h"
#include "base/units.h"
#include "pipeline/plan_reasons.h"
#include "plan/finding_kinds.h"
#include "plan/waypoints.h"
#include "project/loaded_part.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <gtest/gtest.h>

namespace voluta::pipeline {
namespace {

using test::reasons;

using Eigen::Vector2d;

// A body on z = 0 with an elliptic outline, as high as a function of the place in it.
geometry::TriangleMesh bodyOver(const Vector2d& halves, int rings, int sides,
                                const std::function<double(double share)>& height) {
  geometry::TriangleMesh mesh;
  mesh.vertices.emplace_back(0, 0, height(0.0));
  for (int r = 1; r <= rings; ++r)
    for (int k = 0; k < sides; ++k) {
      const double angle = base::kTwoPi * k / sides, share = static_cast<double>(r) / rings;
      mesh.vertices.emplace_back(halves.x() * share * std::cos(angle),
                                 halves.y() * share * std::sin(angle), height(share));
    }
  const int last = 1 + (rings - 1) * sides, foot = 1 + rings * sides;
  for (int k = 0; k < sides; ++k) {
    const Eigen::Vector3d rim = mesh.vertices[static_cast<std::size_t>(last + k)];
    mesh.vertices.emplace_back(rim.x(), rim.y(), 0.0);
  }
  const int middle = static_cast<int>(mesh.vertices.size());
  mesh.vertices.emplace_back(0, 0, 0);
  for (int k = 0; k < sides; ++k) {
    const int next = (k + 1) % sides;
    mesh.triangles.push_back({0, 1 + k, 1 + next});
    for (int r = 0; r <= rings - 1; ++r) {
      const int a = 1 + r * sides + k, b = 1 + r * sides + next;
      mesh.triangles.push_back({a, a + sides, b + sides});
      mesh.triangles.push_back({a, b + sides, b});
    }
    mesh.triangles.push_back({foot + next, foot + k, middle});
  }
  return mesh;
}

PlanRequest tracedRequest(geometry::TriangleMesh body) {
  setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1);
  PlanRequest request;
  request.item().loaded = project::loadedFrom(
      "upper.stl", std::make_shared<geometry::TriangleMesh>(std::move(body)), {}, true, {});
  request.choices.tools = {{"glue-3"}};
  request.choices.cell = "ur5-moving";
  request.choices.formats = {"urscript"};
  request.choices.item().mode = "trace";
  test::giveParameters(request.choices, {{"output.proof", "false"}});
  return request;
}

// The length of the beads' middles that are no waste.
double tracedMm(const plan::ToolPlan& plan) {
  double length = 0.0;
  for (const plan::ToolPath& path : plan.paths)
    for (std::size_t i = path.first + 1; i < path.first + path.count && !plan::isWaste(path.kind);
         ++i)
      length += (plan.position[i] - plan.position[i - 1]).norm();
  return length;
}

// The outline of a spherical cap at 35 deg is a circle of radius R sin 35 deg; the nozzle is one
// bead's height above it.
TEST(TracedPlans, TheSeamOfACapIsACircle) {
  const double radius = 50.0, rim = 40.0;
  const PlanResult plan = planPart(
      tracedRequest(bodyOver({rim, rim}, 60, 180,
                             [&](double share) {
                               return std::sqrt(radius * radius - std::pow(rim * share, 2)) - 25.0;
                             })),
      {});
  ASSERT_EQ(plan.checked.size(), 1u) << reasons(plan);
  EXPECT_TRUE(plan.checked[0]->verdict.passed) << reasons(plan);
  const double length = base::kTwoPi * (radius + 0.8) * std::sin(base::degreesToRadians(35.0));
  EXPECT_NEAR(tracedMm(*plan.job.toolPlan), length, 0.01 * length);
  // Hot glue does not drop on the body, above which the nozzle is at home.
  EXPECT_TRUE(plan::purgesFirst(*plan.job.trajectory));
  for (const plan::Finding& finding : plan.job.report.findings)
    EXPECT_NE(finding.kind, plan::FindingKind::PurgeOnPart);
}

// The crown of an upper, 180 mm long.
TEST(TracedPlans, AnUpperHasTwoSeams) {
  PlanRequest request = tracedRequest(bodyOver(
      {90.0, 38.0}, 90, 240, [](double share) { return 45.0 - 18.0 * std::pow(share, 6); }));
  request.choices.item().parameters["tracePasses"] = "2";
  request.choices.item().parameters["traceSpacing"] = "6";
  const PlanResult plan = planPart(request, {});
  ASSERT_EQ(plan.checked.size(), 1u) << reasons(plan);
  EXPECT_TRUE(plan.checked[0]->verdict.passed) << reasons(plan);
  EXPECT_EQ(plan.job.items[0].layers->patches.size(), 2u);
}

// The same crown with a pass on its side, lines at heel and toe, and the force words of both
// controllers that have them, each on its own arm. A smaller upper is in reach of the RV-2F.
TEST(TracedPlans, AnUpperIsGluedOnItsSideAndAtItsEnds) {
  struct Controller {
    const char *cell, *format, *on, *off;
    double scale;
    std::size_t lines; // for which both ends have room
  };
  for (const Controller& c :
       {Controller{"ur5-moving", "urscript", "force_mode(tool_pose()", "end_force_mode()", 1.0, 4},
        Controller{"rv2f-moving", "melfa", "P_FsFCd0=(0,0,5,0,0,0)(0,0)", "Fsc Off", 0.5, 2}}) {
    PlanRequest request =
        tracedRequest(bodyOver({c.scale * 90.0, c.scale * 38.0}, 90, 240, [&](double share) {
          return c.scale * (45.0 - 18.0 * std::pow(share, 6));
        }));
    request.choices.cell = c.cell;
    request.choices.formats = {c.format};
    auto& parameters = request.choices.item().parameters;
    parameters["traceSpacing"] = "6";
    parameters["traceSidePasses"] = "1";
    parameters["traceSideDepth"] = "3";
    parameters["traceFillLines"] = "2";
    const PlanResult plan = planPart(request, {});
    ASSERT_EQ(plan.checked.size(), 1u) << reasons(plan);
    EXPECT_TRUE(plan.checked[0]->verdict.passed) << c.format << "\n" << reasons(plan);
    ASSERT_FALSE(plan.checked[0]->program.files.empty());
    const std::string& text = plan.checked[0]->program.files.front().text;
    EXPECT_NE(text.find(c.on), std::string::npos);
    EXPECT_NE(text.find(c.off), std::string::npos);
    EXPECT_EQ(plan.job.items[0].layers->patches.size(), 1u + 1u + c.lines) << c.format;
  }
}

// Force is an option: without its statements the arm follows the seam by position, as the source
// drove it on a TM5.
TEST(TracedPlans, AFormatWithoutForceWordsIsWrittenWithoutForce) {
  PlanRequest request = tracedRequest(bodyOver({40.0, 30.0}, 20, 90, [](double) { return 10.0; }));
  request.choices.cell = "tm5-moving";
  request.choices.formats = {"tmscript"};
  const PlanResult plan = planPart(request, {});
  ASSERT_EQ(plan.checked.size(), 1u) << reasons(plan);
  EXPECT_TRUE(plan.checked[0]->verdict.passed) << reasons(plan);
  const auto without = std::ranges::find(plan.job.report.findings, plan::FindingKind::WithoutForce,
                                         &plan::Finding::kind);
  ASSERT_NE(without, plan.job.report.findings.end()) << reasons(plan);
  EXPECT_FALSE(without->blocking);
}

TEST(TracedPlans, WithoutAGentleSurfaceTheReasonIsGiven) {
  const PlanRequest request =
      tracedRequest(bodyOver({20.0, 20.0}, 10, 60, [](double s) { return 80.0 - 70.0 * s; }));
  try {
    planPart(request, {});
    FAIL();
  } catch (const base::Error& error) {
    EXPECT_NE(std::string(error.what()).find("35"), std::string::npos) << error.what();
  }
}

} // namespace
} // namespace voluta::pipeline
