// Plans as the window makes them: stages that are kept, keys that show which are out of date,
// projects that are reopened. A small box, so that a whole plan takes about a second.
#include "curved/decomposition.h"
#include "pipeline/checked_program.h"
#include "pipeline/road.h"
#include "pipeline/stage_options.h"

#include "base/error.h"
#include "base/files.h"
#include "base/units.h"
#include "geometry/measures.h"
#include "helpers/temporary_folder.h"
#include "pipeline/box_request.h"
#include "pipeline/outputs.h"
#include "plan/finding_kinds.h"
#include "program/job_head.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

using namespace voluta;
using namespace voluta::modes;
using namespace voluta::pipeline;
using namespace voluta::project;

namespace {

using test::boxPart;

base::RunContext context() {
  return base::RunContext(base::CancelToken(), 2);
}

PlanRequest boxRequest(const std::map<std::string, std::string>& parameters = {}) {
  PlanRequest request = test::boxRequest(parameters);
  request.choices.formats = {"urscript", "gcode-extended", "csv"};
  return request;
}

// A report without its times and number of threads.
nlohmann::json said(const Report& report) {
  auto j = nlohmann::json::parse(reportJson(report));
  for (const char* key : {"timingS", "peakRssMb", "threads"})
    j.erase(key);
  return j;
}

void expectSamePrograms(const PlanResult& a, const PlanResult& b) {
  ASSERT_EQ(a.checked.size(), b.checked.size());
  for (std::size_t i = 0; i < a.checked.size(); ++i) {
    ASSERT_EQ(a.checked[i]->program.files.size(), b.checked[i]->program.files.size());
    for (std::size_t f = 0; f < a.checked[i]->program.files.size(); ++f) {
      EXPECT_EQ(a.checked[i]->program.files[f].name, b.checked[i]->program.files[f].name);
      EXPECT_TRUE(a.checked[i]->program.files[f].text == b.checked[i]->program.files[f].text)
          << a.checked[i]->program.files[f].name;
    }
  }
}

// One plan with a cache that the tests look at.
class PlannedBox : public ::testing::Test {
protected:
  static void SetUpTestSuite() {
    cache_ = new StageCache();
    first_ = new PlanResult(planPart(boxRequest(), context(), cache_));
  }
  static void TearDownTestSuite() {
    delete first_;
    delete cache_;
  }
  static StageCache* cache_;
  static PlanResult* first_;
};
StageCache* PlannedBox::cache_ = nullptr;
PlanResult* PlannedBox::first_ = nullptr;

TEST_F(PlannedBox, StagesAreSignalledInOrderWithTheirResults) {
  const PlanResult first = planPart(boxRequest(), context(), cache_); // other tests fill the cache
  std::vector<Stage> reported;
  const PlanResult again =
      planPart(boxRequest(), context(), cache_, {.onStage = [&](Stage stage, const PlanResult& r) {
                 reported.push_back(stage);
                 EXPECT_EQ(r.job.reached, stage);
                 EXPECT_NE(r.job.item().part, nullptr);
                 EXPECT_EQ(r.job.item().decomposition() != nullptr, stage >= Stage::Decompose);
                 EXPECT_EQ(r.cell != nullptr, stage >= Stage::Decompose);
                 EXPECT_EQ(r.job.item().layers != nullptr, stage >= Stage::Layers);
                 EXPECT_EQ(r.job.toolPlan != nullptr, stage >= Stage::Toolpath);
                 EXPECT_EQ(r.job.trajectory != nullptr, stage >= Stage::Motion);
                 EXPECT_EQ(!r.checked.empty(), stage >= Stage::Replay);
               }});
  EXPECT_EQ(reported, (std::vector<Stage>{Stage::Load, Stage::Decompose, Stage::Layers,
                                          Stage::Toolpath, Stage::Motion, Stage::Replay}));
  // All of it was kept.
  EXPECT_EQ(again.job.item().part, first.job.item().part);
  EXPECT_EQ(again.job.trajectory, first.job.trajectory);
  EXPECT_EQ(again.checked, first.checked);
  EXPECT_EQ(said(again.job.report), said(first.job.report));
  EXPECT_EQ(again.job.report.timings.grow, first.job.report.timings.grow);
}

TEST_F(PlannedBox, AnotherInfillLeavesTheLayersAndPlansTheSameAsAFreshPlan) {
  const PlanRequest request = boxRequest({{"infill", "concentric"}});
  const PlanResult second = planPart(request, context(), cache_);
  EXPECT_EQ(second.job.item().decomposition(), first_->job.item().decomposition())
      << "decomposed again";
  EXPECT_EQ(second.job.item().layers, first_->job.item().layers) << "cut again";
  EXPECT_NE(second.job.toolPlan, first_->job.toolPlan);
  const PlanResult fresh = planPart(request, context());
  EXPECT_NE(fresh.job.item().layers, first_->job.item().layers);
  EXPECT_EQ(said(second.job.report), said(fresh.job.report));
  expectSamePrograms(second, fresh);
}

TEST_F(PlannedBox, AnotherFormatOnlyWritesThatFormat) {
  const PlanResult first = planPart(boxRequest(), context(), cache_); // other tests fill the cache
  PlanRequest request = boxRequest();
  request.choices.formats = {"csv", "urscript"};
  const PlanResult second = planPart(request, context(), cache_);
  EXPECT_EQ(second.job.trajectory, first.job.trajectory);
  ASSERT_EQ(second.checked.size(), 2u);
  EXPECT_EQ(second.checked[0], first.checked[2]);
  EXPECT_EQ(second.checked[1], first.checked[0]);
}

void writeProgram(const plan::Program& program, const std::filesystem::path& folder,
                  const std::string& prefix = {}) {
  for (const plan::ProgramFile& file : program.files)
    base::writeFile(folder / (prefix + file.name), file.text);
}

TEST_F(PlannedBox, AProgramIsVerifiedWithAllItsFiles) {
  PlanRequest request = boxRequest();
  request.choices.formats = {"rapid"};
  const PlanResult planned = planPart(request, context(), cache_);
  const test::TemporaryFolder folder;
  writeJob(folder / "job.voluta", planned.job);
  writeProgram(planned.checked.at(0)->program, folder.path());
  const std::string list = planned.checked[0]->program.files.back().name;
  ASSERT_TRUE(list.ends_with(".pgf"));
  EXPECT_TRUE(verifyProgram(folder / list, folder / "job.voluta", context()).replay.passed);
  std::filesystem::remove(folder / planned.checked[0]->program.files.front().name);
  EXPECT_THROW(verifyProgram(folder / list, folder / "job.voluta", context()), base::Error);
}

// Of a program in several files any may be named, and all are replayed; those of a refused one bear
// a prefix on the disk.
TEST_F(PlannedBox, AProgramInSeveralFilesIsFoundByAnyOfThem) {
  for (const char* form : {"node", "port"}) {
    PlanRequest request = boxRequest({{"motionsPerFile", "1500"}, {"urscriptForm", form}});
    request.choices.formats = {"urscript"};
    const PlanResult planned = planPart(request, context(), cache_);
    const plan::Program& program = planned.checked.at(0)->program;
    ASSERT_GT(program.files.size(), 3u);
    for (const char* prefix : {"", "refused-"}) {
      const test::TemporaryFolder folder;
      writeProgram(program, folder.path(), prefix);
      for (const plan::ProgramFile& file : program.files)
        EXPECT_TRUE(
            verifyProgram(folder / (prefix + file.name), planned.job, context()).replay.passed)
            << form << " " << prefix << file.name;
      // Each of them counts.
      const std::filesystem::path last = folder / (prefix + program.files.back().name);
      std::string text = base::readFile(last);
      const std::size_t at = text.find("movel(p[", text.size() / 2) + 10;
      text[at] = text[at] == '1' ? '2' : '1';
      base::writeFile(last, text);
      EXPECT_FALSE(
          verifyProgram(folder / (prefix + program.files.front().name), planned.job, context())
              .replay.passed)
          << form << " " << prefix;
      std::filesystem::remove(last);
      EXPECT_THROW(
          verifyProgram(folder / (prefix + program.files.front().name), planned.job, context()),
          base::Error);
    }
  }
}

// Findings of a program on disk, over the box's job.
VerifyResult verified(const std::filesystem::path& program, const project::Job& job) {
  const test::TemporaryFolder folder;
  writeJob(folder / "job.voluta", job);
  return verifyProgram(program, folder / "job.voluta", context());
}

TEST_F(PlannedBox, ProgramOfAnotherJobNamesTheDifference) {
  const test::TemporaryFolder folder;
  PlanRequest other = boxRequest({{"walls", "3"}});
  other.choices.formats = {"rapid", "urscript", "csv", "gcode-extended"};
  const PlanResult planned = planPart(other, context());
  // In each dialect, also where it joins points.
  for (const auto& checked : planned.checked)
    EXPECT_EQ(program::readJobHead(checked->program.files),
              program::readJobHead(planned.checked[0]->program.files))
        << checked->program.format;
  for (const auto& checked : planned.checked)
    for (const bool cell : {false, true}) {
      for (plan::ProgramFile file : checked->program.files) {
        if (const std::size_t at = file.text.find("cell ur5-fixed");
            cell && at != std::string::npos)
          file.text.replace(at, 14, "cell elsewhere");
        base::writeFile(folder / file.name, file.text);
      }
      const std::filesystem::path program = folder / checked->program.files.front().name;
      const VerifyResult result = verified(program, first_->job);
      EXPECT_FALSE(result.replay.passed) << checked->program.format;
      ASSERT_FALSE(result.findings.empty());
      const plan::Finding& reported = result.findings.front();
      EXPECT_EQ(reported.kind, cell ? plan::FindingKind::OtherCell : plan::FindingKind::OtherJob);
      EXPECT_TRUE(reported.blocking);
      const std::string line = plan::englishReason(reported);
      for (const char* word : {"part box", cell ? "cell elsewhere" : "cell ur5-fixed", "ur5"})
        EXPECT_NE(line.find(word), std::string::npos) << line;
      // A program of its own job gives no such finding.
      for (const plan::Finding& own : verified(program, planned.job).findings)
        EXPECT_NE(own.kind, reported.kind) << checked->program.format;
    }
}

TEST_F(PlannedBox, WrongJobInAHeadGivesAFinding) {
  const test::TemporaryFolder folder;
  writeProgram(first_->checked.at(0)->program, folder.path());
  plan::ProgramFile file = first_->checked.at(0)->program.files.front();
  const std::size_t at = file.text.find(", job ") + 6;
  ASSERT_GE(at, 6u);
  file.text[at] = file.text[at] == '0' ? '1' : '0';
  base::writeFile(folder / file.name, file.text);
  const VerifyResult result = verified(folder / file.name, first_->job);
  EXPECT_TRUE(result.replay.passed);
  ASSERT_FALSE(result.findings.empty());
  EXPECT_EQ(result.findings.front().kind, plan::FindingKind::OtherJob);
  EXPECT_FALSE(result.findings.front().blocking);
}

TEST_F(PlannedBox, FileWithoutAProgramGivesAnErrorOfOneLine) {
  const test::TemporaryFolder folder;
  writeProgram(first_->checked.at(0)->program, folder.path());
  const std::string text = first_->checked.at(0)->program.files.front().text;
  const struct {
    std::string text;
    const char* reported;
  } cases[] = {{"\xef\xbb\xbf" + text, "byte-order mark"},
               {std::string("\x7f\x45LF\0\0\1", 7), "binary"},
               {"/PROG X\n/MN\n1:J P[1] 100% FINE ;\n/END\n", "no urscript motion found"}};
  for (const auto& c : cases) {
    base::writeFile(folder / "box.script", c.text);
    try {
      verified(folder / "box.script", first_->job);
      ADD_FAILURE() << c.reported;
    } catch (const base::Error& error) {
      EXPECT_EQ(error.code(), base::ErrorCode::UnusableInput);
      EXPECT_NE(base::english(error.whole()).find(c.reported), std::string::npos)
          << base::english(error.whole());
    }
  }
}

TEST_F(PlannedBox, CancelledPlanKeepsFinishedStages) {
  StageCache cache;
  const base::CancelToken token;
  std::shared_ptr<const curved::Decomposition> made;
  EXPECT_THROW(planPart(boxRequest(), base::RunContext(token, 1), &cache,
                        {.onStage =
                             [&](Stage stage, const PlanResult& r) {
                               made = r.job.item().decomposition();
                               if (stage == Stage::Decompose)
                                 token.cancel();
                             }}),
               base::Cancelled);
  PlanRequest again = boxRequest();
  again.until = Stage::Layers;
  EXPECT_EQ(planPart(again, context(), &cache).job.item().decomposition(), made);
}

TEST_F(PlannedBox, PlanHasTheKeysComputedBefore) {
  EXPECT_EQ(first_->job.keys(), stageKeys(boxRequest()));
  PlanRequest early = boxRequest();
  early.until = Stage::Load;
  const StageKeys keys = planPart(early, context()).job.keys();
  EXPECT_EQ(keys[0], first_->job.keys()[0]);
  EXPECT_TRUE(keys[1].empty());
}

TEST_F(PlannedBox, AReopenedProjectPlansOnlyItsProgramsAndTheSameOnes) {
  const test::TemporaryFolder folder;
  writeJob(folder / "job.voluta", first_->job);
  const Job job = readJob(folder / "job.voluta", allParameters());

  EXPECT_EQ(said(job.report), said(first_->job.report));
  const PlanResult shown = resultOf(job);
  EXPECT_EQ(shown.cell->id(), "ur5-fixed");
  EXPECT_EQ(shown.tooling().first().process.id, "fdm-1.0");

  StageCache cache;
  seedCache(cache, job);
  PlanRequest request;
  request.item().loaded = job.item().loaded;
  request.choices = job.choices;
  EXPECT_EQ(stageKeys(request), job.keys());
  const PlanResult planned = planPart(request, context(), &cache);
  EXPECT_EQ(planned.job.item().part, job.item().part);
  EXPECT_EQ(planned.job.item().decomposition(), job.item().decomposition());
  EXPECT_EQ(planned.job.item().layers, job.item().layers);
  EXPECT_EQ(planned.job.toolPlan, job.toolPlan);
  EXPECT_EQ(planned.job.trajectory, job.trajectory);
  EXPECT_EQ(said(planned.job.report), said(first_->job.report));
  expectSamePrograms(planned, *first_);

  // From the part alone the same comes out again.
  const PlanResult fresh = planPart(request, context());
  EXPECT_NE(fresh.job.item().layers, job.item().layers);
  expectSamePrograms(fresh, *first_);
}

TEST_F(PlannedBox, EveryPointHasItsLine) {
  const plan::Trajectory& t = *first_->job.trajectory;
  for (const auto& checked : first_->checked) {
    const std::vector<TextLine> lines = linesOfPoints(*checked, t);
    ASSERT_EQ(lines.size(), t.pointCount()) << checked->program.format;
    const auto& files = checked->program.files;
    std::set<std::uint32_t> moving;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      ASSERT_LT(lines[i].file, files.size());
      moving.insert(lines[i].file);
      // Pieces of a joint motion are one line. Files are run in their order, each from its first
      // line on.
      const bool piece =
          i > 1 && t.move[i] == plan::MoveKind::Joint && t.move[i - 1] == plan::MoveKind::Joint;
      const bool sameFile = i > 0 && lines[i].file == lines[i - 1].file;
      ASSERT_TRUE(i == 0 || sameFile || lines[i].file == lines[i - 1].file + 1u);
      ASSERT_GT(lines[i].line + (sameFile && piece ? 1u : 0u), sameFile ? lines[i - 1].line : 0u)
          << checked->program.format;
      ASSERT_LE(lines[i].line, std::ranges::count(files[lines[i].file].text, '\n'));
    }
    // All but the file that calls the others.
    EXPECT_EQ(moving.size(), std::max<std::size_t>(1, files.size() - 1)) << checked->program.format;
  }
  // The joint table has time and first joint in each line.
  const CheckedProgram& csv = *first_->checked[2];
  ASSERT_EQ(csv.program.format, "csv");
  std::vector<std::string> text{""}; // lines count from 1
  std::istringstream in(csv.program.files[0].text);
  for (std::string line; std::getline(in, line);)
    text.push_back(line);
  const std::vector<TextLine> lines = linesOfPoints(csv, t);
  for (std::size_t i = 0; i < lines.size(); i += 37) {
    double time = -1.0, degrees = 0.0;
    ASSERT_EQ(std::sscanf(text.at(lines[i].line).c_str(), "%lf,%lf", &time, &degrees), 2);
    EXPECT_NEAR(time, t.timeS[i], 1e-5);
    EXPECT_NEAR(base::degreesToRadians(degrees), t.at(i)[0], 1e-6);
  }
  // A text that ends early has no lines for its missing points.
  CheckedProgram cut = csv;
  cut.pointLines.resize(5);
  EXPECT_GT(linesOfPoints(cut, t)[4].line, 0u);
  EXPECT_EQ(linesOfPoints(cut, t)[5].line, 0u);
}

TEST_F(PlannedBox, AHollowBoxIsSafeToRunAndNotAsAsked) {
  const PlanRequest request = boxRequest({{"infillDensity", "0"}, {"quality", "strict"}});
  const PlanResult hollow = planPart(request, context(), cache_);
  ASSERT_EQ(hollow.checked.size(), 3u);
  for (const auto& checked : hollow.checked) {
    EXPECT_FALSE(checked->verdict.passed);
    ASSERT_FALSE(checked->failed.empty());
    EXPECT_THAT(base::english(checked->failed),
                testing::Contains(testing::HasSubstr("unsupportedFraction")));
    EXPECT_FALSE(checked->program.files.empty());
    EXPECT_GT(checked->verdict.unsupportedFraction, 0.005);
    EXPECT_EQ(checked->findingLines.size(), checked->findings.size());
    EXPECT_TRUE(checked->safeToRun);
    EXPECT_EQ(writtenName(*checked, {"box.csv", ""}), "box.csv");
    CheckedProgram unsafe = *checked;
    unsafe.safeToRun = false;
    EXPECT_EQ(writtenName(unsafe, {"box.csv", ""}), "refused-box.csv");
  }
  EXPECT_TRUE(first_->checked[0]->verdict.passed);
  EXPECT_EQ(writtenName(*first_->checked[0], {"box.csv", ""}), "box.csv");
}

// ---- load

PlanResult placed(const std::shared_ptr<const LoadedPart>& part, const Choices& choices) {
  PlanRequest request;
  request.item().loaded = part;
  request.choices = choices;
  request.until = Stage::Load;
  return planPart(request, context());
}

TEST(Load, PartIsScaledTurnedAndMovedByItsPlacement) {
  Choices choices;
  choices.item().placement.rotation = geometry::rotationLayingFlat({1, 0, 0});
  choices.item().placement.centreMm = {5, 6};
  choices.item().placement.liftMm = 0.25;
  choices.item().scale = "2";
  const PlanResult result = placed(boxPart(), choices);
  const Eigen::AlignedBox3d box = geometry::bounds(*result.job.item().part);
  EXPECT_LT((box.min() - Eigen::Vector3d(-3, -12, 0.25)).norm(), 1e-9) << box.min().transpose();
  EXPECT_LT((box.max() - Eigen::Vector3d(13, 24, 40.25)).norm(), 1e-9) << box.max().transpose();
  EXPECT_NEAR(result.job.report.item().model.boundsMm.max().z(), 40.25, 1e-9);
  EXPECT_NEAR(result.job.report.item().model.volumeMm3, 8 * 20 * 18 * 8, 1e-6);
  EXPECT_EQ(result.job.report.item().model.file, "box.stl");
}

TEST(Load, WithoutRepairTheMeshIsAsItWasRead) {
  auto open = *boxPart()->source;
  open.triangles.pop_back();
  const auto source = std::make_shared<geometry::TriangleMesh>(open);
  const auto mended = loadedFrom("open.stl", source, {}, true, {});
  EXPECT_EQ(mended->mesh->triangles.size(), 12u);
  EXPECT_EQ(mended->found.boundaryEdges.count, 3u);
  EXPECT_TRUE(mended->remains.empty());
  Choices choices;
  choices.item().repair = false;
  const PlanResult raw = placed(mended, choices);
  EXPECT_EQ(raw.job.item().part->triangles.size(), 11u);
  EXPECT_FALSE(raw.job.report.item().model.watertight);
  ASSERT_FALSE(raw.job.report.findings.empty());
  EXPECT_EQ(voluta::plan::reportId(raw.job.report.findings[0]), "meshDefect");
  EXPECT_FALSE(raw.job.item().loaded->repair);
  EXPECT_EQ(raw.job.item().loaded->mesh, source) << "no copy";
  // And back.
  const auto again = withRepair(raw.job.item().loaded, true, {});
  EXPECT_EQ(again->mesh->triangles, mended->mesh->triangles);
  EXPECT_EQ(again->notes, mended->notes);
  EXPECT_EQ(again->hash, mended->hash);
}

TEST(Load, AMeshWithoutDefectsIsNotCopied) {
  EXPECT_EQ(boxPart()->mesh, boxPart()->source);
}

} // namespace
