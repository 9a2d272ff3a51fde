// The two verdicts: a program that is safe to run is released, whether or not it prints the part
// as asked, and how far the part may differ is the user's choice.
#include "base/error.h"
#include "base/files.h"
#include "geometry/append_mesh.h"
#include "helpers/shapes.h"
#include "helpers/temporary_folder.h"
#include "pipeline/box_request.h"
#include "pipeline/checked_program.h"
#include "pipeline/head_verdict.h"
#include "pipeline/outputs.h"
#include "pipeline/plan_verdict.h"
#include "pipeline/quality.h"
#include "pipeline/remedies.h"
#include "pipeline/replay_stage.h"
#include "pipeline/resume.h"
#include "pipeline/stage_options.h"
#include "plan/finding_kinds.h"
#include "program/dialect.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <gtest/gtest.h>
#include <memory>
#include <nlohmann/json.hpp>

using namespace voluta;
using namespace voluta::pipeline;

namespace {

Quality qualityWith(const std::string& level, const std::string& accept = {}) {
  base::ParameterValues values(qualityParameters());
  values.set("quality", level);
  values.set("accept", accept);
  return qualityOf(values);
}

std::string refusalOf(const std::string& accept) {
  try {
    qualityWith("strict", accept);
  } catch (const base::Error& error) {
    return base::english(error.whole());
  }
  return {};
}

// A prism whose corners are sharper than a bead.
geometry::TriangleMesh sharpPrism() {
  geometry::TriangleMesh mesh;
  for (const double z : {0.0, 6.0})
    for (const auto& [x, y] : {std::pair{-7.0, -3.0}, std::pair{7.0, -3.0}, std::pair{0.0, 3.5}})
      mesh.vertices.emplace_back(x, y, z);
  mesh.triangles = {{0, 2, 1}, {3, 4, 5}};
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    mesh.triangles.push_back({i, j, j + 3});
    mesh.triangles.push_back({i, j + 3, i + 3});
  }
  return mesh;
}

PlanRequest prismRequest(const std::map<std::string, std::string>& parameters) {
  static const auto kPart = project::loadedFrom(
      "prism.stl", std::make_shared<geometry::TriangleMesh>(sharpPrism()), {}, true, {});
  PlanRequest request = test::boxRequest(parameters);
  request.item().loaded = kPart;
  request.choices.item().mode = "flat";
  request.choices.formats = {"urscript"};
  return request;
}

const plan::Finding* uncovered(const PlanResult& plan) {
  const auto found = std::ranges::find(plan.job.report.findings, plan::FindingKind::Uncovered,
                                       &plan::Finding::kind);
  return found == plan.job.report.findings.end() ? nullptr : &*found;
}

} // namespace

TEST(Quality, StrictIsTheReplaysOwn) {
  const replay::ReplayThresholds own, strict = thresholdsOf(qualityWith("strict"));
  EXPECT_DOUBLE_EQ(strict.coveredMin, own.coveredMin);
  EXPECT_DOUBLE_EQ(strict.unsupportedMax, own.unsupportedMax);
  EXPECT_DOUBLE_EQ(strict.overfillMax, own.overfillMax);
  EXPECT_DOUBLE_EQ(strict.massTolerance, own.massTolerance);
  EXPECT_DOUBLE_EQ(strict.thinMax, own.thinMax);
}

// Whatever the quality, the limits of safety stay the same.
TEST(Quality, ALevelIsMoreLenientThanTheOneBeforeAndAsSafe) {
  const replay::ReplayThresholds own;
  for (std::size_t i = 0; i < qualityLevels().size(); ++i) {
    const replay::ReplayThresholds limits =
        thresholdsOf(qualityWith(std::string(qualityLevels()[i].id)));
    EXPECT_EQ(limits.collisionsMax, own.collisionsMax);
    EXPECT_EQ(limits.limitViolationsMax, own.limitViolationsMax);
    EXPECT_EQ(limits.deviationMaxMm, own.deviationMaxMm);
    EXPECT_EQ(limits.flowErrorMax, own.flowErrorMax);
    for (std::size_t k = 0; i > 0 && k < qualityFigures().size(); ++k)
      EXPECT_GT(qualityLevels()[i].shares[k], qualityLevels()[i - 1].shares[k]);
  }
}

TEST(Quality, AnAcceptedShareReplacesAStricterLimitOnly) {
  const replay::ReplayThresholds limits =
      thresholdsOf(qualityWith("strict", "uncovered=0.05, mass=0.01,overfill=0.2"));
  EXPECT_DOUBLE_EQ(limits.coveredMin, 0.95);
  EXPECT_DOUBLE_EQ(limits.massTolerance, 0.03);
  EXPECT_DOUBLE_EQ(limits.overfillMax, 0.2);
  EXPECT_DOUBLE_EQ(limits.unsupportedMax, 0.005);
  EXPECT_EQ(textOf(qualityWith("strict", " overfill=0.2 ,mass=0.01").accepted),
            "overfill=0.2, mass=0.01");
  EXPECT_EQ(textOf(qualityWith("strict", "mass=0.2, overfill=0.2, mass=0.1").accepted),
            "overfill=0.2, mass=0.1")
      << "the last one counts";
}

// An acceptance that is stricter than the level accepts nothing, and no report lists it.
TEST(Quality, AShareWithinTheLevelIsNotListedAsAccepted) {
  const auto listed = [](const std::string& level, const std::string& accept) {
    const Quality quality = qualityWith(level, accept);
    return replayReport({}, quality).thresholds.accepted;
  };
  EXPECT_EQ(listed("usual", "uncovered=0.05"), "");
  EXPECT_EQ(listed("usual", "uncovered=0.06"), "");
  EXPECT_EQ(listed("strict", "uncovered=0.05"), "uncovered=0.05");
  EXPECT_EQ(listed("usual", "uncovered=0.05, mass=0.08"), "mass=0.08");
  EXPECT_EQ(listed("draft", "uncovered=0.05, mass=0.08"), "");
}

TEST(Quality, AListThatIsNoneIsRefused) {
  EXPECT_NE(refusalOf("uncoverd=0.05").find("uncovered"), std::string::npos);
  EXPECT_NE(refusalOf("uncovered=2").find("0 to 1"), std::string::npos) << refusalOf("uncovered=2");
  EXPECT_FALSE(refusalOf("uncovered").empty());
  EXPECT_FALSE(refusalOf("uncovered=nan").empty());
  EXPECT_FALSE(refusalOf("collisions=1").empty());
  EXPECT_TRUE(refusalOf("").empty());
}

// The share of the finding, rounded up, is within the limit that it makes.
TEST(Quality, AcceptingAFindingMakesALimitThatItKeeps) {
  using enum plan::FindingKind;
  const auto accepted = [](const plan::Finding& finding) {
    return acceptedWith(qualityWith("strict", "mass=0.07"), finding).value_or("none");
  };
  EXPECT_EQ(accepted(plan::makeFinding(Uncovered, {{"share", base::percent(4.2)}})),
            "mass=0.07, uncovered=0.045");
  EXPECT_EQ(accepted(plan::makeFinding(Mass, {{"share", base::percent(91.9)}})), "mass=0.085");
  EXPECT_EQ(accepted(plan::makeFinding(GivenMass, {{"share", base::percent(108.1)}})),
            "mass=0.085");
  EXPECT_EQ(accepted(plan::makeFinding(
                Overfill, {{"outside", base::percent(2.0)}, {"noRoom", base::percent(2.1)}})),
            "mass=0.07, overfill=0.045");
  EXPECT_EQ(accepted(plan::makeFinding(Unsupported,
                                       {{"length", base::mm(9.0)}, {"share", base::percent(1.0)}})),
            "mass=0.07, unsupported=0.01");
  EXPECT_EQ(accepted(plan::makeFinding(Thin, {{"share", base::percent(4.6)},
                                              {"volume", base::mm3(12.0)},
                                              {"bead", base::mm(0.4)},
                                              {"places", std::size_t{4}}})),
            "mass=0.07, thin=0.05");
  EXPECT_EQ(accepted(plan::makeFinding(NothingToPrint)), "none");
}

// Its program is written under its own name, marked; accepting the finding gives it a pass, and the
// report lists what was accepted.
TEST(Quality, ASafeProgramIsReleasedAndSaysThatThePartDiffers) {
  PlanResult plan = planPart(prismRequest({{"quality", "strict"}}), base::RunContext());
  const project::Report& report = plan.job.report;
  ASSERT_LT(report.replay.coveredFraction, 0.97) << "the prism is no example";
  EXPECT_TRUE(report.replay.safeToRun);
  EXPECT_FALSE(report.replay.passed);
  EXPECT_FALSE(nothingBlocks(report));
  ASSERT_EQ(verdictOf(report), PlanVerdict::NotAsAsked);
  ASSERT_EQ(plan.checked.size(), 1u);
  EXPECT_EQ(verdictOf(*plan.checked[0], report), PlanVerdict::NotAsAsked);
  const test::TemporaryFolder folder;
  writeOutputs(plan, folder.path(), base::RunContext());
  const std::string name = plan.checked[0]->program.files[0].name;
  EXPECT_TRUE(std::filesystem::exists(folder / name));
  EXPECT_FALSE(std::filesystem::exists(folder / ("refused-" + name)));
  const std::string page = base::readFile(folder / (name + ".proof.html"));
  EXPECT_NE(page.find("Safe to run, but it does not print the part as asked."), std::string::npos);
  EXPECT_EQ(page.find("Refused"), std::string::npos);
  EXPECT_EQ(verdictOf(verifyProgram(folder / name, folder / "job.voluta", base::RunContext())),
            PlanVerdict::NotAsAsked);

  const auto json = nlohmann::json::parse(base::readFile(folder / "report.json"));
  EXPECT_EQ(json.at("verdict"), "differs");
  EXPECT_EQ(json.at("safeToRun"), true);
  EXPECT_EQ(json.at("printsAsAsked"), false);
  EXPECT_EQ(json.at("programs").at(0).at("state"), "released");
  EXPECT_EQ(json.at("programs").at(0).at("files").at(0), name);
  const auto proof = nlohmann::json::parse(base::readFile(folder / (name + ".proof.json")));
  EXPECT_EQ(proof.at("replay").at("verdict"), "differs");

  ASSERT_NE(uncovered(plan), nullptr);
  const std::vector<RemedyAction> offers = remediesFor(*uncovered(plan), plan.job.choices);
  const auto accept = std::ranges::find_if(offers, [](const RemedyAction& action) {
    return action.remedy->id == plan::RemedyId::AcceptShare;
  });
  ASSERT_NE(accept, offers.end());
  PlanRequest again = prismRequest({});
  again.choices = accept->choices;
  PlanResult passed = planPart(again, base::RunContext());
  EXPECT_EQ(verdictOf(passed.job.report), PlanVerdict::Passed);
  EXPECT_EQ(passed.job.report.replay.coveredFraction, report.replay.coveredFraction);
  EXPECT_EQ(passed.job.report.replay.thresholds.accepted, accept->choices.parameters.at("accept"));
  const test::TemporaryFolder second;
  writeOutputs(passed, second.path(), base::RunContext());
  // The heads differ in their verdicts, and nothing else.
  const std::string amber = base::readFile(folder / name), green = base::readFile(second / name);
  const auto without = [](std::string text) {
    const std::size_t at = text.find("# replay: ");
    EXPECT_NE(at, std::string::npos);
    return text.erase(at, text.find('\n', at) - at);
  };
  EXPECT_EQ(without(amber), without(green));
  EXPECT_NE(
      green.find("# replay: safe to run; prints the part with accepted differences: uncovered="),
      std::string::npos);
  EXPECT_NE(amber.find("# replay: safe to run; differs from the part: "), std::string::npos);
  EXPECT_NE(amber.find(" % not covered at ("), std::string::npos);
  EXPECT_LT(amber.find("# replay: "), amber.find("movej"));
  EXPECT_NE(base::readFile(second / (name + ".proof.html")).find("accepted: uncovered=0."),
            std::string::npos);
}

// The verdict is a comment in every language, and the reader finds the same program.
TEST(Quality, EveryFormatStatesTheVerdictInItsHead) {
  std::size_t stated = 0;
  for (const program::Dialect& dialect : program::dialects()) {
    PlanRequest request = prismRequest({{"quality", "strict"}});
    request.choices.formats = {std::string(dialect.id)};
    PlanResult plan;
    try {
      plan = planPart(request, base::RunContext());
    } catch (const base::Error&) {
      continue; // not of this cell
    }
    if (plan.checked.empty() || !plan.checked[0]->safeToRun)
      continue;
    ++stated;
    bool isStated = false;
    for (const plan::ProgramFile& file : plan.checked[0]->program.files) {
      const std::size_t at = file.text.find("replay: safe to run; differs from the part: ");
      if (at == std::string::npos)
        continue;
      isStated = true;
      const std::size_t begin = file.text.rfind('\n', at) + 1;
      const std::string before = file.text.substr(begin, at - begin); // A number and a mark
      EXPECT_TRUE(std::ranges::none_of(before, [](unsigned char c) { return std::isalpha(c); }))
          << dialect.id << ": " << before;
      EXPECT_LE(file.text.find('\n', at) - begin,
                dialect.longestLine > 0 ? dialect.longestLine + 1 : 300u)
          << dialect.id;
    }
    EXPECT_TRUE(isStated) << dialect.id;
    EXPECT_EQ(verdictOf(*plan.checked[0], plan.job.report), PlanVerdict::NotAsAsked) << dialect.id;
  }
  EXPECT_GE(stated, 8u);
}

TEST(Quality, TheHeadOfARefusedProgramSaysSo) {
  replay::Verification verdict;
  verdict.results = {{"collisions", 3.0, 0.0, false, true}};
  EXPECT_EQ(headVerdict(verdict, {}), "REFUSED, do not run: collisions 3 (limit 0)");
  verdict.safeToRun = true;
  EXPECT_EQ(
      headVerdict(verdict, {plan::makeFinding(plan::FindingKind::CollisionInMotion,
                                              {{"first", "arm"_name}, {"second", "plate"_name}})}),
      "NOT approved, the plan is not safe: arm collides with plate in the finished motion");
  verdict.passed = true;
  EXPECT_EQ(headVerdict(verdict, {}), kPassedVerdict);
  EXPECT_EQ(headVerdict(verdict, {plan::makeFinding(plan::FindingKind::NoPathTo,
                                                    {{"place", "bead 3"_name}, {"pieces", 1}},
                                                    Eigen::Vector3d(1.0, 2.0, 3.0))}),
            "safe to run; differs from the part: bead 3: no collision-free transfer to 1 piece of "
            "a path at (1.0 2.0 3.0)");
}

// In report.json a program that is not written has no files.
TEST(Quality, AReportListsTheProgramsThatAreWritten) {
  PlanResult plan = test::boxPlan();
  const auto json = [&] {
    const test::TemporaryFolder folder;
    writeOutputs(plan, folder.path(), base::RunContext());
    return nlohmann::json::parse(base::readFile(folder / "report.json"));
  };
  EXPECT_EQ(json().at("verdict"), "passed");
  EXPECT_EQ(json().at("printsAsAsked"), true);
  auto refused = std::make_shared<CheckedProgram>(*plan.checked[0]);
  refused->safeToRun = refused->verdict.safeToRun = refused->verdict.passed = false;
  plan.checked = {refused};
  plan.job.report.replay = refused->verdict;
  const auto kept = json();
  EXPECT_EQ(kept.at("verdict"), "refused");
  EXPECT_EQ(kept.at("safeToRun"), false);
  EXPECT_EQ(kept.at("programs").at(0).at("state"), "notWritten");
  EXPECT_TRUE(kept.at("programs").at(0).at("files").empty());
  plan.keepRefused = true;
  const auto asked = json();
  EXPECT_EQ(asked.at("programs").at(0).at("state"), "refused");
  EXPECT_EQ(asked.at("programs").at(0).at("files").at(0),
            "refused-" + refused->program.files[0].name);
}

// A fin that is narrower than the narrowest bead is left out: neither the plan nor the figures of
// cover and mass say so a second time, and it can be accepted.
TEST(Quality, AThinFinIsReportedOnce) {
  geometry::TriangleMesh part = test::box({-15, -3, 0}, {15, 3, 4});
  geometry::appendMesh(part, test::box({-15, -0.35, 4}, {15, 0.35, 10}));
  const auto finPlan = [&](const std::string& accept) {
    PlanRequest request =
        prismRequest({{"quality", "strict"}, {"thinWalls", "omit"}, {"accept", accept}});
    request.item().loaded = project::loadedFrom(
        "fin.stl", std::make_shared<geometry::TriangleMesh>(part), {}, true, {});
    return planPart(request, base::RunContext());
  };
  const project::Report report = finPlan({}).job.report;
  const double fin = 30.0 * 0.7 * 6.0, whole = 30.0 * 6.0 * 4.0 + fin;
  EXPECT_NEAR(report.replay.thinMm3, fin, 0.1 * fin); // of cells as wide as half the fin
  EXPECT_NEAR(report.replay.thinFraction, fin / whole, 0.1 * fin / whole);
  EXPECT_GT(report.replay.coveredFraction, 0.97);
  EXPECT_NEAR(report.replay.massRatio, 1.0, 0.03);
  EXPECT_EQ(verdictOf(report), PlanVerdict::NotAsAsked);
  using enum plan::FindingKind;
  std::vector<plan::FindingKind> told;
  for (const plan::Finding& finding : report.findings)
    for (const plan::FindingKind kind :
         {Thin, Uncovered, Mass, Overfill, ThinPart, ThinPartInReach, ThinWallsLeftOut})
      if (finding.kind == kind)
        told.push_back(kind);
  EXPECT_EQ(told, std::vector{Thin});
  EXPECT_EQ(verdictOf(finPlan("thin=0.2").job.report), PlanVerdict::Passed);
}

namespace {
// Two piers with a deck over the gap between them.
PlanResult bridgePlan(double gapMm, const std::string& quality) {
  geometry::TriangleMesh mesh = test::box({-14.0, -8, 0}, {-0.5 * gapMm, 8, 4});
  geometry::appendMesh(mesh, test::box({0.5 * gapMm, -8, 0}, {14.0, 8, 4}));
  geometry::appendMesh(mesh, test::box({-14.0, -8, 4}, {14.0, 8, 8}));
  PlanRequest request = prismRequest({{"quality", quality}, {"rimSupports", "none"}});
  request.item().loaded = project::loadedFrom(
      "bridge.stl", std::make_shared<geometry::TriangleMesh>(mesh), {}, true, {});
  return planPart(request, base::RunContext());
}
} // namespace

// The process bridges 6 mm without a mark, and 7.5 mm with a little sag; beads at the edges of the
// piers lean over by half a millimetre.
TEST(Quality, ABridgeThatTheMaterialBridgesIsSupported) {
  const PlanResult narrow = bridgePlan(4.5, "strict");
  EXPECT_LE(narrow.job.report.replay.unsupportedFraction, 0.001);
  EXPECT_EQ(verdictOf(narrow.job.report), PlanVerdict::Passed);
  const PlanResult wide = bridgePlan(7.5, "strict");
  EXPECT_GT(wide.job.report.replay.unsupportedFraction, 0.005);
  EXPECT_EQ(verdictOf(wide.job.report), PlanVerdict::NotAsAsked);
  const PlanResult sagging = bridgePlan(7.5, "usual");
  EXPECT_LE(sagging.job.report.replay.unsupportedFraction, 0.001);
  EXPECT_EQ(verdictOf(sagging.job.report), PlanVerdict::Passed);
  EXPECT_GT(sagging.job.report.replay.longestUnsupportedMm, 6.0) << "it is reported all the same";
}

// No replay of a program finds a bead that its plan left out: the plan's finding goes with the job.
TEST(Quality, WhatThePlanLeavesOutStaysAmberWhereTheJobIsReadAgain) {
  PlanResult plan = test::boxPlan();
  plan.job.report.findings.push_back(
      plan::makeFinding(plan::FindingKind::NoPathTo, {{"place", "bead 3"_name}, {"pieces", 1}}));
  ASSERT_EQ(verdictOf(plan.job.report), PlanVerdict::NotAsAsked);
  const test::TemporaryFolder folder;
  writeOutputs(plan, folder.path(), base::RunContext());
  const std::filesystem::path job = folder / "job.voluta";
  const std::string name = plan.checked[0]->program.files[0].name;
  EXPECT_EQ(verdictOf(verifyProgram(folder / name, job, base::RunContext())),
            PlanVerdict::NotAsAsked);
  ResumeRequest request;
  request.job = job;
  request.bead = 5;
  const ResumeResult rest = resumePrint(request, base::RunContext());
  EXPECT_EQ(verdictOf(rest.plan.job.report), PlanVerdict::NotAsAsked);
}

// A finding of the plan that concerns the robot is no matter of quality.
TEST(Quality, AFindingThatConcernsSafetyIsNotReleasedAsSafe) {
  PlanResult plan = test::boxPlan();
  plan.job.report.findings.push_back(plan::makeFinding(
      plan::FindingKind::CollisionInMotion, {{"first", "arm"_name}, {"second", "plate"_name}}));
  EXPECT_EQ(verdictOf(plan.job.report), PlanVerdict::Blocked);
  plan.job.report.replay.safeToRun = plan.job.report.replay.passed = false;
  EXPECT_EQ(verdictOf(plan.job.report), PlanVerdict::Refused);
}
