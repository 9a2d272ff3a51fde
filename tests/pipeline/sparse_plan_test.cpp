// Parts with sparse infill from the mesh to the replayed program.
#include "base/files.h"
#include "box_request.h"
#include "helpers/all_seeds.h"
#include "helpers/given_parameters.h"
#include "helpers/temporary_folder.h"
#include "pipeline/checked_program.h"
#include "pipeline/outputs.h"
#include "pipeline/plan_reasons.h"
#include "plan/program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>
#include <sstream>

namespace voluta::pipeline {
namespace {

using test::reasons;

PlanRequest sparseRequest(const std::string& mode, const std::string& pattern,
                          const std::string& density = "0.2") {
  PlanRequest request;
  request.item().loaded = test::loadedBox({-17, -15, 0}, {17, 15, 12});
  request.choices.item().mode = mode;
  request.choices.formats = {"gcode-extended"};
  test::giveParameters(request.choices, {{"infillDensity", density}, {"sparsePattern", pattern}});
  return request;
}

class SparsePlans : public testing::TestWithParam<std::tuple<const char*, const char*>> {};

TEST_P(SparsePlans, PassWithLessMaterial) {
  const auto [mode, pattern] = GetParam();
  const PlanResult plan = planPart(sparseRequest(mode, pattern), {});
  ASSERT_EQ(plan.checked.size(), 1u);
  EXPECT_TRUE(plan.checked[0]->verdict.passed) << reasons(plan);
  const plan::ToolpathStatistics& paths = plan.job.report.toolpath;
  EXPECT_GT(paths.sparseMm3, 1500.0);
  EXPECT_LT(paths.materialMm3, 0.9 * 34 * 30 * 12);
  EXPECT_NEAR(plan.checked[0]->verdict.massRatio, 1.0, 0.02);
}

std::string nameOf(const testing::TestParamInfo<std::tuple<const char*, const char*>>& info) {
  return std::string(std::get<0>(info.param)) + "_" + std::get<1>(info.param);
}
INSTANTIATE_TEST_SUITE_P(Modes, SparsePlans,
                         testing::Values(std::tuple("flat", "gyroid"), std::tuple("flat", "lines"),
                                         std::tuple("flat", "grid"),
                                         std::tuple("flat", "honeycomb"),
                                         std::tuple("flat", "pith"),
                                         std::tuple("planar", "triangles"),
                                         std::tuple("curved", "gyroid")),
                         nameOf);

TEST(SparsePlan, HollowPartIsRefusedWithAReason) {
  const PlanResult plan = planPart(sparseRequest("flat", "gyroid", "0"), {});
  EXPECT_FALSE(plan.checked.at(0)->verdict.passed);
  EXPECT_THAT(reasons(plan), testing::HasSubstr("hollow interior"));
}

// The lines of a program, in sections that begin with a remark about layer, kind and path.
struct Section {
  int layer = 0;
  std::string kind, text;
};
std::vector<Section> sectionsOf(const std::string& program) {
  std::vector<Section> sections(1);
  std::istringstream lines(program);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("; layer ")) {
      Section& next = sections.emplace_back();
      const std::size_t comma = line.find(", ");
      next.layer = std::stoi(line.substr(8));
      next.kind = line.substr(comma + 2, line.rfind(", ") - comma - 2);
    }
    sections.back().text += line + "\n";
  }
  return sections;
}

// One layer's beads of a kind are left out, of each kind in turn.
TEST(SparsePlan, AProgramWithoutASkinAWallOrALayerOfInfillIsRefused) {
  const PlanResult plan = planPart(sparseRequest("flat", "lines"), {});
  const CheckedProgram& checked = *plan.checked.at(0);
  ASSERT_TRUE(checked.verdict.passed) << reasons(plan);
  const test::TemporaryFolder folder;
  const plan::ProgramFile& file = checked.program.files.at(0);
  const std::vector<Section> sections = sectionsOf(file.text);
  std::mt19937_64 random(11);
  const std::vector<std::string> kinds = {"wall", "infill", "sparse infill", "bridge"};
  for (int run = 0; run < test::ofSeeds(8, 40); ++run) {
    const std::string& kind = kinds[static_cast<std::size_t>(run) % kinds.size()];
    std::vector<int> layers;
    for (const Section& section : sections)
      if (section.kind == kind)
        layers.push_back(section.layer);
    ASSERT_FALSE(layers.empty()) << kind;
    const int layer = layers[random() % layers.size()];
    std::string text;
    for (const Section& section : sections)
      if (section.kind != kind || section.layer != layer)
        text += section.text;
    base::writeFile(folder / file.name, text);
    const VerifyResult verified = verifyProgram(folder / file.name, plan.job, {});
    EXPECT_FALSE(verified.replay.passed) << kind << " of layer " << layer;
    EXPECT_FALSE(verified.findings.empty());
  }
}

} // namespace
} // namespace voluta::pipeline
