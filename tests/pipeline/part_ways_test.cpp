// A badly oriented part: a finding with the best orientation, which its remedy takes.
#include "pipeline/part_ways.h"

#include "base/error.h"
#include "base/units.h"
#include "geometry/measures.h"
#include "helpers/shapes.h"
#include "pipeline/remedies.h"
#include "pipeline/resolved.h"
#include "pipeline/road.h"
#include "pipeline/stage_options.h"
#include "plan/finding_kinds.h"
#include "project/turn_text.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <random>

using namespace voluta;
using pipeline::PlanRequest;
using pipeline::PlanResult;

namespace {

PlanRequest requestOf(const geometry::TriangleMesh& mesh) {
  PlanRequest request;
  request.item().loaded =
      project::loadedFrom("part.stl", std::make_shared<geometry::TriangleMesh>(mesh), {}, true, {});
  request.until = project::Stage::Load;
  return request;
}

const geometry::TriangleMesh kOnEdge = test::box({0, 0, 0}, {50, 6, 40});

const plan::Finding* reportedIn(const PlanResult& result) {
  const plan::Findings& all = result.job.report.findings;
  const auto reported = std::ranges::find(all, plan::FindingKind::LiesBadly, &plan::Finding::kind);
  return reported == all.end() ? nullptr : &*reported;
}

TEST(PartWays, PlateOnItsEdgeGivesAFindingAndItsRemedyTurnsIt) {
  PlanRequest request = requestOf(kOnEdge);
  request.choices.item().placement.liftMm = 2.0;
  const PlanResult result = pipeline::planPart(request, {});
  const plan::Finding* reported = reportedIn(result);
  ASSERT_NE(reported, nullptr);
  EXPECT_FALSE(reported->blocking);
  EXPECT_NE(plan::englishReason(*reported).find("300 mm2"), std::string::npos)
      << plan::englishReason(*reported);
  EXPECT_NE(plan::englishReason(*reported).find("2000 mm2"), std::string::npos);
  const auto offers = pipeline::remediesFor(*reported, request.choices);
  ASSERT_EQ(offers.size(), 1u);
  EXPECT_EQ(offers[0].remedy->id, plan::RemedyId::StandBest);
  request.choices = offers[0].choices;
  const PlanResult planResult = pipeline::planPart(request, {});
  EXPECT_EQ(reportedIn(planResult), nullptr);
  EXPECT_NEAR(geometry::bounds(*planResult.job.item().part).sizes().z(), 6.0, 1e-3);
  EXPECT_NEAR(geometry::bounds(*planResult.job.item().part).min().z(), 0.0, 1e-9) << "on the plate";
}

TEST(PartWays, RemedyDoesNotDependOnTheFormerOrientation) {
  PlanRequest request = requestOf(kOnEdge);
  request.choices.item().placement.rotation =
      Eigen::AngleAxisd(0.5 * base::kPi, Eigen::Vector3d::UnitY());
  const PlanResult result = pipeline::planPart(request, {});
  ASSERT_NE(reportedIn(result), nullptr);
  // Turned on by hand before the button is pressed.
  request.choices.item().placement.rotation = Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitX());
  request.choices = pipeline::remediesFor(*reportedIn(result), request.choices).at(0).choices;
  EXPECT_NEAR(geometry::bounds(*pipeline::planPart(request, {}).job.item().part).sizes().z(), 6.0,
              1e-3);
}

TEST(PartWays, NoFindingIfASearchOrTheModeOrientsThePart) {
  PlanRequest request = requestOf(kOnEdge);
  request.choices.item().parameters["orient"] = "leastRisky";
  EXPECT_EQ(reportedIn(pipeline::planPart(request, {})), nullptr);
  request = requestOf(kOnEdge);
  request.choices.item().mode = "lathe";
  request.choices.cell = "lathe";
  request.choices.tool().process = "fdm-0.35";
  request.choices.item().platform = project::Platform("rod:5x200");
  EXPECT_FALSE(pipeline::standsFreely(request.choices));
  EXPECT_EQ(reportedIn(pipeline::planPart(request, {})), nullptr);
}

TEST(PartWays, AreOfThePlacedPartAndKeepItsCentre) {
  PlanRequest request = requestOf(kOnEdge);
  request.choices.item().scale = "0.5";
  request.choices.item().placement.centreMm = {8.0, -3.0};
  const PlanResult result = pipeline::planPart(request, {});
  const auto ways = pipeline::partWays(*result.item().placed, result.resolved(), {});
  ASSERT_EQ(ways.size(), 2u) << "on the smallest side it would hardly stand";
  EXPECT_NEAR(ways[0].score.heightMm, 3.0, 1e-6);
  request.choices.item().placement = pipeline::standing(ways[0], result.item().placed->placement);
  const Eigen::AlignedBox3d box =
      geometry::bounds(*pipeline::planPart(request, {}).job.item().part);
  EXPECT_NEAR(box.sizes().z(), 3.0, 1e-9);
  EXPECT_NEAR(box.center().x(), 8.0, 1e-9);
  EXPECT_NEAR(box.center().y(), -3.0, 1e-9);
}

TEST(PartWays, TheirKeyHasAllThatTheyAreMadeFrom) {
  const PlanRequest request = requestOf(kOnEdge);
  const auto keyOf = [&](double scale, const project::Choices& choices) {
    return pipeline::partWaysKey(*request.item().loaded, scale, pipeline::resolve(choices));
  };
  project::Choices choices;
  const std::string key = keyOf(1.0, choices);
  EXPECT_NE(keyOf(2.0, choices), key);
  choices.item().parameters["layerHeightMm"] = "0.6";
  EXPECT_NE(keyOf(1.0, choices), key);
  choices.item().parameters.clear();
  choices.item().parameters["overhangAngle"] = "50";
  EXPECT_NE(keyOf(1.0, choices), key);
  choices.item().parameters.clear();
  choices.item().units = "in";
  EXPECT_NE(keyOf(1.0, choices), key);
  choices.item().units = "mm";
  choices.item().parameters["openSurfaces"] = "thicken";
  const std::string thick = keyOf(1.0, choices);
  EXPECT_NE(thick, key);
  choices.item().parameters["openSurfaces"] = "close";
  EXPECT_NE(keyOf(1.0, choices), key);
  EXPECT_NE(keyOf(1.0, choices), thick);
  choices.item().parameters.clear();
  choices.item().parameters["walls"] = "1";
  choices.item().platform = project::Platform("disc:90");
  EXPECT_EQ(keyOf(1.0, choices), key);
}

// The estimate of a part in its orientation and the time of its plan.
TEST(PartWays, TheirTimesAreThoseOfThePlans) {
  constexpr double kRough = 0.15;
  const auto column = [](double side, double height) {
    return test::box({0, 0, 0}, {side, side, height});
  };
  struct Case {
    geometry::TriangleMesh part;
    std::vector<std::string> parameters;
  };
  for (const auto& [part, parameters] :
       {Case{column(20, 16), {}}, Case{column(24, 24), {"infillDensity=0.2"}},
        Case{column(30, 24), {"spiral=true"}}, Case{column(10, 8), {"minLayerTimeS=30"}}}) {
    PlanRequest request = requestOf(part);
    request.choices.item().automatic = false;
    request.choices.item().mode = "flat";
    request.until = project::Stage::Motion;
    pipeline::setParameters(request.choices, parameters);
    const PlanResult result = pipeline::planPart(request, {});
    const auto ways = pipeline::partWays(*result.item().placed, result.resolved(), {});
    const auto now = std::ranges::find_if(ways, &placement::StandingOrientation::now);
    ASSERT_NE(now, ways.end());
    const double estimate = pipeline::estimatedSeconds(*now, result.resolved());
    const double planned = result.job.report.motion.durationS;
    EXPECT_NEAR(estimate, planned, kRough * planned)
        << (parameters.empty() ? "solid" : parameters.front());
  }
}

TEST(TurnText, IsReadAsItIsWritten) {
  std::mt19937 random(5);
  std::normal_distribution<double> any;
  for (int n = 0; n < 500; ++n) {
    const Eigen::Quaterniond rotation =
        Eigen::Quaterniond(any(random), any(random), any(random), any(random)).normalized();
    EXPECT_LT(project::parsedRotation(project::rotationText(rotation)).angularDistance(rotation),
              5e-5);
  }
  EXPECT_EQ(project::rotationText(Eigen::Quaterniond::Identity()), "0,0,0");
  EXPECT_EQ(project::rotationText(project::parsedRotation("-90,0,0")), "-90,0,0");
  // X first, then Z, about axes that stay.
  EXPECT_LT(
      (project::parsedRotation("90,0,90") * Eigen::Vector3d::UnitY() - Eigen::Vector3d::UnitZ())
          .norm(),
      1e-12);
  for (const char* wrong : {"", "90", "90,0", "90,0,0,0", "a,b,c", "nan,0,0"})
    EXPECT_THROW(project::parsedRotation(wrong), base::Error) << wrong;
}

} // namespace
