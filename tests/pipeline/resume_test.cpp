// A print that is taken up again: the rest passes its replay, and both together are the part.
#include "base/error.h"
#include "base/files.h"
#include "box_request.h"
#include "helpers/all_seeds.h"
#include "helpers/temporary_folder.h"
#include "motion/motion_options.h"
#include "motion/resumed_motion.h"
#include "pipeline/checked_program.h"
#include "pipeline/outputs.h"
#include "pipeline/resume.h"
#include "pipeline/road.h"
#include "plan/finding_kinds.h"
#include "process/own_materials.h"
#include "program/dialect.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>
#include <set>

using namespace voluta;
using namespace voluta::pipeline;

namespace {

const base::RunContext kCtx;

// Material of a program's motions, as its own reader finds it.
double materialOf(const CheckedProgram& checked, const process::Process& process) {
  const plan::ReadProgram read = program::readProgram(checked.program.format, checked.program.files,
                                                      process::Tooling(process), kCtx);
  double volume = 0.0;
  for (const plan::ProgramMotion& motion : read.motions)
    volume += std::max(0.0, motion.volumeMm3);
  return volume;
}

TEST(Resume, AtRandomBeadsTheRestIsTheRest) {
  const PlanResult& whole = test::boxPlan();
  ASSERT_TRUE(nothingBlocks(whole.job.report));
  const std::size_t beads = whole.job.toolPlan->paths.size();
  const double material = whole.job.trajectory->extrudedMm3.back();
  std::mt19937 random(18);
  for (int k = 0; k < test::ofSeeds(4, 20); ++k) {
    const std::size_t bead = random() % beads;
    const auto point = motion::resumePointOfPath(*whole.job.trajectory, *whole.job.toolPlan, bead);
    ASSERT_TRUE(point) << bead;
    const ResumeResult rest = resumeJob(whole.job, *point, {"gcode-extended"}, kCtx);
    EXPECT_EQ(rest.bead, bead + 1);
    ASSERT_EQ(rest.plan.checked.size(), 1u) << bead;
    EXPECT_TRUE(rest.plan.checked[0]->verdict.passed) << bead;
    EXPECT_TRUE(nothingBlocks(rest.plan.job.report)) << bead;
    EXPECT_NEAR(rest.depositedMm3 + rest.leftMm3, material, 1e-6 * material);
    EXPECT_NEAR(materialOf(*rest.plan.checked[0], rest.plan.tooling().first().process),
                rest.leftMm3, 2e-3 * material)
        << bead;
    // The deposited volume is the volume of the beads before it.
    EXPECT_NEAR(rest.depositedMm3, whole.job.trajectory->extrudedMm3[*point], 1e-9);
    EXPECT_NEAR(rest.plan.job.report.replay.massRatio, whole.job.report.replay.massRatio, 1e-3);
  }
}

TEST(Resume, WithinABeadTheArmIsChecked) {
  const PlanResult& whole = test::boxPlan();
  const auto& t = *whole.job.trajectory;
  // The middle of the longest run of print moves.
  std::size_t best = 0, length = 0;
  for (std::size_t i = 0, run = 0; i < t.pointCount(); ++i) {
    run = t.move[i] == plan::MoveKind::Print ? run + 1 : 0;
    if (run > length) {
      length = run;
      best = i - run / 2;
    }
  }
  const auto point = motion::resumePoint(t, best);
  ASSERT_TRUE(point);
  EXPECT_LE(*point, best);
  const ResumeResult rest = resumeJob(whole.job, *point, {}, kCtx);
  ASSERT_FALSE(rest.plan.checked.empty());
  for (const auto& checked : rest.plan.checked)
    EXPECT_TRUE(checked->verdict.passed) << checked->program.format;
  EXPECT_EQ(rest.plan.job.report.replay.collisions, 0u);
  // Home, the way there, and on from the same joints.
  const auto& resumed = *rest.plan.job.trajectory;
  const std::size_t first = rest.plan.job.resumedAt;
  ASSERT_GT(first, *point);
  const auto home = rest.plan.cell->home();
  for (int j = 0; j < resumed.dof; ++j)
    EXPECT_DOUBLE_EQ(resumed.at(first)[j], home[j]);
  for (std::size_t i = first; i < resumed.pointCount(); ++i)
    if (resumed.waypoint[i] == t.waypoint[*point]) {
      for (int j = 0; j < resumed.dof; ++j)
        EXPECT_DOUBLE_EQ(resumed.at(i)[j], t.at(*point)[j]);
      EXPECT_NE(resumed.move[i], plan::MoveKind::Print);
      break;
    }
  for (std::size_t i = 1; i < resumed.pointCount(); ++i)
    ASSERT_LE(resumed.timeS[i - 1], resumed.timeS[i]);
}

// The line of the motion to a bead's second waypoint begins at that bead: in each file of a program
// that is cut, and there only where the file is named.
TEST(Resume, ByBeadAndByLineFromDisk) {
  PlanRequest cut = test::boxRequest({{"motionsPerFile", "1500"}});
  cut.choices.item().mode = "flat";
  cut.choices.formats = {"urscript", "gcode-extended", "csv"};
  PlanResult whole = planPart(cut, kCtx);
  const test::TemporaryFolder folder;
  writeOutputs(whole, folder.path(), kCtx);
  ResumeRequest request;
  request.job = folder / "job.voluta";
  request.formats = {"csv"};
  const std::size_t beads = whole.job.toolPlan->paths.size();
  ResumeResult byLine;
  for (const auto& checked : whole.checked) {
    const auto& files = checked->program.files;
    const auto lines = linesOfPoints(*checked, *whole.job.trajectory);
    std::set<std::size_t> tried;
    for (const std::size_t bead : {beads, beads / 2, std::size_t{5}}) {
      const auto point =
          motion::resumePointOfPath(*whole.job.trajectory, *whole.job.toolPlan, bead - 1);
      ASSERT_TRUE(point);
      const TextLine line = lines[*point + 1];
      tried.insert(line.file);
      request.line = line.line;
      request.program = folder / files[line.file].name;
      byLine = resumePrint(request, kCtx);
      EXPECT_EQ(byLine.bead, bead) << request.program;
      EXPECT_EQ(byLine.waypoint, whole.job.trajectory->waypoint[*point]) << request.program;
    }
    EXPECT_EQ(tried.size(), files.size() > 1 ? 3u : 1u) << checked->program.format;
  }
  request.bead = 5;
  request.line.reset();
  const ResumeResult byBead = resumePrint(request, kCtx);
  EXPECT_EQ(byBead.bead, 5u);
  EXPECT_EQ(byBead.waypoint, byLine.waypoint);
  // Without a file the line may be any file's.
  request.bead.reset();
  request.program.clear();
  request.line = 100;
  try {
    resumePrint(request, kCtx);
    ADD_FAILURE() << "whose line?";
  } catch (const base::Error& error) {
    EXPECT_EQ(error.code(), base::ErrorCode::Usage);
    for (const char* word : {"line 100", "--program", "print_box_1.script"})
      EXPECT_THAT(base::english(error.whole()), testing::HasSubstr(word));
  }
  // The rest is verified from disk, and taken up again itself.
  PlanResult rest = byLine.plan;
  const test::TemporaryFolder second;
  writeOutputs(rest, second.path(), kCtx);
  const std::string file = rest.job.report.programs[0].files[0];
  const VerifyResult verified = verifyProgram(second / file, second / "job.voluta", kCtx);
  EXPECT_TRUE(verified.replay.passed);
  request = {};
  request.job = second / "job.voluta";
  request.bead = 9;
  request.formats = {"csv"};
  const ResumeResult third = resumePrint(request, kCtx);
  EXPECT_EQ(third.bead, 9u);
  EXPECT_TRUE(third.plan.checked[0]->verdict.passed);
}

// Of a program in one file the line is enough.
TEST(Resume, ByLineOfTheOnlyFile) {
  PlanRequest whole = test::boxRequest({{"motionsPerFile", "1000000"}});
  whole.choices.item().mode = "flat";
  whole.choices.formats = {"urscript"};
  PlanResult plan = planPart(whole, kCtx);
  const test::TemporaryFolder folder;
  writeOutputs(plan, folder.path(), kCtx);
  const auto point = motion::resumePointOfPath(*plan.job.trajectory, *plan.job.toolPlan, 4);
  ResumeRequest request;
  request.job = folder / "job.voluta";
  request.line = linesOfPoints(*plan.checked[0], *plan.job.trajectory)[*point + 1].line;
  EXPECT_EQ(resumePrint(request, kCtx).bead, 5u);
}

// Two boxes, each with one of two tools that are changed by hand.
PlanRequest twoTools() {
  PlanRequest request;
  request.items.resize(2);
  request.choices.items.resize(2);
  for (std::size_t i = 0; i < 2; ++i) {
    request.item(i).loaded = test::loadedBox({-9, -8, 0}, {9, 8, 3});
    request.choices.item(i).mode = "flat";
    request.choices.item(i).placement.centreMm.x() = 60.0 * static_cast<double>(i) - 30.0;
  }
  request.choices.item(1).parameters["tool"] = "2";
  request.choices.cell = "ur5-moving";
  request.choices.tools = {{"fdm-1.0"}, {process::processTextWith("fdm-1.0", "petg")}};
  request.choices.formats = {"urscript"};
  return request;
}

// Planned once.
const PlanResult& twoToolsPlan() {
  static const PlanResult kPlan = planPart(twoTools(), kCtx);
  return kPlan;
}

// The start of the program of a rest, as its own reader reads it.
void expectBeginsWith(int tool, const CheckedProgram& checked, const PlanResult& plan) {
  const plan::ReadProgram read =
      program::readProgram(checked.program.format, checked.program.files, plan.tooling(), kCtx);
  const std::string name = "tool " + std::to_string(tool + 1) + " (";
  const auto stop =
      std::ranges::find(read.facts, plan::FactKind::OperatorStop, &plan::StatedFact::kind);
  const auto select =
      std::ranges::find(read.facts, plan::FactKind::ToolSelected, &plan::StatedFact::kind);
  ASSERT_NE(stop, read.facts.end());
  ASSERT_NE(select, read.facts.end());
  EXPECT_LT(stop, select);
  EXPECT_EQ(select->before, 0u);
  EXPECT_EQ(select->tool, tool);
  if (program::findDialect(checked.program.format).showsTexts) {
    EXPECT_NE(stop->word.find(name), std::string::npos) << stop->word;
  }
  // The machine does not have the tool that the operator fits later.
  for (const plan::StatedFact& fact : read.facts)
    if (fact.kind == plan::FactKind::NozzleHeat && fact.number > 0.0 && fact.before == 0) {
      EXPECT_EQ(fact.tool, tool);
    }
  // Its purge comes before its first bead, and no other tool's material.
  const auto purge = std::ranges::find_if(
      read.pauses, [](const plan::ProgramPause& pause) { return pause.volumeMm3 > 0.5; });
  ASSERT_NE(purge, read.pauses.end());
  EXPECT_EQ(purge->tool, tool);
  EXPECT_NEAR(purge->volumeMm3, motion::MotionOptions{}.purge.changeMm3, 1.0);
  const auto bead =
      std::ranges::find_if(read.motions, [](const plan::ProgramMotion& m) { return m.extruding; });
  ASSERT_NE(bead, read.motions.end());
  EXPECT_EQ(bead->tool, tool);
  EXPECT_LE(purge->before, static_cast<std::size_t>(bead - read.motions.begin()));
}

// Beads on the plate keep the temperature at which they were printed: that of the first tool's PLA.
void expectPlateOfFirstTool(const plan::Program& rest) {
  std::string text;
  for (const plan::ProgramFile& file : rest.files)
    text += file.text;
  if (rest.format.starts_with("gcode")) {
    EXPECT_NE(text.find("M190 S60"), std::string::npos);
    EXPECT_EQ(text.find("M190 S80"), std::string::npos);
  }
  EXPECT_EQ(text.find("plate at 80 C"), std::string::npos);
}

TEST(Resume, TheRestBeginsWithTheToolOfItsBead) {
  const std::vector<std::string> formats = {"urscript", "rapid",    "krl",   "melfa",
                                            "spel",     "tmscript", "gcode", "gcode-extended"};
  const PlanResult& whole = twoToolsPlan();
  ASSERT_TRUE(nothingBlocks(whole.job.report));
  const std::vector<plan::ToolPath>& paths = whole.job.toolPlan->paths;
  const auto second =
      static_cast<std::size_t>(std::ranges::find(paths, 1, &plan::ToolPath::tool) - paths.begin());
  for (const std::size_t bead : {second / 2, second, (second + paths.size()) / 2}) {
    SCOPED_TRACE(bead);
    const auto point = motion::resumePointOfPath(*whole.job.trajectory, *whole.job.toolPlan, bead);
    ASSERT_TRUE(point);
    const ResumeResult rest = resumeJob(whole.job, *point, formats, kCtx);
    ASSERT_EQ(rest.plan.checked.size(), formats.size());
    const int tool = paths[bead].tool;
    EXPECT_EQ(rest.plan.job.trajectory->toolAt(rest.plan.job.resumedAt), tool);
    EXPECT_EQ(rest.plan.job.report.motion.toolChanges, bead < second ? 1u : 0u);
    for (const auto& checked : rest.plan.checked) {
      SCOPED_TRACE(checked->program.format);
      EXPECT_TRUE(checked->verdict.passed);
      expectBeginsWith(tool, *checked, rest.plan);
      expectPlateOfFirstTool(checked->program);
    }
  }
}

// The print may have stopped before them.
TEST(Resume, EventsBeforeTheFirstBeadOfTheRestComeAgain) {
  const std::vector<std::string> formats = {"urscript", "rapid",    "krl",           "melfa",
                                            "spel",     "tmscript", "gcode-extended"};
  PlanRequest request = test::boxRequest(
      {{"pauseLayers", "3"}, {"layerEvents", "3 wait 20; 3 output 33 on; 3 photo 34"}});
  request.choices.item().mode = "flat";
  request.choices.formats = {"gcode-extended"};
  const PlanResult whole = planPart(request, kCtx);
  const std::vector<plan::ToolPath>& paths = whole.job.toolPlan->paths;
  const auto bead =
      static_cast<std::size_t>(std::ranges::find(paths, 2, &plan::ToolPath::layer) - paths.begin());
  const auto point = motion::resumePointOfPath(*whole.job.trajectory, *whole.job.toolPlan, bead);
  ASSERT_TRUE(point);
  const ResumeResult rest = resumeJob(whole.job, *point, formats, kCtx);
  ASSERT_EQ(rest.plan.checked.size(), formats.size());
  for (const auto& checked : rest.plan.checked) {
    SCOPED_TRACE(checked->program.format);
    // URScript and TMscript have fewer outputs.
    const bool says =
        checked->program.format != "urscript" && checked->program.format != "tmscript";
    EXPECT_EQ(checked->verdict.passed, says);
    std::string text;
    for (const plan::ProgramFile& file : checked->program.files)
      text += file.text;
    EXPECT_EQ(text.find("Paused before layer 3") != std::string::npos, says);
  }
  // The rest is kept, and taken up again at the same bead its events come once.
  const test::TemporaryFolder folder;
  project::writeJob(folder / "job.voluta", rest.plan.job);
  const project::Job kept = project::readJob(folder / "job.voluta", allParameters());
  const auto again = motion::resumePoint(*kept.trajectory, kept.resumedAt);
  ASSERT_TRUE(again);
  const ResumeResult second = resumeJob(kept, *again, {"gcode-extended"}, kCtx);
  ASSERT_EQ(second.plan.checked.size(), 1u);
  EXPECT_TRUE(second.plan.checked[0]->verdict.passed);
  const auto pausesIn = [](const CheckedProgram& checked) {
    int pauses = 0;
    for (const plan::ProgramFile& file : checked.program.files)
      for (std::size_t at = file.text.find("Paused before layer 3"); at != std::string::npos;
           at = file.text.find("Paused before layer 3", at + 1))
        ++pauses;
    return pauses;
  };
  const auto first = std::ranges::find(rest.plan.checked, "gcode-extended",
                                       [](const auto& checked) { return checked->program.format; });
  ASSERT_NE(first, rest.plan.checked.end());
  EXPECT_EQ(pausesIn(*second.plan.checked[0]), pausesIn(**first));
}

// By line, from disk; another first selection in the text is refused there.
TEST(Resume, ByLineOfTheSecondTool) {
  PlanResult whole = twoToolsPlan();
  const test::TemporaryFolder folder;
  writeOutputs(whole, folder.path(), kCtx);
  const std::vector<plan::ToolPath>& paths = whole.job.toolPlan->paths;
  const auto bead = paths.size() - 3;
  const auto point = motion::resumePointOfPath(*whole.job.trajectory, *whole.job.toolPlan, bead);
  ResumeRequest request;
  request.job = folder / "job.voluta";
  request.line = linesOfPoints(*whole.checked[0], *whole.job.trajectory)[*point + 1].line;
  ResumeResult rest = resumePrint(request, kCtx);
  EXPECT_EQ(rest.bead, bead + 1);
  ASSERT_EQ(rest.plan.checked.size(), 1u);
  EXPECT_TRUE(rest.plan.checked[0]->verdict.passed);
  expectBeginsWith(1, *rest.plan.checked[0], rest.plan);
  const test::TemporaryFolder second;
  writeOutputs(rest.plan, second.path(), kCtx);
  const auto file = second / rest.plan.job.report.programs[0].files[0];
  EXPECT_TRUE(verifyProgram(file, second / "job.voluta", kCtx).replay.passed);
  std::string text = base::readFile(file);
  const std::string selects = "set_standard_digital_out(1,True)";
  ASSERT_NE(text.find(selects), std::string::npos);
  text.replace(text.find(selects), selects.size(), "set_standard_digital_out(1,False)");
  base::writeFile(file, text);
  EXPECT_FALSE(verifyProgram(file, second / "job.voluta", kCtx).replay.passed);
}

// Another controller's format without a word for the change of tools: as in a plan, it is reported,
// and the verdict is that of the cell's own program.
TEST(Resume, AnotherControllersProgramDoesNotDecide) {
  const auto point =
      motion::resumePointOfPath(*twoToolsPlan().job.trajectory, *twoToolsPlan().job.toolPlan, 2);
  ASSERT_TRUE(point);
  const PlanResult rest = resumeJob(twoToolsPlan().job, *point, {"krl-eki", "urscript"}, kCtx).plan;
  ASSERT_EQ(rest.checked.size(), 2u);
  EXPECT_FALSE(rest.checked[0]->verdict.passed);
  EXPECT_TRUE(rest.checked[1]->verdict.passed);
  EXPECT_TRUE(nothingBlocks(rest.job.report));
  EXPECT_TRUE(rest.job.report.replay.passed);
  std::vector<plan::FindingKind> kinds;
  for (const plan::Finding& finding : rest.job.report.findings)
    kinds.push_back(finding.kind);
  EXPECT_THAT(kinds, testing::Contains(plan::FindingKind::ForeignRefused));
}

TEST(Resume, MissingWayBackGivesAFinding) {
  project::Job job = test::boxPlan().job;
  job.choices.parameters["bodyClearanceMm"] = "50"; // more than the cell has anywhere
  const auto point = motion::resumePointOfPath(*job.trajectory, *job.toolPlan, 4);
  ASSERT_TRUE(point);
  const ResumeResult rest = resumeJob(std::move(job), *point, {}, kCtx);
  EXPECT_TRUE(rest.plan.checked.empty());
  ASSERT_FALSE(nothingBlocks(rest.plan.job.report));
  EXPECT_EQ(rest.plan.job.report.findings.back().kind, plan::FindingKind::NoPathBack);
}

TEST(Resume, BeadsAndLinesWithoutAResumePointAreRefused) {
  PlanResult whole = test::boxPlan();
  const test::TemporaryFolder folder;
  writeOutputs(whole, folder.path(), kCtx);
  ResumeRequest request;
  request.job = folder / "job.voluta";
  request.bead = 100000;
  EXPECT_THROW(resumePrint(request, kCtx), base::Error);
  request.bead = 0;
  EXPECT_THROW(resumePrint(request, kCtx), base::Error);
  request.bead.reset();
  request.line = 10000000;
  EXPECT_THROW(resumePrint(request, kCtx), base::Error);
  request.line = 3;
  request.program = folder / "report.json";
  EXPECT_THROW(resumePrint(request, kCtx), base::Error);
}

} // namespace
