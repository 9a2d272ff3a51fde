// Tool-paths that come with a part: others' files end as checked programs, and a plan of ours that
// is written as a build file and read back is printed along the same beads.
#include "base/error.h"
#include "base/files.h"
#include "box_request.h"
#include "build3mf/build_writer.h"
#include "build3mf/foreign_package.h"
#include "geometry/measures.h"
#include "helpers/temporary_folder.h"
#include "layers/layer_stack.h"
#include "pipeline/checked_program.h"
#include "pipeline/given_paths.h"
#include "pipeline/outputs.h"
#include "pipeline/plan_reasons.h"
#include "pipeline/road.h"
#include "pipeline/stage_options.h"
#include "plan/finding_kinds.h"
#include "process/bead_model.h"
#include "project/job.h"
#include "project/loaded_part.h"
#include "sliced/sliced_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>

using namespace voluta;
using namespace voluta::pipeline;

namespace {

const base::RunContext kCtx;

// A possible file of a slicer for a router with a tilting spindle: tenths of a millimetre in
// inches' place taken by centimetres, one long line a row and no points between, frames that look
// down into the part and are turned about it by a half, sections by a constant modifier, rows of
// every other layer across.
std::string routersFile(bool withObject) {
  constexpr double kWidth = 1.2, kHeight = 0.8;
  const double hatch = process::hatchOf(kWidth, kHeight);
  constexpr int kRows = 18, kLayers = 6;
  const double side = kRows * hatch;
  test::ForeignBuild file;
  file.unit = "centimeter";
  file.unitFactor = "0.0001"; // a micrometre
  file.profile = "uuid=\"00000000-0000-0000-0000-00000000000a\" name=\"hatching\" "
                 "beadwidth=\"2\" beadheight=\"0.8\" depositionspeed=\"20\"";
  file.modifiers = "<tp:modifier attribute=\"beadwidth\" type=\"constant\" minvalue=\"1\" "
                   "maxvalue=\"2\" factor=\"h\"/>";
  const auto point = [](double x, double y, double z) {
    return fmt::format("<point6d x=\"{}\" y=\"{}\" z=\"{}\" i=\"0.70710678\" j=\"0.70710678\" "
                       "k=\"0\" w=\"0\" h=\"0.2\"/>",
                       std::llround(1e3 * x), std::llround(1e3 * y), std::llround(1e3 * z));
  };
  for (int layer = 0; layer < kLayers; ++layer) {
    std::string points;
    for (int row = 0; row < kRows; ++row) {
      const double across = (row + 0.5) * hatch, z = (layer + 1) * kHeight;
      // A turn is half a hatch within the edge, so that the material is the box's.
      for (const double along : {0.5 * hatch, side - 0.5 * hatch}) {
        const double l = row % 2 ? side - along : along;
        points += layer % 2 ? point(100 + across, 50 + l, z) : point(100 + l, 50 + across, z);
      }
    }
    file.layers.push_back(test::foreignLayer(test::foreignSegment("polyline6d", points)));
  }
  if (withObject) {
    const geometry::TriangleMesh box =
        test::box({10, 5, 0}, {10 + 0.1 * side, 5 + 0.1 * side, 0.1 * kLayers * kHeight}); // cm
    file.object = "<object id=\"7\"><mesh><vertices>";
    for (const auto& v : box.vertices)
      file.object += fmt::format("<vertex x=\"{}\" y=\"{}\" z=\"{}\"/>", v.x(), v.y(), v.z());
    file.object += "</vertices><triangles>";
    for (const auto& t : box.triangles)
      file.object += fmt::format("<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>", t[0], t[1], t[2]);
    file.object += "</triangles></mesh></object>";
  }
  return file.bytes();
}

PlanResult plannedFrom(const std::string& bytes, const std::string& name = "router.build.3mf") {
  const test::TemporaryFolder folder;
  base::writeFile(folder / name, bytes);
  PlanRequest request;
  request.item().part = (folder / name).string();
  request.choices.item().automatic = true;
  return planPart(request, kCtx);
}

TEST(GivenPaths, AnotherToolsFileEndsAsACheckedProgram) {
  const PlanResult planned = plannedFrom(routersFile(true));
  EXPECT_TRUE(nothingBlocks(planned.job.report)) << test::reasons(planned);
  EXPECT_TRUE(planned.job.report.replay.passed) << test::reasons(planned);
  for (const auto& checked : planned.checked)
    EXPECT_TRUE(checked->verdict.passed) << checked->program.format;
  EXPECT_EQ(planned.job.report.toolpath.paths, 6u);
  EXPECT_EQ(planned.job.report.item().layers.count, 6);
  // The file has it off the origin in centimetres; the plan has it in the middle of the plate, and
  // upright.
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& p : planned.job.toolPlan->position)
    box.extend(p);
  EXPECT_LT(box.center().head<2>().norm(), 1e-3);
  EXPECT_NEAR(box.max().z(), 4.8, 1e-6);
  EXPECT_LT((planned.job.toolPlan->direction[3] - Eigen::Vector3d::UnitZ()).norm(), 1e-6);
  // Long lines get waypoints.
  for (const plan::ToolPath& path : planned.job.toolPlan->paths)
    for (std::size_t i = path.first + 1; i < path.first + path.count; ++i)
      EXPECT_LE((planned.job.toolPlan->position[i] - planned.job.toolPlan->position[i - 1]).norm(),
                1.5 * planned.tooling().first().process.stepMm);
}

TEST(GivenPaths, WithoutAnObjectTheirBeadsAreTheReference) {
  const PlanResult planned = plannedFrom(routersFile(false));
  EXPECT_TRUE(nothingBlocks(planned.job.report)) << test::reasons(planned);
  EXPECT_NEAR(planned.job.report.replay.massRatio, 1.0, 0.03);
}

TEST(GivenPaths, APlanOfOursIsPrintedAlongTheSameBeads) {
  PlanRequest request = test::boxRequest();
  request.choices.item().placement.centreMm = {12, -5}; // the work frame is kept, wherever it is
  request.choices.parameters["output.build3mf"] = "true";
  PlanResult planned = planPart(request, kCtx);
  ASSERT_TRUE(nothingBlocks(planned.job.report)) << test::reasons(planned);
  const test::TemporaryFolder folder;
  writeOutputs(planned, folder.path(), kCtx);
  const std::string name = buildName(planned);
  ASSERT_TRUE(std::filesystem::exists(folder / name));
  const PlanResult again = plannedFrom(base::readFile(folder / name), name);
  EXPECT_TRUE(nothingBlocks(again.job.report)) << test::reasons(again);
  const plan::ToolPlan &a = *planned.job.toolPlan, &b = *again.job.toolPlan;
  ASSERT_EQ(a.waypointCount(), b.waypointCount());
  ASSERT_EQ(a.paths.size(), b.paths.size());
  for (std::size_t i = 0; i < a.waypointCount(); ++i) {
    EXPECT_LE((a.position[i] - b.position[i]).norm(), 1e-3);
    EXPECT_LE((a.direction[i] - b.direction[i]).norm(), 1e-6);
    EXPECT_NEAR(process::beadArea(a.widthMm[i], a.heightMm[i]) /
                    process::beadArea(b.widthMm[i], b.heightMm[i]),
                1.0, 1e-3);
  }
}

TEST(GivenPaths, ObjectIsPlannedAnewOnRequest) {
  const test::TemporaryFolder folder;
  base::writeFile(folder / "router.build.3mf", routersFile(true));
  PlanRequest request;
  request.item().part = (folder / "router.build.3mf").string();
  request.choices.item().mode = "flat";
  request.choices.item().parameters["givenToolPaths"] = "false";
  request.until = project::Stage::Layers;
  const PlanResult planned = planPart(request, kCtx);
  EXPECT_FALSE(planned.job.item().layers->patches.empty());
}

TEST(GivenPaths, AnotherSizeIsRefused) {
  const test::TemporaryFolder folder;
  base::writeFile(folder / "router.build.3mf", routersFile(true));
  PlanRequest request;
  request.item().part = (folder / "router.build.3mf").string();
  request.choices.item().mode = "flat";
  request.choices.item().scale = "2";
  EXPECT_THROW(planPart(request, kCtx), base::Error);
}

// One straight bead of a file that has this profile, as far as its tool-paths.
PlanResult beadOfProfile(const std::string& profile) {
  test::ForeignBuild file;
  file.profile = profile;
  file.layers = {test::foreignLayer(
      test::foreignSegment("polyline6d", test::point6d(0, 0, 800) + test::point6d(9000, 0, 800)))};
  const test::TemporaryFolder folder;
  base::writeFile(folder / "a.3mf", file.bytes());
  PlanRequest request;
  request.item().part = (folder / "a.3mf").string();
  request.choices.item().mode = "flat";
  request.until = project::Stage::Toolpath;
  return planPart(request, kCtx);
}

TEST(GivenPaths, ProcessFillsValuesMissingInTheFile) {
  const PlanResult planned =
      beadOfProfile("uuid=\"00000000-0000-0000-0000-00000000000a\" name=\"n\" beadheight=\"0.8\" "
                    "beadwidth=\"1.2\"");
  EXPECT_FLOAT_EQ(planned.job.toolPlan->speedMmPerS[1],
                  static_cast<float>(planned.tooling().first().process.speedMmPerS));
  EXPECT_TRUE(std::ranges::any_of(planned.job.report.findings, [](const plan::Finding& f) {
    return f.kind == plan::FindingKind::GivenWithoutSection && !f.blocking;
  }));
}

TEST(GivenPaths, NoMoreThanTheExtruderGives) {
  const PlanResult planned =
      beadOfProfile("uuid=\"00000000-0000-0000-0000-00000000000a\" name=\"n\" beadheight=\"0.8\" "
                    "beadwidth=\"1.2\" depositionspeed=\"2000\"");
  const plan::ToolPlan& plan = *planned.job.toolPlan;
  EXPECT_LE(plan.speedMmPerS[1] * process::beadArea(1.2, 0.8),
            1.0001 * planned.tooling().first().process.maxFlowMm3PerS);
  EXPECT_TRUE(std::ranges::any_of(planned.job.report.findings, [](const plan::Finding& f) {
    return f.kind == plan::FindingKind::GivenTooFast;
  }));
}

TEST(GivenPaths, WorstBeadOutsideTheProcessGivesTheFinding) {
  const auto findingFor = [](const std::string& section) -> std::optional<plan::Finding> {
    const PlanResult planned =
        beadOfProfile("uuid=\"00000000-0000-0000-0000-00000000000a\" name=\"n\" " + section);
    const plan::Findings& all = planned.job.report.findings;
    const auto found =
        std::ranges::find(all, plan::FindingKind::GivenOutsideLimits, &plan::Finding::kind);
    return found == all.end() ? std::nullopt : std::optional(*found);
  };
  // fdm-1.0: width 1 to 2, height 0.4 to 1
  EXPECT_FALSE(findingFor("beadheight=\"0.8\" beadwidth=\"1.2\""));
  for (const char* section :
       {"beadheight=\"0.8\" beadwidth=\"2.5\"", "beadheight=\"0.6\" beadwidth=\"0.8\"",
        "beadheight=\"0.3\" beadwidth=\"1.2\"", "beadheight=\"1.2\" beadwidth=\"1.8\""}) {
    const std::optional<plan::Finding> finding = findingFor(section);
    ASSERT_TRUE(finding) << section;
    EXPECT_FALSE(finding->blocking);
    ASSERT_TRUE(finding->where) << section;
    EXPECT_NE(plan::englishReason(*finding).find("9 mm of the file's beads are outside"),
              std::string::npos)
        << plan::englishReason(*finding);
  }
}

// Turning the part or another way of building does not change the tool-paths of a file.
TEST(GivenPaths, RemediesForGivenPathsReferToTheSlicer) {
  using enum plan::FindingKind;
  plan::Findings planned{
      plan::makeFinding(Unsupported, {{"length", base::mm(7.0)}, {"share", base::percent(1.0)}}),
      plan::makeFinding(LongBridge, {{"length", base::mm(9.0)}, {"bridge", base::mm(6.0)}}),
      plan::makeFinding(Mass, {{"share", base::percent(112.0)}}),
      plan::makeFinding(Uncovered, {{"share", base::percent(5.0)}}),
      plan::makeFinding(Overfill,
                        {{"outside", base::percent(1.0)}, {"noRoom", base::percent(5.0)}})};
  const plan::Findings given = withRemediesForGiven(planned, {true});
  ASSERT_EQ(given.size(), planned.size());
  for (std::size_t i = 0; i < given.size(); ++i) {
    EXPECT_EQ(plan::englishReason(given[i]), plan::englishReason(planned[i]));
    EXPECT_EQ(plan::reportId(given[i]), plan::reportId(planned[i]));
    EXPECT_EQ(given[i].blocking, planned[i].blocking);
    const std::string remedy = plan::englishRemedy(given[i]);
    EXPECT_NE(remedy.find("slice"), std::string::npos) << remedy;
    EXPECT_EQ(remedy.find("turn the part"), std::string::npos) << remedy;
  }
}

namespace {
// Kinds of the stages of which a plan of given paths can have findings, without those that only
// planned layers and paths make.
bool canConcernGiven(const plan::FindingRow& row) {
  using enum plan::FindingKind;
  constexpr std::array kOfPlanned{Verbatim,
                                  Stopped,
                                  CellsTurned,
                                  CellsLifted,
                                  MeshDefect,
                                  OpenRims,
                                  SheetModel,
                                  RimsClosed,
                                  SheetsLeftOut,
                                  SurfaceThickened,
                                  SurfaceAsWall,
                                  LiesBadly,
                                  TurnedMinRiskyArea,
                                  TurnedFewestMissed,
                                  TurnedMinResidualArea,
                                  TurnedMinAfterCuts,
                                  TurnedAfterCuts,
                                  TurnedLeastTension,
                                  NotTurned,
                                  PatchWithoutBead,
                                  ThinWallsWidened,
                                  ThinWallsLeftOut,
                                  HollowSkin,
                                  SpiralEnds,
                                  SpiralInterrupted,
                                  RimSupports,
                                  PrimeFalls,
                                  BrimCut,
                                  Braced,
                                  Gouge,
                                  Overload,
                                  NoTape,
                                  TapesLeftOut,
                                  TapesBare,
                                  NothingToPrint,
                                  LongShot,
                                  BeyondRod};
  const bool isOfStage = row.stage == plan::Stage::Load || row.stage == plan::Stage::Toolpath ||
                         row.stage == plan::Stage::Motion || row.stage == plan::Stage::Replay;
  return isOfStage && row.kind < PlatesOverlap &&
         std::ranges::find(kOfPlanned, row.kind) == kOfPlanned.end();
}
} // namespace

// The user of a slicer's file moves the part, chooses cell and process, and slices again.
TEST(GivenPaths, NoRemedyAdvisesWhatTheUserOfAFileCannotDo) {
  for (const plan::FindingRow& planned : plan::findingRows()) {
    if (!canConcernGiven(planned))
      continue;
    const plan::FindingRow& row = plan::rowOf(kindForGiven(planned.kind));
    if (planned.kind != plan::FindingKind::Unconnected) { // reported as unreachable
      EXPECT_EQ(row.reportId, planned.reportId) << planned.id;
    }
    EXPECT_EQ(row.concern, planned.concern) << planned.id;
    EXPECT_EQ(row.severity, planned.severity) << planned.id;
    EXPECT_EQ(row.stage, planned.stage) << planned.id;
    for (const std::string_view banned :
         {"turn the part", "turn it", "rotate", "orient", "mode", "add supports", "at scale",
          "--scale", "layer height", "lower layers", "thinner layers", "voxel", "--units",
          "density", "Voluta", "scale the part"}) {
      const bool isSlicers = row.remedy.english().find("slice") != std::string_view::npos;
      EXPECT_TRUE(isSlicers || row.remedy.english().find(banned) == std::string_view::npos)
          << planned.id << ": " << row.remedy.english();
    }
    using enum plan::RemedyId;
    for (const plan::RemedyId banned :
         {ScaleToFit, Shrink, ScaleUp, ScaleToReach, ScaleToPlate, Enlarge, UnitsMetres,
          UnitsInches, UnitsMicrometres, AddSupports, RotateToMinRiskyArea, OrientPart, StandBest,
          PrintFlat, ChooseStrategy, LowerLayers, AdaptLayers})
      EXPECT_EQ(std::ranges::count(row.remedies, banned), 0) << planned.id;
  }
}

// The reason stays as it was, with further ones that are not listed.
TEST(GivenPaths, AFindingKeepsItsReasonAndItsPlace) {
  using enum plan::FindingKind;
  plan::Findings planned{
      plan::makeMoreFinding(Unreachable, {{"place", "layer 3"_name}}, Eigen::Vector3d(1, 2, 3), 7),
      plan::makeFinding(CollisionInMotion, {{"first", "arm"_name}, {"second", "plate"_name}}),
      plan::makeFinding(FlowErrors, {{"share", base::percent(2.0)}})};
  planned[0].whenS = 4.0;
  const plan::Findings given = withRemediesForGiven(planned, {true});
  for (std::size_t i = 0; i < planned.size(); ++i) {
    EXPECT_EQ(plan::englishReason(given[i]), plan::englishReason(planned[i]));
    EXPECT_EQ(given[i].where, planned[i].where);
    EXPECT_EQ(given[i].whenS, planned[i].whenS);
    EXPECT_EQ(given[i].count, planned[i].count);
    EXPECT_EQ(plan::blocksRunning(given[i]), plan::blocksRunning(planned[i]));
  }
  const plan::Findings twice = withRemediesForGiven(given, {true});
  EXPECT_EQ(plan::englishReason(twice[0]), plan::englishReason(given[0]));
  EXPECT_EQ(withRemediesForGiven(planned, {false})[0].kind, Unreachable);
}

// A file that states more material than its tool-paths have is printed, and amber.
TEST(GivenPaths, MaterialThatTheReaderDoesNotKnowIsAFinding) {
  const auto findingOf = [](double stated, double read) {
    project::LoadedPart loaded;
    loaded.readNotes = {base::message(sliced::kAmountNote, base::mm3(stated), base::mm3(read),
                                      base::message("in line {line} first"_text, 12))};
    return amountFindings(loaded);
  };
  EXPECT_TRUE(findingOf(1000.0, 991.0).empty());
  const plan::Findings found = findingOf(1000.0, 950.0);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].blocking);
  EXPECT_FALSE(plan::blocksRunning(found[0]));
  EXPECT_EQ(plan::englishReason(found[0]),
            "the file extrudes 1000 mm3 by its E words, the tool-paths taken from it have 950 mm3; "
            "they part in line 12 first");
}

TEST(GivenPaths, AProjectKeepsThem) {
  const test::TemporaryFolder folder;
  base::writeFile(folder / "router.build.3mf", routersFile(true));
  PlanRequest request;
  request.item().part = (folder / "router.build.3mf").string();
  request.choices.item().mode = "flat";
  request.until = project::Stage::Toolpath;
  const PlanResult planned = planPart(request, kCtx);
  project::writeJob(folder / "job.voluta", planned.job);
  const project::Job again = project::readJob(folder / "job.voluta", allParameters());
  ASSERT_TRUE(again.item().loaded->toolPaths);
  EXPECT_EQ(again.item().loaded->hash, planned.job.item().loaded->hash);
  PlanRequest same;
  same.item().loaded = again.item().loaded;
  same.choices = again.choices;
  PlanRequest anew = same;
  anew.choices.item().parameters["givenToolPaths"] = "false";
  EXPECT_NE(stageKeys(anew)[0], stageKeys(same)[0]);
  EXPECT_EQ(stageKeys(same)[project::indexOf(project::Stage::Toolpath)],
            again.stages[project::indexOf(project::Stage::Toolpath)].key);
}

} // namespace
