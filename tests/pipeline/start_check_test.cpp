// Faults that make a plan pointless are found before it is made, in every mode.
#include "base/parameters.h"
#include "helpers/shapes.h"
#include "helpers/temporary_folder.h"
#include "pipeline/compare.h"
#include "pipeline/remedies.h"
#include "pipeline/road.h"
#include "plan/finding_kinds.h"
#include "project/loaded_part.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <gtest/gtest.h>

using namespace voluta;
using plan::FindingKind;

namespace {

pipeline::PlanRequest requestOf(const geometry::TriangleMesh& part, bool automatic) {
  pipeline::PlanRequest request;
  request.item().loaded =
      project::loadedFrom("part.stl", std::make_shared<geometry::TriangleMesh>(part), {}, true, {});
  request.choices.item().automatic = automatic;
  request.choices.item().platform = project::Platform("cell");
  return request;
}

const plan::Finding* findingOf(const pipeline::PlanResult& result, FindingKind kind) {
  const auto& all = result.job.report.findings;
  const auto found = std::ranges::find(all, kind, &plan::Finding::kind);
  return found == all.end() ? nullptr : &*found;
}

// The plan ends with its first stage, and every button gets on with it.
void expectReported(const pipeline::PlanRequest& request, FindingKind kind) {
  const pipeline::PlanResult result = pipeline::planPart(request, {});
  ASSERT_TRUE(result.job.reached);
  EXPECT_EQ(*result.job.reached, project::Stage::Load);
  EXPECT_FALSE(pipeline::nothingBlocks(result.job.report));
  const plan::Finding* finding = findingOf(result, kind);
  ASSERT_NE(finding, nullptr);
  const auto offers = pipeline::remediesFor(*finding, request.choices);
  EXPECT_FALSE(offers.empty());
  for (const pipeline::RemedyAction& offer : offers) {
    pipeline::PlanRequest cured = request;
    cured.choices = offer.choices;
    cured.choices.item().automatic = false; // the way does not matter here
    cured.until = project::Stage::Load;
    EXPECT_EQ(findingOf(pipeline::planPart(cured, {}), kind), nullptr) << offer.remedy->name;
  }
}

// A nozzle with a barrel as wide as the hall.
class StartCheck : public ::testing::Test {
protected:
  void SetUp() override {
    setenv("VOLUTA_DATA", folder_.path().c_str(), 1);
    std::filesystem::create_directories(folder_.path() / "processes");
    std::ofstream(folder_.path() / "processes" / "barrel.json") << R"({
      "id": "barrel", "label": "Barrel", "nozzleDiameterMm": 1.0,
      "layerHeightMm": { "default": 0.8, "min": 0.4, "max": 1.0 },
      "beadWidthMm": { "default": 1.2, "min": 1.0, "max": 2.0 },
      "stepMm": 1.0, "speedMmPerS": 20.0, "travelSpeedMmPerS": 100.0,
      "accelerationMmPerS2": 500.0, "contactToleranceMm": 0.4, "bridgeMm": 6.0,
      "bridgeSpeedMmPerS": 10.0, "maxFlowMm3PerS": 40.0, "primeS": 0.2, "material": "PLA",
      "densityGPerCm3": 1.24,
      "head": [[0.0, 0.9], [20.0, 6.0], [20.0, 600.0], [900.0, 600.0]]
    })";
  }
  void TearDown() override { unsetenv("VOLUTA_DATA"); }

private:
  test::TemporaryFolder folder_;
};

TEST_F(StartCheck, AnArmThatCannotMoveWithItsHead) {
  for (const bool automatic : {false, true})
    for (const char* platform : {"cell", "fit:10"}) {
      SCOPED_TRACE(std::string(automatic ? "auto, " : "by hand, ") + platform);
      pipeline::PlanRequest request = requestOf(test::box({0, 0, 0}, {20, 20, 5}), automatic);
      request.choices.tool().process = "barrel";
      request.choices.item().platform = project::Platform(platform);
      expectReported(request, FindingKind::CellCannotPrint);
    }
}

TEST_F(StartCheck, APartLargerThanEveryPlate) {
  for (const bool automatic : {false, true}) {
    SCOPED_TRACE(automatic ? "auto" : "by hand");
    expectReported(requestOf(test::box({0, 0, 0}, {300, 300, 20}), automatic),
                   FindingKind::LargerThanPlates);
  }
}

// Drawn in thousandths of a millimetre.
TEST_F(StartCheck, OffersASmallerScaleForAnySize) {
  pipeline::PlanRequest request = requestOf(test::box({0, 0, 0}, {60000, 60000, 4000}), false);
  request.choices.item().scale = "0.005";
  expectReported(request, FindingKind::LargerThanPlates);
  const pipeline::PlanResult result = pipeline::planPart(request, {});
  const plan::Finding* reported = findingOf(result, FindingKind::LargerThanPlates);
  ASSERT_NE(reported, nullptr);
  const auto offers = pipeline::remediesFor(*reported, request.choices);
  const auto smaller =
      std::ranges::find(offers, plan::RemedyId::ScaleToPlate,
                        [](const pipeline::RemedyAction& o) { return o.remedy->id; });
  ASSERT_NE(smaller, offers.end());
  const double scale = project::parsedScale(smaller->choices.item().scale);
  EXPECT_LT(scale, 0.005);
  request.choices.item().scale = smaller->choices.item().scale;
  request.until = project::Stage::Load;
  const double width = pipeline::planPart(request, {}).job.report.item().model.boundsMm.sizes().x();
  request.choices.item().scale = base::formatParameter(1.01 * scale);
  EXPECT_NE(findingOf(pipeline::planPart(request, {}), FindingKind::LargerThanPlates), nullptr)
      << width << " mm: a hundredth larger no plate carries it";
}

TEST_F(StartCheck, PassesPartsThatFitInAnyWay) {
  const auto reported = [](const pipeline::PlanRequest& given) {
    pipeline::PlanRequest request = given;
    request.until = project::Stage::Load;
    return findingOf(pipeline::planPart(request, {}), FindingKind::LargerThanPlates) != nullptr;
  };
  EXPECT_FALSE(reported(requestOf(test::box({0, 0, 0}, {150, 150, 5}), false))) << "a small one";
  pipeline::PlanRequest insists = requestOf(test::box({0, 0, 0}, {300, 300, 20}), true);
  insists.choices.item().platform = project::Platform("fit:5");
  insists.choices.item().platformStays = true;
  EXPECT_FALSE(reported(insists)) << "the user wants a platform made for it";
  pipeline::PlanRequest turned = requestOf(test::box({0, 0, 0}, {500, 100, 5}), false);
  turned.choices.cell = "kr10-r1100-slide"; // 300 by 1200
  EXPECT_FALSE(reported(turned)) << "turned by a right angle it is carried";
}

TEST_F(StartCheck, CountsInComparisonsToo) {
  pipeline::CompareOptions options;
  options.plan = requestOf(test::box({0, 0, 0}, {300, 300, 20}), false);
  options.modes = {"flat", "curved"};
  options.platforms = {project::Platform("cell")};
  const pipeline::Comparison comparison = pipeline::compare(options, {});
  ASSERT_FALSE(comparison.rows.empty());
  for (const pipeline::CompareRow& row : comparison.rows) {
    EXPECT_EQ(row.reached, project::Stage::Load);
    EXPECT_EQ(row.state(), pipeline::RowState::Blocked);
  }
}

} // namespace
