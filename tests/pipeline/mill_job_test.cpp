// A milled part's program is verified from its job file.
#include "pipeline/mill_job.h"

#include "base/error.h"
#include "helpers/shapes.h"
#include "pipeline/mill_report.h"
#include "project/loaded_part.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace voluta::pipeline {
namespace {

MillOrder order() {
  MillOrder order;
  order.name = "block";
  order.rule.data = *milling::cuttingDataFor("soft-plastic");
  order.rule.skinMm = 1.25;
  order.layDown = false;
  return order;
}

TEST(MillJob, AProgramIsVerifiedFromTheFile) {
  const MilledPart milled =
      millPart(test::box({-1.0 / 3.0, 0, 0}, {10, 8, 40.0 / 7.0}), order(), {});
  ASSERT_TRUE(milled.verdict.passed);
  const std::string text = writeMillJob(milled.part, order());
  EXPECT_TRUE(isMillJob(text));
  const MillJob job = readMillJob(text, "mill.json");
  EXPECT_EQ(job.part.vertices, milled.part.vertices);
  EXPECT_EQ(job.part.triangles, milled.part.triangles);
  EXPECT_TRUE(verifyMilling(milled.program, job, {}).passed);
  std::string changed = milled.program;
  const std::size_t at = changed.rfind("G1 ");
  changed.erase(at, changed.find('\n', at) + 1 - at);
  EXPECT_FALSE(verifyMilling(changed, job, {}).passed);
}

// Whoever reads a printed part's report reads a milled part's: the same keys for what both have.
void expectKeysOf(const nlohmann::json& printed, const nlohmann::json& milled,
                  const std::string& section) {
  ASSERT_EQ(milled.is_object(), printed.is_object()) << section;
  ASSERT_EQ(milled.is_array(), printed.is_array()) << section;
  if (milled.is_array() && !milled.empty() && !printed.empty())
    expectKeysOf(printed[0], milled[0], section + "[0]");
  if (!milled.is_object())
    return;
  for (const auto& [key, value] : milled.items()) {
    ASSERT_TRUE(printed.contains(key)) << section << "." << key;
    if (key != "values") // of a finding: those of its kind
      expectKeysOf(printed[key], value, section + "." + key);
  }
  for (const auto& [key, value] : printed.items())
    EXPECT_TRUE(key == "values" || milled.contains(key)) << section << "." << key;
}

TEST(MillJob, TheReportHasTheKeysOfAPrintedPartsReport) {
  geometry::TriangleMesh mesh = test::box({0, 0, 0}, {20, 18, 3});
  test::append(mesh, test::box({0, 0, 3}, {20, 8, 8}));
  test::append(mesh, test::box({0, 10, 3}, {20, 18, 8})); // a slot narrower than the cutter
  MillOrder coarse = order();
  coarse.rule.pitchMm = 0.2;
  const auto loaded =
      project::loadedFrom("slot.stl", std::make_shared<geometry::TriangleMesh>(mesh), {}, true, {});
  const MilledPart milled = millPart(*loaded->mesh, coarse, {});
  ASSERT_TRUE(milled.verdict.passed);
  project::Report report;
  report.programs.emplace_back();
  report.findings = milled.verdict.findings;
  const auto printed = nlohmann::json::parse(project::reportJson(report));
  auto json = nlohmann::json::parse(project::reportJson(millReport(*loaded, coarse, milled)));
  EXPECT_EQ(json.at("milling").at("complete"), false);
  EXPECT_GT(json.at("milling").at("leftMm3"), 10.0);
  EXPECT_EQ(json.at("model").at("file"), "slot.stl");
  EXPECT_EQ(json.at("replay").at("passed"), true);
  EXPECT_TRUE(json.at("replay").at("coveredFraction").is_null()) << "nothing is deposited";
  EXPECT_GT(json.at("programs").at(0).at("durationS"), 60.0);
  EXPECT_EQ(json.at("programs").at(0).at("files").at(0), kMillProgramFile);
  const auto& finding = json.at("findings").at(0);
  EXPECT_EQ(finding.at("kind"), "materialLeft");
  EXPECT_EQ(finding.at("stage"), "replay");
  EXPECT_EQ(finding.at("blocking"), true);
  EXPECT_EQ(finding.at("where").size(), 3u);
  json.erase("milling");
  for (const auto& [section, value] : json.items()) {
    ASSERT_TRUE(printed.contains(section)) << section;
    expectKeysOf(printed.at(section), value, section);
  }
}

TEST(MillJob, ARefusedProgramIsReportedAtItsLine) {
  MilledPart milled = millPart(test::box({0, 0, 0}, {10, 8, 6}), order(), {});
  const std::size_t cut = milled.program.rfind("G1 ");
  milled.program[cut + 1] = '0'; // a rapid move
  const MillJob job = readMillJob(writeMillJob(milled.part, order()), "mill.json");
  milled.verdict = verifyMilling(milled.program, job, {});
  const auto loaded = project::loadedFrom(
      "box.stl", std::make_shared<geometry::TriangleMesh>(milled.part), {}, true, {});
  const auto json =
      nlohmann::json::parse(project::reportJson(millReport(*loaded, order(), milled)));
  EXPECT_EQ(json.at("replay").at("passed"), false);
  EXPECT_TRUE(json.at("programs").at(0).at("files").empty());
  const auto line = std::to_string(std::ranges::count(milled.program.substr(0, cut), '\n') + 1);
  EXPECT_EQ(json.at("findings").at(0).at("reason"),
            "line " + line + ": another motion than planned");
  EXPECT_EQ(json.at("findings").at(0).at("kind"), "otherMotion");
}

TEST(MillJob, DamagedFilesAreRefused) {
  const std::string text = writeMillJob(test::box({0, 0, 0}, {1, 1, 1}), order());
  EXPECT_FALSE(isMillJob("{\"format\":\"voluta job\"}"));
  for (const auto& [from, to] :
       std::vector<std::pair<std::string, std::string>>{{"\"teeth\":1", "\"teeth\":\"x\""},
                                                        {"soft-plastic", "butter"},
                                                        {"\"pitchMm\":0.1", "\"pitchMm\":-1"},
                                                        {"[0,", "[99,"},
                                                        {"milling 1", "milling 9"}}) {
    std::string damaged = text;
    const std::size_t at = damaged.rfind(from);
    ASSERT_NE(at, std::string::npos) << from;
    damaged.replace(at, from.size(), to);
    try {
      readMillJob(damaged, "mill.json");
      ADD_FAILURE() << from;
    } catch (const base::Error& e) {
      EXPECT_NE(std::string(e.what()).find("mill.json"), std::string::npos) << e.what();
    }
  }
}

} // namespace
} // namespace voluta::pipeline
