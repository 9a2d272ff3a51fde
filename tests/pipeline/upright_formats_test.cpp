// Formats that cannot tilt the nozzle: known before tool-paths are planned.
#include "base/error.h"
#include "helpers/shapes.h"
#include "modes/mode_table.h"
#include "pipeline/automatic.h"
#include "pipeline/road.h"
#include "pipeline/stage_options.h"
#include "program/dialect.h"

#include <algorithm>
#include <gtest/gtest.h>

using namespace voluta;

namespace {

// Tool-paths of a ball of 20 mm, which is unsupported below.
plan::ToolPlan ballIn(const std::string& mode, const std::string& format) {
  pipeline::PlanRequest request;
  // On its side, between two meridians, its first layers have rims that lean.
  geometry::TriangleMesh ball = test::sphere(Eigen::Vector3d::Zero(), 10.0, 15);
  for (Eigen::Vector3d& v : ball.vertices)
    v = Eigen::Vector3d(v.z(), v.y(), 10.0 - v.x());
  request.item().loaded = project::loadedFrom(
      "ball.stl", std::make_shared<const geometry::TriangleMesh>(std::move(ball)), {}, true, {});
  request.choices.tool().process = "fdm-0.4";
  request.choices.item().mode = mode;
  request.choices.formats = {format};
  request.until = project::Stage::Toolpath;
  return *pipeline::planPart(request, base::RunContext()).job.toolPlan;
}

double maxTiltDeg(const plan::ToolPlan& plan) {
  double minimum = 1.0;
  for (const Eigen::Vector3d& direction : plan.direction)
    minimum = std::min(minimum, direction.z());
  return std::acos(minimum) * 180.0 / 3.14159265358979;
}

TEST(UprightFormats, FlatLayersStayUprightForThem) {
  EXPECT_GT(maxTiltDeg(ballIn("flat", "urscript")), 5.0) << "supports under rims lean";
  const plan::ToolPlan upright = ballIn("flat", "gcode");
  EXPECT_LT(maxTiltDeg(upright), 0.01);
  EXPECT_TRUE(std::ranges::any_of(upright.paths, [](const plan::ToolPath& path) {
    return path.kind == plan::PathKind::Support;
  })) << "rims that an upright nozzle reaches are supported";
}

TEST(UprightFormats, TiltedLayersAreRefusedBeforeTheyAreCovered) {
  try {
    ballIn("curved", "gcode");
    FAIL() << "curved layers without a tilt";
  } catch (const base::Error& error) {
    EXPECT_NE(std::string(error.what()).find("cannot tilt the nozzle"), std::string::npos);
  }
}

TEST(UprightFormats, ModeAutoTriesUprightWaysOnly) {
  project::Choices choices;
  choices.item().automatic = true;
  choices.formats = {"gcode"};
  const auto ways = pipeline::automaticChoices(choices);
  ASSERT_FALSE(ways.empty());
  for (const project::Choices& strategy : ways)
    EXPECT_TRUE(modes::findMode(strategy.item().mode).upright) << strategy.item().mode;
}

} // namespace
