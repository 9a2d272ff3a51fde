#include "base/error.h"
#include "base/files.h"
#include "base/run_context.h"
#include "helpers/temporary_folder.h"
#include "pipeline/outputs.h"
#include "plan/finding_kinds.h"
#include "project/report.h"

#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace voluta;

namespace {

// docs/design.md, Report, word for word: a missing key breaks other people's programs.
const std::map<std::string, std::vector<std::string>> kKeys = {
    {"model", {"file", "scale", "triangles", "watertight", "volumeMm3", "boundsMm", "repairs"}},
    {"decomposition",
     {"mode", "growth", "voxelMm", "voxels", "layers", "missedVoxels", "shadowedVoxels",
      "unreachedVoxels", "missedAfterSupports", "supportVolumeMm3", "pieces", "riskyAreaMm2",
      "riskyAreaBeforeMm2", "pieceList"}},
    {"layers",
     {"count", "areaMm2", "thicknessMeanMm", "thicknessStdMm", "thicknessP01Mm", "thicknessP99Mm",
      "withinLimitsFraction", "stepMeanMm", "stepMaxMm"}},
    {"toolpath",
     {"paths",
      "waypoints",
      "lengthMm",
      "travelMm",
      "starts",
      "simpleRegions",
      "coveredFraction",
      "overlapFraction",
      "gouges",
      "maxTurnDeg",
      "materialMm3",
      "sparseMm3",
      "sparseBeadMm3",
      "tapes",
      "tapeMm",
      "tapeG",
      "tapeCoveredFraction",
      "tapeOverlapFraction",
      "tapeBareMm",
      "shots",
      "shotMm3",
      "strength"}},
    {"motion",
     {"robot",
      "cell",
      "waypoints",
      "unreachable",
      "collisions",
      "splits",
      "maxJerk",
      "sumSquaredJerk",
      "sumSquaredJerkBefore",
      "maxJerkBefore",
      "maxJerkAtS",
      "maxTravelJerk",
      "maxTravelJerkAtS",
      "jerkSlowedS",
      "minClearanceMm",
      "minClearanceAtS",
      "durationS",
      "toolChanges",
      "waits",
      "waitS"}},
    {"replay",
     {"passed", "safeToRun", "coveredFraction", "unsupportedFraction", "halfCarriedFraction",
      "longestUnsupportedMm", "overfillFraction", "massRatio", "collisions", "limitViolations",
      "maxDeviationMm", "controllerDurationS", "flowErrorFraction", "shortestLayerTimeS",
      "meanLayerTimeS", "longestLayerTimeS", "layerTimesMm", "tapeMm3", "thresholds"}},
    {"chosen", {"way", "name", "mode", "platform", "supports", "layerHeightMm"}},
    {"timingS",
     {"load", "repair", "voxelise", "peel", "grow", "smooth", "extract", "trim", "decompose",
      "toolpath", "orient", "ik", "graph", "jerk", "collision", "transfer", "write", "replay",
      "total"}},
};

TEST(Report, EveryKeyIsThereEvenWhenEmpty) {
  project::Report report;
  report.programs.emplace_back();
  report.findings.emplace_back();
  const nlohmann::json j = nlohmann::json::parse(project::reportJson(report));
  for (const auto& [section, keys] : kKeys)
    for (const std::string& key : keys)
      EXPECT_TRUE(j.at(section).contains(key)) << section << "." << key;
  for (const char* key :
       {"format", "foreign", "files", "bytes", "maxDeviationMm", "maxDeviationRad", "durationS",
        "flowErrorFraction", "massRatio", "state"})
    EXPECT_TRUE(j.at("programs")[0].contains(key)) << key;
  for (const char* key : {"stage", "kind", "where", "when", "count", "reason", "remedy", "blocking",
                          "concerns", "values"})
    EXPECT_TRUE(j.at("findings")[0].contains(key)) << key;
  for (const char* key :
       {"verdict", "safeToRun", "printsAsAsked", "peakRssMb", "threads", "version"})
    EXPECT_TRUE(j.contains(key)) << key;
}

// The first finding of a plan that failed is the reason for it.
TEST(Report, BlockingFindingsAreWrittenFirst) {
  pipeline::PlanResult plan;
  plan.proofs = false;
  using enum plan::FindingKind;
  for (const plan::FindingKind kind : {LiesBadly, PatchWithoutBead, Overfill, Uncovered, Mass}) {
    plan::Finding& finding = plan.job.report.findings.emplace_back();
    finding.kind = kind;
    finding.blocking = kind == Uncovered || kind == Mass;
  }
  const plan::Findings before = plan.job.report.findings;
  const test::TemporaryFolder folder;
  pipeline::writeHandover(plan, {}, folder.path(), base::RunContext());
  const nlohmann::json j = nlohmann::json::parse(base::readFile(folder / "report.json"));
  std::vector<std::string> kinds;
  for (const nlohmann::json& row : j.at("findings"))
    kinds.push_back(row.at("kind"));
  EXPECT_EQ(kinds, (std::vector<std::string>{"uncovered", "mass", "liesBadly", "patchWithoutBead",
                                             "overfill"}));
  for (std::size_t i = 0; i < before.size(); ++i) // the job's stay with their stages
    EXPECT_EQ(plan.job.report.findings[i].kind, before[i].kind);
}

TEST(Report, TextThatIsNotUtf8StaysReadable) {
  project::Report report;
  report.item().model.file = "part\xff.stl";
  EXPECT_TRUE(nlohmann::json::accept(project::reportJson(report)));
}

TEST(Report, IsReadBackFromItsText) {
  project::Report report;
  report.item().model.repairs = {base::message("{text}"_text, "closed 1 hole"_name)};
  report.item().model.boundsMm =
      Eigen::AlignedBox3d(Eigen::Vector3d(0.1, 2, 3), Eigen::Vector3d(4, 5, 6));
  report.item().decomposition.growth = "reverse";
  report.item().decomposition.pieceList = {{-1, 12.5, 0.25, {0, 0.6, 0.8}, "white PLA"},
                                           {0, 2.0, 0.0, {1, 0, 0}, "PLA"}};
  report.item().layers.thicknessP01Mm = 1.0 / 3.0;
  report.toolpath.gouges = 3;
  report.motion.maxJerk = {0.5, 1.5};
  report.motion.minClearanceMm = std::nan("");
  report.programs.push_back({"csv", true, {"a.csv"}, 12, 0.25, 0.5});
  report.replay.thresholds.mass = 0.03;
  report.findings.push_back(plan::verbatimFinding(plan::Stage::Motion, "meshDefect", "a", "b"));
  report.findings.back().where = Eigen::Vector3d(1, 2, 3);
  report.findings.back().whenS = 4.5;
  report.findings.back().count = 6;
  report.findings.back().blocking = false;
  report.findings.emplace_back();
  report.timings.jerk = 0.125;
  report.threads = 7;
  const std::string text = project::reportJson(report);
  EXPECT_EQ(project::reportJson(project::readReportJson(text)), text);
  EXPECT_THROW(project::readReportJson("{}"), base::Error);
  EXPECT_THROW(project::readReportJson("report"), base::Error);
}

// Numbers with their unit in the name, for programs; sentences for people.
TEST(Report, FindingsHaveTheirValues) {
  project::Report report;
  report.findings.push_back(
      plan::makeFinding(plan::FindingKind::OverhangOfFlat,
                        {{"area", base::mm2(12.345678)}, {"angle", base::degrees(45.0)}}));
  report.findings.push_back(plan::makeFinding(plan::FindingKind::NoSupport, {{"voxels", 12000}},
                                              Eigen::Vector3d(1, 2, 3), 12000));
  const nlohmann::json j = nlohmann::json::parse(project::reportJson(report));
  const nlohmann::json& overhang = j.at("findings").at(0);
  EXPECT_EQ(overhang.at("kind"), "overhang");
  EXPECT_EQ(overhang.at("stage"), "decompose");
  EXPECT_EQ(overhang.at("blocking"), false);
  EXPECT_EQ(overhang.at("reason"), "12.3 mm2 overhangs by more than 45 degrees");
  EXPECT_EQ(overhang.at("values"),
            nlohmann::json::parse(R"({"areaMm2": 12.345678, "angleDeg": 45.0})"));
  EXPECT_EQ(j.at("findings").at(1).at("values").at("voxels"), 12000);
  EXPECT_EQ(j.at("findings").at(1).at("reason"),
            "no support column from the platform reaches 12000 voxels that would be missed");
}

TEST(Report, ACountWithItsWordIsANumberToo) {
  const auto voxels = [](int count) {
    return base::message("{count} voxel|{count} voxels"_plural, count);
  };
  project::Report report;
  report.findings.push_back(plan::makeFinding(
      plan::FindingKind::SupportColumn,
      {{"voxels", voxels(10)}, {"foot", "the platform"_text}, {"carried", voxels(1)}}));
  const nlohmann::json j = nlohmann::json::parse(project::reportJson(report));
  const nlohmann::json& column = j.at("findings").at(0);
  EXPECT_EQ(
      column.at("reason"),
      "support column of 10 voxels from the platform: it carries 1 voxel that would be missed");
  EXPECT_EQ(column.at("values"),
            nlohmann::json::parse(R"({"voxels": 10, "foot": "the platform", "carried": 1})"));
}

} // namespace
