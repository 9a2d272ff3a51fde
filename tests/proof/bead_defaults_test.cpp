// A process brings its lengths: parts of wide beads are planned without further settings.
#include "base/data_files.h"
#include "base/error.h"
#include "helpers/loaded_box.h"
#include "pipeline/checked_program.h"
#include "pipeline/road.h"
#include "pipeline/stage_options.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

using namespace voluta;
using namespace voluta::pipeline;

namespace {

// Pellets or paste through a nozzle as wide as the bead is high, a head in proportion.
std::string wideProcess(double widthMm) {
  const double height = 0.5 * widthMm;
  return fmt::format(
      R"({{"id": "wide", "label": "wide beads", "nozzleDiameterMm": {0},
 "layerHeightMm": {{"default": {1}, "min": {2}, "max": {3}}},
 "beadWidthMm": {{"default": {4}, "min": {5}, "max": {6}}},
 "stepMm": {1}, "speedMmPerS": 20, "travelSpeedMmPerS": 100, "accelerationMmPerS2": 500,
 "contactToleranceMm": {2}, "maxFlowMm3PerS": {7}, "primeS": 0.2, "material": "paste",
 "densityGPerCm3": 2.0, "head": [[0, {1}], [{4}, {4}], [60, {8}], [110, {8}]]}})",
      0.8 * widthMm, height, 0.5 * height, 1.25 * height, widthMm, 0.8 * widthMm, 1.6 * widthMm,
      60.0 * widthMm * height, widthMm + 14.0);
}

project::Choices choicesOf(const std::string& process) {
  project::Choices choices;
  choices.tool().process = process;
  choices.item().mode = "flat";
  return choices;
}

TEST(BeadDefaults, LengthsScaleWithTheBead) {
  const base::ParameterValues usual = parameterValues(choicesOf("fdm-1.0"));
  const base::ParameterValues fine = parameterValues(choicesOf("fdm-0.35"));
  const base::ParameterValues wide = parameterValues(choicesOf(wideProcess(8.0)));
  for (const char* key : {"voxelMm", "cuspMm", "liftMm", "primeLengthMm"}) {
    EXPECT_DOUBLE_EQ(fine.number(key), usual.number(key)) << key;
    EXPECT_GT(wide.number(key), 3.0 * usual.number(key)) << key;
  }
  EXPECT_DOUBLE_EQ(usual.number("voxelMm"), 0.8);
  EXPECT_DOUBLE_EQ(wide.number("voxelMm"), 4.0);
  EXPECT_DOUBLE_EQ(wide.number("layerHeightMm"), 4.0);
  EXPECT_DOUBLE_EQ(wide.number("beadWidthMm"), 8.0);
}

TEST(BeadDefaults, ASettingOfTheUsersStays) {
  project::Choices choices = choicesOf(wideProcess(8.0));
  choices.item().parameters["voxelMm"] = "0.8";
  EXPECT_DOUBLE_EQ(parameterValues(choices).number("voxelMm"), 0.8);
}

class WideBeads : public testing::TestWithParam<double> {};

TEST_P(WideBeads, ABoxPassesWithoutFurtherSettings) {
  const double bead = GetParam();
  PlanRequest request;
  request.item().loaded = test::loadedBox({0, 0, 0}, {12.0 * bead, 10.0 * bead, 4.0 * bead});
  request.choices.tool().process = wideProcess(bead);
  request.choices.item().automatic = true;
  request.choices.formats = {"csv"};
  const PlanResult plan = planPart(request, {});
  for (const plan::Finding& finding : plan.job.report.findings)
    EXPECT_FALSE(finding.blocking) << plan::englishReason(finding);
  ASSERT_EQ(plan.checked.size(), 1u);
  EXPECT_TRUE(plan.checked[0]->verdict.passed);
  EXPECT_EQ(plan.job.report.item().layers.count, 8);
}

constexpr const char* kFamilies[] = {"clay-6",   "concrete-50", "fdm-0.35",    "fdm-0.4",
                                     "fdm-1.0",  "glue-3",      "large-7.6",   "pellet-2",
                                     "pellet-4", "pellet-6",    "wire-arc-1.2"};

TEST(ProcessFamilies, AllAreTested) {
  std::vector<std::string> ofBeads;
  for (const std::string& id : process::processIds())
    if (!process::loadProcess(id).tape)
      ofBeads.push_back(id);
  EXPECT_THAT(ofBeads, testing::ElementsAreArray(kFamilies));
}

// A box of its beads passes with every process in a cell that carries its head, with about as many
// waypoints as with any other.
class ProcessFamily : public testing::TestWithParam<const char*> {};

TEST_P(ProcessFamily, ABoxOfItsBeadsPasses) {
  const process::Process p = process::loadProcess(GetParam());
  const bool isSmall = p.head.sections.back().zMm <= 110.0;
  PlanRequest request;
  request.item().loaded = test::loadedBox(
      {0, 0, 0}, {20.0 * p.beadWidthMm, 16.0 * p.beadWidthMm, 6.0 * p.layerHeightMm});
  request.choices.tool().process = p.id;
  request.choices.cell = isSmall ? "irb2400-moving" : "irb6700-moving";
  request.choices.item().mode = "flat";
  request.choices.formats = {p.beadWords.empty() ? "rapid" : p.beadWords.front().format};
  request.choices.parameters["output.proof"] = "false";
  const PlanResult plan = planPart(request, {});
  for (const plan::Finding& finding : plan.job.report.findings)
    EXPECT_FALSE(finding.blocking) << plan::englishReason(finding);
  ASSERT_EQ(plan.checked.size(), 1u);
  EXPECT_TRUE(plan.checked[0]->verdict.passed);
  EXPECT_EQ(plan.job.report.item().layers.count, 6);
  EXPECT_LT(plan.job.report.toolpath.waypoints, 6000u);
}

INSTANTIATE_TEST_SUITE_P(All, ProcessFamily, testing::ValuesIn(kFamilies));
INSTANTIATE_TEST_SUITE_P(Widths, WideBeads, testing::Values(3.0, 8.0));

} // namespace
