// The proof beside a program: its hash is the file's, its places are lines of it, and its page
// agrees with its figures.
#include "base/files.h"
#include "base/sha256.h"
#include "base/units.h"
#include "collision/growing_part.h"
#include "helpers/temporary_folder.h"
#include "motion/joint_margins.h"
#include "pipeline/box_request.h"
#include "pipeline/checked_program.h"
#include "pipeline/outputs.h"
#include "pipeline/proof.h"
#include "pipeline/road.h"
#include "plan/finding_kinds.h"
#include "plan/program.h"
#include "plan/tool_plan.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace voluta;
using namespace voluta::pipeline;

namespace {

const base::RunContext kCtx;

nlohmann::json proofIn(const std::filesystem::path& folder, const std::string& program) {
  return nlohmann::json::parse(base::readFile(folder / (program + ".proof.json")));
}

TEST(Proof, IsWrittenBesideEachProgramThatPassed) {
  PlanResult plan = test::boxPlan();
  ASSERT_TRUE(nothingBlocks(plan.job.report));
  const test::TemporaryFolder folder;
  writeOutputs(plan, folder.path(), kCtx);
  ASSERT_EQ(plan.checked.size(), 3u);
  for (const auto& checked : plan.checked) {
    const std::string file = checked->program.files[0].name;
    const auto proof = proofIn(folder.path(), file);
    EXPECT_EQ(proof["files"][0]["sha256"], base::sha256(base::readFile(folder / file)));
    EXPECT_EQ(proof["replay"]["passed"], true);
    EXPECT_NEAR(proof["durationS"]["planned"].get<double>(), plan.job.report.motion.durationS,
                1e-9);
    EXPECT_EQ(proof["armChecked"], checked->program.format != "gcode-extended");
    if (!checked->armChecked)
      continue; // below
    EXPECT_EQ(proof["jointLimits"].size(), 6u);
    for (const auto* place : {&proof["leastClearance"], &proof["singularity"]}) {
      const auto of = std::ranges::find(checked->program.files, (*place)["file"].get<std::string>(),
                                        &plan::ProgramFile::name);
      ASSERT_NE(of, checked->program.files.end()) << (*place)["file"];
      EXPECT_GT((*place)["line"].get<long>(), 0);
      EXPECT_LE((*place)["line"].get<long>(), std::ranges::count(of->text, '\n'));
    }
    EXPECT_GT(proof["massG"].get<double>(), 0.0);
    EXPECT_EQ(proof["jointSpeeds"].size(), 6u);
    for (const auto& joint : proof["jointSpeeds"])
      EXPECT_LE(joint["shareOfLimit"].get<double>(), 1.05) << joint;
    const std::string page = base::readFile(folder / (file + ".proof.html"));
    EXPECT_NE(page.find("Passed: this program prints"), std::string::npos);
    EXPECT_NE(page.find(proof["files"][0]["sha256"].get<std::string>()), std::string::npos);
    EXPECT_EQ(base::readFile(folder / (file + ".proof.pdf")).substr(0, 5), "%PDF-");
  }
  EXPECT_TRUE(std::filesystem::exists(folder / "box.printed.stl"));
}

// G-code states the nozzle's position: nothing is claimed of an arm.
TEST(Proof, ClaimsNothingOfAnArmThatWasNotChecked) {
  PlanResult plan = test::boxPlan();
  const test::TemporaryFolder folder;
  writeOutputs(plan, folder.path(), kCtx);
  const auto pageOf = [&](const char* format) {
    const auto checked = std::ranges::find_if(
        plan.checked, [&](const auto& program) { return program->program.format == format; });
    return base::readFile(folder / (proofName(**checked) + ".html"));
  };
  const std::string robot = pageOf("urscript"), gcode = pageOf("gcode-extended");
  for (const char* claim : {"on a model of the robot", "Minimum clearance between arm",
                            "Joint range", "Joint speed", "Singularities", "Limits of joints"}) {
    EXPECT_NE(robot.find(claim), std::string::npos) << claim;
    EXPECT_EQ(gcode.find(claim), std::string::npos) << claim;
  }
  for (const char* said : {"without an arm", "Collisions of head, plate and part: 0",
                           "Arm, joints and their limits: not checked"}) {
    EXPECT_EQ(robot.find(said), std::string::npos) << said;
    EXPECT_NE(gcode.find(said), std::string::npos) << said;
  }
  const auto figures = proofIn(folder.path(), "box.gcode");
  for (const char* key : {"leastClearance", "jointLimits", "jointSpeeds", "singularity"})
    EXPECT_FALSE(figures.contains(key)) << key;
  EXPECT_GT(figures["massG"].get<double>(), 0.0);
}

// The worst place of each margin that has one, in the part and in the program.
TEST(Proof, AMarginNamesItsWorstPlace) {
  PlanResult plan = test::boxPlan();
  const test::TemporaryFolder folder;
  writeOutputs(plan, folder.path(), kCtx);
  const auto proof = proofIn(folder.path(), plan.checked[0]->program.files[0].name);
  const auto& gap = proof["worst"]["coveredFraction"];
  ASSERT_TRUE(gap.contains("atMm"));
  for (int k = 0; k < 3; ++k) {
    EXPECT_GT(gap["atMm"][k].get<double>(), k < 2 ? -12.0 : -1.0);
    EXPECT_LT(gap["atMm"][k].get<double>(), k < 2 ? 12.0 : 9.0);
  }
  EXPECT_GE(gap["layer"].get<int>(), 1);
  EXPECT_LE(gap["layer"].get<int>(), plan.job.report.item().layers.count);
  EXPECT_GE(gap["atS"].get<double>(), 0.0);
  EXPECT_LE(gap["atS"].get<double>(), plan.job.report.motion.durationS);
  for (const auto& joint : proof["jointLimits"])
    EXPECT_EQ(joint["atMm"].size(), 3u);
}

TEST(Proof, RefusedProgramIsMarkedFirst) {
  PlanResult plan = test::boxPlan();
  CheckedProgram refused = *plan.checked[0];
  refused.safeToRun = refused.verdict.safeToRun = refused.verdict.passed = false;
  refused.verdict.collisions = 2;
  plan.checked = {std::make_shared<const CheckedProgram>(refused)};
  plan.keepRefused = true;
  const test::TemporaryFolder folder;
  writeOutputs(plan, folder.path(), kCtx);
  const std::string name = "refused-" + refused.program.files[0].name;
  const std::string page = base::readFile(folder / (name + ".proof.html"));
  EXPECT_NE(page.find("Refused: do not run this program."), std::string::npos);
  EXPECT_NE(page.find("Collisions: 2; none allowed."), std::string::npos);
  EXPECT_EQ(page.find("Passed:"), std::string::npos);
  EXPECT_EQ(proofIn(folder.path(), name)["files"][0]["name"], name);
}

// A finding on the plan is no property of its programs, whose replay passes.
TEST(Proof, AProgramOfAnotherPartThanAskedHasNotPassed) {
  PlanResult plan = test::boxPlan();
  plan.job.report.findings.push_back(
      plan::makeFinding(plan::FindingKind::BeginsInAir, {{"pieces", 1}}, Eigen::Vector3d(1, 2, 3)));
  plan.job.report.findings.push_back(
      plan::makeFinding(plan::FindingKind::ProgramRefused,
                        {{"format", "another"_name}, {"failed", std::vector<base::Message>()}}));
  EXPECT_FALSE(nothingBlocks(plan.job.report));
  EXPECT_EQ(verdictOf(plan.job.report), PlanVerdict::Blocked) << "one of its programs is refused";
  const test::TemporaryFolder folder;
  writeOutputs(plan, folder.path(), kCtx);
  for (const auto& checked : plan.checked) {
    EXPECT_EQ(verdictOf(*checked, plan.job.report), PlanVerdict::NotAsAsked);
    EXPECT_EQ(blockersOf(plan.job.report, checked->program.format).size(), 1u);
    const std::string page = base::readFile(folder / (proofName(*checked) + ".html"));
    EXPECT_EQ(page.find("Passed:"), std::string::npos);
    EXPECT_NE(page.find("Safe to run, but it does not print the part as asked."),
              std::string::npos);
    EXPECT_NE(page.find("1 piece of a layer begins in the air"), std::string::npos);
    EXPECT_NE(page.find("at (1.0, 2.0, 3.0)"), std::string::npos);
    const auto proof = proofIn(folder.path(), checked->program.files[0].name);
    EXPECT_EQ(proof["replay"]["planPassed"], false);
    EXPECT_EQ(proof["replay"]["blocking"].size(), 1u);
  }
}

TEST(Proof, TheLegendHasTheColoursOfTheMap) {
  Proof proof;
  proof.fill = {1.0, Eigen::Vector3d::Zero(), {3, 2, 2}, {}, std::vector<double>(12, 1.0)};
  proof.fill.filled = {1.0, 0.83, -1.0, 1.0, 0.83, -1.0, 0.75, 0.6, 0.1, 0.75, 0.6, 0.1};
  const page::Sheet sheet = proofSheet(proof, base::Language());
  ASSERT_EQ(sheet.maps.size(), 2u);
  const page::CellMap& front = sheet.maps[0];
  ASSERT_EQ(front.width, 3);
  ASSERT_EQ(front.height, 2);
  const auto label = [&](int row, int column) -> std::string {
    const int swatch = front.swatch[static_cast<std::size_t>(row * 3 + column)];
    return swatch < 0 ? "" : sheet.legend[static_cast<std::size_t>(swatch)].label;
  };
  EXPECT_EQ(label(1, 0), "at least 90\u00a0% filled");
  EXPECT_EQ(label(1, 1), "80 to 90\u00a0%");
  EXPECT_EQ(label(1, 2), "");
  EXPECT_EQ(label(0, 0), "70 to 80\u00a0%");
  EXPECT_EQ(label(0, 1), "50 to 70\u00a0%");
  EXPECT_EQ(label(0, 2), "less than 50\u00a0%");
}

TEST(Proof, NoneIsMadeWhereItIsNotWanted) {
  PlanResult plan = test::boxPlan();
  plan.proofs = false;
  const test::TemporaryFolder folder;
  writeOutputs(plan, folder.path(), kCtx);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    EXPECT_EQ(entry.path().string().find(".proof."), std::string::npos) << entry.path();
}

TEST(Proof, TheMarginIsToTheNearerLimit) {
  const PlanResult& plan = test::boxPlan();
  const plan::Trajectory& t = *plan.job.trajectory;
  const motion::MotionMargins margins = motion::marginsOf(t, *plan.cell, kCtx);
  for (int j = 0; j < t.dof; ++j) {
    const auto& limits = plan.cell->limits()[static_cast<std::size_t>(j)];
    double minimum = 1e9;
    for (std::size_t i = 0; i < t.pointCount(); ++i)
      minimum = std::min({minimum, t.at(i)[j] - limits.min, limits.max - t.at(i)[j]});
    EXPECT_DOUBLE_EQ(margins.joints[static_cast<std::size_t>(j)].rad, minimum);
  }
}

TEST(Proof, AStretchedArmIsSingular) {
  const PlanResult& plan = test::boxPlan();
  const robot::RobotModel& robot = plan.cell->robot();
  const double reach = motion::reachOf(robot);
  robot::JointVector bent = plan.cell->home(), stretched = robot::JointVector::Zero(6);
  EXPECT_GT(motion::isotropyAt(robot, bent, reach), 1e-3);
  EXPECT_LT(motion::isotropyAt(robot, stretched, reach),
            1e-6); // the UR's zero: arm out, wrist flat
}

TEST(Proof, FillMapShowsEmptyPlaces) {
  const PlanResult& plan = test::boxPlan();
  const plan::ToolPlan& whole = *plan.job.toolPlan;
  const double pitch =
      collision::growingPitch(whole, process::Tooling(plan.tooling().first().process));
  const FillMap full = fillMap(plan.job.item().printed(), {}, whole,
                               collision::GrowingPart(whole, pitch, kCtx), kCtx);
  double mean = 0.0, count = 0.0;
  for (const double share : full.filled)
    if (share >= 0.0) {
      mean += share;
      count += 1.0;
    }
  EXPECT_GT(mean / count, 0.9);
  plan::ToolPlan half = whole; // lower layers only
  std::erase_if(half.paths, [](const plan::ToolPath& p) { return p.layer > 4; });
  const FillMap left =
      fillMap(plan.job.item().printed(), {}, half, collision::GrowingPart(half, pitch, kCtx), kCtx);
  const auto at = [](const FillMap& map, int k) {
    return map.filled[static_cast<std::size_t>(
        map.size.x() / 2 + map.size.x() * (map.size.y() / 2 + map.size.y() * k))];
  };
  EXPECT_GT(at(left, 1), 0.8);
  EXPECT_EQ(at(left, left.size.z() - 2), 0.0);
}

// Infill of 20 % that is whole is shown as full, and its absence as empty.
TEST(Proof, FillMapMeasuresSparseInfillByItsShare) {
  PlanRequest request = test::boxRequest({{"infillDensity", "0.2"}});
  request.item().loaded = test::loadedBox({-15, -15, 0}, {15, 15, 24});
  request.choices.item().mode = "flat";
  const PlanResult result = planPart(request, kCtx);
  const plan::ToolPlan& whole = *result.job.toolPlan;
  const double pitch =
      collision::growingPitch(whole, process::Tooling(result.tooling().first().process));
  const auto lowSwatches = [&](const plan::ToolPlan& printed) {
    Proof proof;
    proof.fill = fillMap(result.job.item().printed(), {}, whole,
                         collision::GrowingPart(printed, pitch, kCtx), kCtx);
    constexpr int kHalf = 3; // the swatch of less than 70 %
    double low = 0.0, all = 0.0;
    for (const page::CellMap& map : proofSheet(proof, base::Language()).maps)
      for (const int swatch : map.swatch) {
        all += 1.0;
        low += swatch >= kHalf ? 1.0 : 0.0;
      }
    return low / all;
  };
  EXPECT_LT(lowSwatches(whole), 0.2);
  plan::ToolPlan hollow = whole;
  std::erase_if(hollow.paths, [](const plan::ToolPath& path) {
    return path.kind == plan::PathKind::SparseInfill;
  });
  EXPECT_GT(lowSwatches(hollow), 0.3);
}

} // namespace
