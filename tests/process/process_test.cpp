// Invariants of every file in resources/processes, and the published figures of the fine one.
#include "process/process.h"

#include "base/error.h"
#include "base/files.h"
#include "helpers/temporary_folder.h"
#include "process/bead_model.h"
#include "process/feature_parameters.h"
#include "process/process_text.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>

namespace voluta::process {
namespace {

class Processes : public ::testing::Test {
protected:
  void SetUp() override { setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1); }
};

TEST_F(Processes, everyOneKeepsItsContract) {
  const std::vector<std::string> ids = processIds();
  ASSERT_GE(ids.size(), 10u);
  for (const std::string& id : ids) {
    SCOPED_TRACE(id);
    const Process p = loadProcess(id);
    EXPECT_EQ(p.id, id);
    EXPECT_FALSE(p.label.empty());
    EXPECT_GT(p.nozzleDiameterMm, 0.0);
    EXPECT_LE(0.05, p.layerHeightMinMm);
    EXPECT_LE(p.layerHeightMinMm, p.layerHeightMm);
    EXPECT_LE(p.layerHeightMm, p.layerHeightMaxMm);
    EXPECT_LE(p.beadWidthMinMm, p.beadWidthMm);
    EXPECT_LE(p.beadWidthMm, p.beadWidthMaxMm);
    // A bead is squeezed by the nozzle: no higher than it is wide, nor than the nozzle. A welded
    // one is not, and bridges nothing.
    const bool isWelded = id.starts_with("wire-arc");
    EXPECT_LE(p.layerHeightMaxMm, p.beadWidthMinMm);
    EXPECT_LE(p.layerHeightMaxMm, isWelded ? 2.5 * p.nozzleDiameterMm : p.nozzleDiameterMm);
    EXPECT_GE(p.beadWidthMinMm, p.nozzleDiameterMm);
    EXPECT_GT(p.stepMm, 0.0);
    EXPECT_GT(p.accelerationMmPerS2, 0.0);
    EXPECT_GE(p.bridgeMm, isWelded || p.tape ? 0.0 : p.beadWidthMm);
    EXPECT_LE(p.bridgeSpeedMmPerS, p.speedMmPerS);
    EXPECT_GE(p.travelSpeedMmPerS, p.speedMmPerS);
    EXPECT_GE(p.primeS, 0.0);
    EXPECT_GT(p.material.densityGPerCm3, 0.0);
    // The thickest bead at the usual speed is within the extruder's flow.
    EXPECT_GE(p.maxFlowMm3PerS, p.speedMmPerS * beadArea(p.beadWidthMaxMm, p.layerHeightMaxMm));
    // Contact is less than a usual layer deep, or a head in the layer below would be none.
    EXPECT_GT(p.contactToleranceMm, 0.0);
    EXPECT_LT(p.contactToleranceMm, p.layerHeightMm);
    const std::vector<HeadSection>& head = p.head.sections;
    ASSERT_GE(head.size(), 2u);
    // A cone up to the clamp: wider with the height.
    for (std::size_t i = 1; i < head.size(); ++i)
      EXPECT_GE(head[i].radiusMm, head[i - 1].radiusMm) << i;
    EXPECT_GE(2.0 * head.front().radiusMm, p.nozzleDiameterMm);
    const HeadShape eroded = erodedHead(p.head, p.contactToleranceMm);
    for (std::size_t i = 0; i < head.size(); ++i) {
      EXPECT_DOUBLE_EQ(eroded.sections[i].zMm, head[i].zMm + p.contactToleranceMm);
      EXPECT_GE(eroded.sections[i].radiusMm, 0.0);
      EXPECT_LE(eroded.sections[i].radiusMm, head[i].radiusMm);
    }
  }
}

// Castelli table 5.1: nozzle 0.35, beads twice as wide, first layer 0.25, layers 0.2 mm.
TEST_F(Processes, theFineNozzlePrintsThePublishedBeads) {
  const Process p = loadProcess("fdm-0.35");
  EXPECT_EQ(p.nozzleDiameterMm, 0.35);
  EXPECT_EQ(p.beadWidthMm, 2.0 * p.nozzleDiameterMm);
  EXPECT_EQ(p.layerHeightMm, 0.25);
  EXPECT_LE(p.layerHeightMinMm, 0.2);
  EXPECT_NEAR(beadArea(p.beadWidthMm, 0.2), 0.131415927, 1e-9);
  EXPECT_NEAR(hatchOf(p.beadWidthMm, 0.2), 0.657079633, 1e-9);
  EXPECT_NEAR(beadArea(p.beadWidthMm, 0.25), 0.161587385, 1e-9);
  EXPECT_NEAR(hatchOf(p.beadWidthMm, 0.25), 0.646349541, 1e-9);
}

TEST_F(Processes, anUnknownIdNamesTheNearest) {
  try {
    loadProcess("fdm-0.53");
    FAIL();
  } catch (const base::Error& e) {
    EXPECT_EQ(e.code(), base::ErrorCode::Usage);
    EXPECT_NE(std::string(e.what()).find("fdm-0.35"), std::string::npos);
  }
}

TEST_F(Processes, aTapeGivesItsPathsItsSection) {
  const Process p = loadProcess("tape-5");
  ASSERT_TRUE(p.tape);
  EXPECT_NEAR(beadArea(p.beadWidthMm, p.layerHeightMm), 5.0 * 0.08, 1e-12);
  EXPECT_EQ(p.layerHeightMinMm, p.layerHeightMaxMm);
  EXPECT_EQ(p.speedMmPerS, 10.0);
  EXPECT_FALSE(p.material.nozzleC);
  EXPECT_FALSE(loadProcess("fdm-1.0").tape);
}

TEST_F(Processes, aTapeOfContradictingLengthsIsRefused) {
  const std::string text =
      base::readFile(std::string(VOLUTA_SOURCE_DIR) + "/resources/processes/tape-5.json");
  const std::pair<const char*, const char*> cases[] = {
      {"\"thicknessMm\": 0.08", "\"thicknessMm\": 6"},
      {"\"cutAheadMm\": 15.0", "\"cutAheadMm\": 30"},
      {"\"leastBendRadiusMm\": 40.0", "\"leastBendRadiusMm\": 2"},
      {"\"widthMm\": 5.0", "\"widthMm\": 0"},
      {"\"leastLengthMm\": 30.0,", ""},
      {"\"ironSpeedMmPerS\": 10.0", "\"ironSpeedMmPerS\": -1"},
      {"\"ironSpeedMmPerS\": 10.0", "\"ironSpeedMmPerS\": 10, \"heat\": 1"}};
  for (const auto& [from, to] : cases) {
    std::string changed = text;
    const std::size_t at = changed.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    changed.replace(at, std::string(from).size(), to);
    EXPECT_THROW(readProcessText(changed, "own.json"), base::Error) << to;
  }
}

// The fine process with `from` replaced, which occurs once.
void expectRefused(const std::string& from, const std::string& to, const std::string& key) {
  SCOPED_TRACE(to);
  std::string text =
      base::readFile(std::string(VOLUTA_SOURCE_DIR) + "/resources/processes/fdm-0.35.json");
  const std::size_t at = text.find(from);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, from.size(), to);
  const test::TemporaryFolder folder;
  base::writeFile(folder / "own.json", text);
  try {
    readProcess(folder / "own.json");
    FAIL();
  } catch (const base::Error& e) {
    EXPECT_EQ(e.code(), base::ErrorCode::UnusableInput);
    EXPECT_NE(voluta::base::english(e.context()).find("own.json"), std::string::npos) << e.what();
    EXPECT_NE(voluta::base::english(e.message()).find("'" + key + "'"), std::string::npos)
        << e.what();
  }
}

TEST_F(Processes, invalidValuesAreRefusedWithFileAndKey) {
  expectRefused("\"speedMmPerS\": 20.0", "\"speedMmPerS\": -20.0", "speedMmPerS");
  expectRefused("\"speedMmPerS\": 20.0", "\"speedMmPerS\": \"fast\"", "speedMmPerS");
  expectRefused("\"primeS\": 0.2", "\"primeS\": -0.2", "primeS");
  expectRefused("\"primeS\": 0.2", "\"primeS\": 0.2, \"primeMs\": 200", "primeMs");
  expectRefused("\"primeS\": 0.2,", "", "primeS");
  expectRefused("\"default\": 0.25", "\"default\": 0.05", "layerHeightMm.default");
  expectRefused("\"max\": 1.2", "\"max\": 0.6", "beadWidthMm.default");
  expectRefused("\"max\": 1.2", "\"max\": 1.2, \"mid\": 1", "beadWidthMm.mid");
  expectRefused("[12.0, 6.0]", "[12.0, -6.0]", "head[1][1]");
  expectRefused("[12.0, 10.0]", "[11.0, 10.0]", "head[2]");
  expectRefused(
      "[[0.0, 0.5], [12.0, 6.0], [12.0, 10.0], [45.0, 10.0], [45.0, 22.0], [110.0, 22.0]]",
      "[[0.0, 0.5], [0.0, 6.0]]", "head");
}

// Expects a refusal that names both keys.
void expectContradiction(const std::string& from, const std::string& to, const std::string& key,
                         const std::string& other) {
  SCOPED_TRACE(key);
  std::string text =
      base::readFile(std::string(VOLUTA_SOURCE_DIR) + "/resources/processes/fdm-1.0.json");
  const std::size_t at = text.find(from);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, from.size(), to);
  try {
    readProcessText(text, "own.json");
    FAIL();
  } catch (const base::Error& e) {
    const std::string line = voluta::base::english(e.message());
    EXPECT_EQ(e.code(), base::ErrorCode::UnusableInput);
    EXPECT_NE(line.find(key), std::string::npos) << line;
    EXPECT_NE(line.find(other), std::string::npos) << line;
    EXPECT_EQ(line.find('\n'), std::string::npos) << line;
  }
}

TEST_F(Processes, contradictingLimitsAreRefusedWithBothKeys) {
  expectContradiction("\"default\": 0.8, \"min\": 0.4, \"max\": 1.0",
                      "\"default\": 1.8, \"min\": 0.4, \"max\": 2.0", "layerHeightMm",
                      "beadWidthMm");
  expectContradiction("\"contactToleranceMm\": 0.4", "\"contactToleranceMm\": 1.0",
                      "contactToleranceMm", "layerHeightMm");
  expectContradiction("\"maxFlowMm3PerS\": 40.0", "\"maxFlowMm3PerS\": 1.0", "maxFlowMm3PerS",
                      "speedMmPerS");
}

// The fine process with this block of features.
Process withFeatures(const std::string& block) {
  std::string text =
      base::readFile(std::string(VOLUTA_SOURCE_DIR) + "/resources/processes/fdm-0.35.json");
  return readProcessText(text.insert(text.find("\"head\""), "\"features\": " + block + ", "),
                         "own");
}

TEST_F(Processes, featuresAreOptionalAndReadByKey) {
  const Process usual = loadProcess("fdm-0.35");
  for (const FeatureSettings& none : usual.features.all()) {
    EXPECT_EQ(none.speedMmPerS, 0.0);
    EXPECT_EQ(none.flow, 1.0);
    EXPECT_EQ(none.widthMm, 0.0);
  }
  for (const FeatureRow& row : featureRows()) {
    SCOPED_TRACE(row.key);
    const Process p = withFeatures("{\"" + std::string(row.key) + "\": {\"flow\": 0.9" +
                                   (row.hasSpeed ? ", \"speedMmPerS\": 12" : "") +
                                   (row.hasWidth ? ", \"widthMm\": 0.8" : "") + "}}");
    for (const FeatureRow& other : featureRows())
      EXPECT_EQ(p.features.of(other.feature).flow, &other == &row ? 0.9 : 1.0);
    EXPECT_EQ(p.features.of(row.feature).speedMmPerS, row.hasSpeed ? 12.0 : 0.0);
    EXPECT_EQ(p.features.of(row.feature).widthMm, row.hasWidth ? 0.8 : 0.0);
  }
}

TEST_F(Processes, speedsAsParametersReplaceThoseOfTheFile) {
  const Process p = withFeatures(
      R"({"outerWall": {"speedMmPerS": 12, "flow": 0.9}, "infill": {"speedMmPerS": 30}})");
  base::ParameterValues values(featureParameters());
  FeatureTable features = p.features;
  setFeatureSpeeds(features, values);
  for (const FeatureRow& row : featureRows())
    EXPECT_EQ(features.of(row.feature).speedMmPerS, p.features.of(row.feature).speedMmPerS);
  values.set("outerWallSpeedMmPerS", "8");
  setFeatureSpeeds(features, values);
  EXPECT_EQ(features.of(Feature::OuterWall).speedMmPerS, 8.0);
  EXPECT_EQ(features.of(Feature::OuterWall).flow, 0.9);
  EXPECT_EQ(features.of(Feature::Infill).speedMmPerS, 30.0);
}

TEST_F(Processes, featuresThatMakeNoSenseAreRefusedWithTheirKey) {
  const std::pair<const char*, const char*> rows[] = {
      {R"({"outerwall": {}})", "features.outerwall"},
      {R"({"outerWall": {"speed": 1}})", "features.outerWall.speed"},
      {R"({"infill": {"speedMmPerS": 0}})", "features.infill.speedMmPerS"},
      {R"({"infill": {"flow": 2.5}})", "features.infill.flow"},
      {R"({"infill": {"widthMm": 0.8}})", "features.infill.widthMm"},
      {R"({"bridge": {"speedMmPerS": 5}})", "features.bridge.speedMmPerS"},
      {R"({"outerWall": {"widthMm": 0.5}})", "features.outerWall.widthMm"},
      {R"({"support": {"widthMm": 1.5}})", "features.support.widthMm"}};
  for (const auto& [block, key] : rows) {
    SCOPED_TRACE(block);
    try {
      withFeatures(block);
      ADD_FAILURE();
    } catch (const base::Error& e) {
      EXPECT_EQ(e.code(), base::ErrorCode::UnusableInput);
      EXPECT_NE(voluta::base::english(e.message()).find("'" + std::string(key) + "'"),
                std::string::npos)
          << e.what();
    }
  }
}

// A file of wire-arc-1.2 with one more member.
std::string wireArcWith(const std::string& member) {
  const std::filesystem::path file = VOLUTA_SOURCE_DIR "/resources/processes/wire-arc-1.2.json";
  std::string text = base::readFile(file);
  return text.insert(text.rfind('}'), ", " + member);
}

TEST_F(Processes, machinesMayHaveLawsOfTheirOwn) {
  const Process plain = loadProcess("wire-arc-1.2");
  EXPECT_EQ(plain.lag.startS, 0.0);
  EXPECT_EQ(plain.lag.stopS, 0.0);
  EXPECT_TRUE(plain.beadWords.empty());
  const Process p = readProcessText(
      wireArcWith(
          R"("startLagS": 0.3, "stopLagS": 0.2, "beadWords": [)"
          R"({"format": "rapid", "start": ["SetDO doArc,1;"], "end": ["SetDO doArc,0;"]}])"),
      "x");
  EXPECT_EQ(p.lag.startS, 0.3);
  EXPECT_EQ(p.lag.stopS, 0.2);
  ASSERT_NE(p.wordsFor("rapid"), nullptr);
  EXPECT_EQ(p.wordsFor("rapid")->start, std::vector<std::string>{"SetDO doArc,1;"});
  EXPECT_EQ(p.wordsFor("krl"), nullptr);
  for (const char* bad :
       {R"("startLagS": -1)", R"("stopLagS": 11)", R"("overlapFactor": 0.4)",
        R"("overlapFactor": 1.1)", R"("beadWords": [{"format": "rapid"}])",
        R"("beadWords": [{"format": "rapid", "start": ["a\nb"]}])",
        R"("beadWords": [{"format": "krl", "end": [" "]}])", R"("beadWords": [{"start": ["a"]}])",
        R"("beadWords": [{"format": "krl", "end": ["a"]}, {"format": "krl", "end": ["b"]}])"})
    EXPECT_THROW(readProcessText(wireArcWith(bad), "x"), base::Error) << bad;
}

TEST_F(Processes, stateTheSpeedOfOverhangs) {
  EXPECT_EQ(readProcessText(wireArcWith(R"("startLagS": 0)"), "x").overhangSpeed, OverhangSpeed());
  const Process p = readProcessText(wireArcWith(R"("overhangSpeed": [1, 0.8, 0.8, 0.5])"), "x");
  EXPECT_EQ(p.overhangSpeed.shares, (std::array<double, 4>{1.0, 0.8, 0.8, 0.5}));
  EXPECT_EQ(readProcessText(processText(p), "x").overhangSpeed, p.overhangSpeed);
  for (const char* bad :
       {R"("overhangSpeed": 1)", R"("overhangSpeed": [1, 0.8, 0.6])",
        R"("overhangSpeed": [1, 0.8, 0.6, 0])", R"("overhangSpeed": [1.1, 0.8, 0.6, 0.5])",
        R"("overhangSpeed": [1, 0.6, 0.8, 0.5])"})
    EXPECT_THROW(readProcessText(wireArcWith(bad), "x"), base::Error) << bad;
}

// Tangent overlapping of parabolic beads (Ding et al. 2015): their distance is 0.738 widths.
TEST_F(Processes, beadsOverlapByTheFactor) {
  const Process plain = loadProcess("wire-arc-1.2"),
                p = readProcessText(wireArcWith(R"("overlapFactor": 0.738)"), "x");
  EXPECT_NEAR(hatchOf(p.beadWidthMm, p.layerHeightMm), 0.738 * plain.beadWidthMm, 1e-9);
  EXPECT_NEAR(beadArea(p.beadWidthMm, p.layerHeightMm), 0.738 * plain.beadWidthMm * p.layerHeightMm,
              1e-9)
      << "a layer is filled";
  EXPECT_LT(p.beadWidthMinMm, p.beadWidthMm);
  EXPECT_GT(p.beadWidthMaxMm, p.beadWidthMm);
}

} // namespace
} // namespace voluta::process
