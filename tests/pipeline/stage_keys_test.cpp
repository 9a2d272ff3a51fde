// Changes that outdate a result, and changes that don't.
#include "base/error.h"
#include "base/files.h"
#include "helpers/given_parameters.h"
#include "helpers/temporary_folder.h"
#include "pipeline/box_request.h"
#include "pipeline/road.h"
#include "pipeline/stage_options.h"

#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <map>
#include <tuple>

using namespace voluta;
using namespace voluta::modes;
using namespace voluta::pipeline;
using namespace voluta::project;
namespace fs = std::filesystem;

namespace {

using test::boxPart, test::boxRequest;

// The first stage whose key a parameter changes; kStageCount: none.
const std::map<std::string, std::pair<std::string, std::size_t>> kParameters{
    {"layerHeightMm", {"0.7", 1}},
    {"beadWidthMm", {"1.3", 2}},
    {"firstLayerWidthMm", {"1.4", 3}},
    {"outerWallSpeedMmPerS", {"10", 3}},
    {"innerWallSpeedMmPerS", {"10", 3}},
    {"infillSpeedMmPerS", {"10", 3}},
    {"supportSpeedMmPerS", {"10", 3}},
    {"firstLayerSpeedMmPerS", {"10", 3}},
    {"stepMm", {"0.9", 3}},
    {"quality", {"draft", 5}},
    {"accept", {"uncovered=0.05", 5}},
    {"givenToolPaths", {"false", kStageCount}}, // of parts that bring some, see given_paths_test
    {"pathsFlow", {"110", kStageCount}},        // the same, see sliced_paths_test
    {"pathsTurn", {"5", kStageCount}},
    {"pathsTurnBackMm", {"5", kStageCount}},
    {"pathsOn", {"cylinder", kStageCount}},
    {"pathsRadiusMm", {"50", kStageCount}},
    {"pathsKeep", {"angles", kStageCount}},
    {"pathsFrame", {"0,0,0,0,0,90", kStageCount}},
    {"output.build3mf", {"true", kStageCount}},
    {"output.proof", {"false", kStageCount}},
    {"output.debug", {"true", kStageCount}},
    {"output.refused", {"true", kStageCount}},
    {"voxelMm", {"0.9", 1}},
    {"frontShape", {"flat", 1}},
    {"supports", {"none", 1}},
    {"orient", {"leastRisky", 0}},
    {"openSurfaces", {"close", 0}},
    {"fieldRounds", {"5", 1}},
    {"overhangAngle", {"40", kStageCount}}, // of modes planar and flat, see below
    {"pieceMaterials", {"white PLA, red PLA", kStageCount}},
    {"cutPlanes", {R"([{"point": [0, 0, 4], "normal": [0, 0, 1]}])", kStageCount}},
    {"planarScheme", {"greedy", kStageCount}},
    {"pieceClusters", {"3", kStageCount}}, // of the greedy scheme, see below
    {"pieceRoot", {"0,0,0", kStageCount}},
    {"adaptiveLayers", {"true", kStageCount}},
    {"cuspMm", {"0.4", kStageCount}},
    {"layerPlanes", {R"([{"point": [0, 0, 0.4], "normal": [0, 0, 1]}])", kStageCount}},
    {"rodAxis", {"x", kStageCount}}, // of modes lathe and substrate, see below
    {"rodSides", {"6", kStageCount}},
    {"rodProfile", {"-20,3 20,3", kStageCount}},
    {"rodLayers", {"offset", kStageCount}},
    {"firstLayerMm", {"0.5", kStageCount}}, // of all modes but curved
    {"layerShape", {"sphere", kStageCount}},
    {"layerCentre", {"0,0,-9", kStageCount}},
    {"endSurface", {"flat:9", kStageCount}},
    {"traceAngle", {"30", kStageCount}}, // of mode trace
    {"traceInset", {"1", kStageCount}},
    {"traceSpacing", {"4", kStageCount}},
    {"tracePasses", {"2", kStageCount}},
    {"traceClosing", {"1", kStageCount}},
    {"traceSidePasses", {"1", kStageCount}},
    {"traceSideDepth", {"4", kStageCount}},
    {"traceFillLines", {"1", kStageCount}},
    {"traceFillAngle", {"45", kStageCount}},
    {"walls", {"3", 3}},
    {"infill", {"concentric", 3}},
    {"infillDensity", {"0.5", 3}},
    {"sparsePattern", {"lines", 3}},
    {"topLayers", {"2", 3}},
    {"bottomLayers", {"2", 3}},
    {"skinMm", {"3", 3}},
    {"windingAngle", {"30", 3}},
    {"infillAngle", {"0", 3}},
    {"infillRotation", {"0", 3}},
    {"tool", {"1", kStageCount}}, // of jobs with several tools, see several_tools_test
    {"supportTool", {"0", kStageCount}},
    {"infillTool", {"0", kStageCount}},
    {"pieceTools", {"", kStageCount}},
    {"purgeMm3", {"50", 4}},
    {"bodyClearanceMm", {"3", 4}},
    {"partClearanceMm", {"3", 4}},
    {"liftMm", {"3", 4}},
    {"minLayerTimeS", {"20", 3}},
    {"coolingSpeedMmPerS", {"2", 3}},
    {"maxLayerTimeS", {"90", 5}},
    {"wipeMm", {"3", 4}},
    {"pauseLayers", {"2", 4}},
    {"layerEvents", {"2 output 3 on", 4}},
    {"nozzleRotation", {"workAxis", 4}},
    {"redundancySamples", {"12", 4}},
    {"rotationSmoothing", {"wholePath", 4}},
    {"tiltToleranceDeg", {"2.5", 4}},
    {"maxJerk", {"100", 4}},
    {"collisionModel", {"learned", 4}},
    {"branchChange", {"blend", 4}},
    {"motionsPerFile", {"2000", 5}},
    {"urscriptForm", {"port", 5}},
    {"rapidModules", {"modx", kStageCount}}, // no program here is RAPID
    {"programResolutionMm", {"0.02", 5}},
    {"arcFitting", {"true", 5}},
    {"rapidFlow", {"speed", kStageCount}},
    {"krlMemoryMb", {"2", kStageCount}}, // nor KRL
    {"tableXMm", {"5", kStageCount}},    // nor for a table
    {"tableZMm", {"5", kStageCount}},
    {"tableSense", {"tool", kStageCount}},
    {"tableTurns", {"2", kStageCount}},
    {"tableUnwind", {"count", kStageCount}},
    {"gcodeRunner", {"rapid", 5}},
    {"mxtController", {"cr800", kStageCount}},
    {"extruderAxisMm", {"5000", kStageCount}}, // nor here
    {"retractMm", {"1", 5}},
    {"rimSupports", {"none", 3}},
    {"prime", {"skirt", 3}},
    {"primeLengthMm", {"60", 3}},
    {"brimWidthMm", {"5", 3}},
    {"seam", {"corner", 3}},
    {"thinWalls", {"omit", 3}},
    {"seamHere", {"always", 3}},
    {"speedFactor", {"0.5", 3}},
    {"interlockMm", {"1", kStageCount}}, // of regions, see region_plan_test
    {"loadDirection", {"1,0,0", 3}},
    {"infillField", {"1,0,0", kStageCount}}, // of another infill
    {"fibreLayers", {"1", 3}},
    {"fibreFirstLayer", {"2", 3}},
    {"fibreCount", {"1", 3}},
    {"fibrePaths", {"contour", 3}},
    {"fibreAngle", {"30", 3}},
    {"fibreRotation", {"90", 3}},
    {"fibreEndMm", {"5", 3}},
    {"fibreCurves", {"0,0 50,0", 3}},
    {"fibreField", {"0,0,0,1,0,0", 3}},
    {"stitchSpacing", {"25", kStageCount}}, // of mode flat, see below
    {"stitchDiameter", {"6", kStageCount}}, // of mode flat, see below
    {"stitchShape", {"cone", kStageCount}}, // of mode flat, see below
    {"stitchLayers", {"3", kStageCount}},   // of mode flat, see below
    {"stitchExcess", {"0.1", 3}},
    {"stitchDepth", {"0.5", 3}},
    {"stitchFlow", {"9", 4}},
    {"stitchWait", {"1", 4}},
    {"islandOrder", {"layers", 3}},
    {"spiral", {"true", 3}},
    {"spiralOuter", {"true", 3}},
    {"extruder", {"e-stream", 5}},
};

// Works on a copy of the program's data, to be changed.
class StageKeysOf : public ::testing::Test {
protected:
  void SetUp() override {
    fs::copy(base::resourceFolder() / "", folder_.path(), fs::copy_options::recursive);
    if (const char* before = std::getenv("VOLUTA_RESOURCES"))
      before_ = before;
    ::setenv("VOLUTA_RESOURCES", folder_.path().c_str(), 1);
    default_ = stageKeys(boxRequest());
  }
  void TearDown() override {
    if (before_.empty())
      ::unsetenv("VOLUTA_RESOURCES");
    else
      ::setenv("VOLUTA_RESOURCES", before_.c_str(), 1);
  }
  void replace(const char* file, const std::string& what, const std::string& with) const {
    std::string text = base::readFile(folder_ / file);
    const std::size_t at = text.find(what);
    ASSERT_NE(at, std::string::npos) << what;
    base::writeFile(folder_ / file, text.replace(at, what.size(), with));
  }
  // Keys from stage `first` on differ from those of the defaults, those before don't.
  void expectChangesFrom(const PlanRequest& request, std::size_t first,
                         const std::string& what) const {
    const StageKeys now = stageKeys(request);
    for (std::size_t i = 0; i < kStageCount; ++i)
      EXPECT_EQ(now[i] == default_[i], i < first) << what << ", stage " << i;
  }

  const test::TemporaryFolder folder_;
  std::string before_;
  StageKeys default_;
};

TEST_F(StageKeysOf, ParametersReachTheStagesTheyMatterTo) {
  const base::ParameterTable table = parametersOf(boxRequest().choices.item().mode);
  for (const base::ParameterSpec& spec : table.specs()) {
    const auto row = kParameters.find(spec.key);
    EXPECT_NE(row, kParameters.end()) << spec.key << ": which stage does it matter to?";
    if (row == kParameters.end())
      continue;
    expectChangesFrom(boxRequest({{spec.key, row->second.first}}), row->second.second, spec.key);
    expectChangesFrom(boxRequest({{spec.key, base::formatParameter(spec.defaultValue)}}),
                      kStageCount, spec.key + " as it is by default");
  }
}

TEST_F(StageKeysOf, OptionsOfAFormatMatterWhereItIsWritten) {
  const auto replayKey = [](const std::map<std::string, std::string>& parameters) {
    PlanRequest request = boxRequest(parameters);
    request.choices.formats = {"rapid"};
    return stageKeys(request).back();
  };
  EXPECT_NE(replayKey({{"rapidModules", "modx"}}), replayKey({}));
  EXPECT_EQ(replayKey({{"urscriptForm", "port"}}), replayKey({}));
}

TEST_F(StageKeysOf, ChoicesReachTheStagesTheyMatterTo) {
  const auto check = [&](const char* what, std::size_t first, auto&& change) {
    PlanRequest request = boxRequest();
    change(request.choices);
    expectChangesFrom(request, first, what);
  };
  check("nothing", kStageCount, [](Choices&) {});
  check("rotation", 0, [](Choices& c) { c.item().placement.rotation = {0.6, 0.8, 0, 0}; });
  check("centre", 0, [](Choices& c) { c.item().placement.centreMm.x() = 1.0; });
  check("lift", 0, [](Choices& c) { c.item().placement.liftMm = 1.0; });
  check("scale", 0, [](Choices& c) { c.item().scale = "0.9"; });
  check("the same scale", kStageCount, [](Choices& c) { c.item().scale = "1.0"; });
  check("repair of what is whole", kStageCount, [](Choices& c) { c.item().repair = false; });
  check("growth", 1, [](Choices& c) { c.item().growth = curved::GrowthScheme("greedy"); });
  check("platform", 1, [](Choices& c) { c.item().platform = project::Platform("disc:80"); });
  check("seed", 4, [](Choices& c) { c.seed = 2; });
  check("formats", 5, [](Choices& c) { c.formats = {"csv"}; });
  check("the formats that are meant anyway", kStageCount, [](Choices& c) {
    c.formats = {"urscript", "gcode-extended"};
  });
}

TEST_F(StageKeysOf, ParametersOfPiecesMatterToTheirModes) {
  const std::tuple<const char*, const char*, std::size_t> rows[] = {
      {"planar", "overhangAngle", 1},  {"planar", "pieceMaterials", 1},
      {"planar", "adaptiveLayers", 2}, {"planar", "cuspMm", 2},
      {"planar", "supports", 2},       {"flat", "supports", 1},
      {"planar", "layerPlanes", 6},    {"planar", "voxelMm", 6},
      {"planar", "cutPlanes", 1},      {"flat", "cutPlanes", 6},
      {"planar", "planarScheme", 1},   {"flat", "planarScheme", 6},
      {"planar", "pieceClusters", 6},  {"planar", "pieceRoot", 6},
      {"flat", "overhangAngle", 1},    {"flat", "pieceMaterials", 1},
      {"flat", "adaptiveLayers", 2},   {"flat", "cuspMm", 2},
      {"flat", "firstLayerMm", 2},     {"planar", "firstLayerMm", 2},
      {"flat", "layerPlanes", 2},      {"flat", "voxelMm", 1},
      {"flat", "frontShape", 6},       {"flat", "layerHeightMm", 1},
      {"flat", "stitchSpacing", 2},    {"flat", "stitchDiameter", 2},
      {"flat", "stitchLayers", 2},     {"flat", "stitchShape", 2},
      {"planar", "stitchSpacing", 6}};
  for (const auto& [mode, key, first] : rows) {
    PlanRequest request = boxRequest();
    request.choices.item().mode = mode;
    default_ = stageKeys(request);
    const bool supports = std::string_view(key) == "supports"; // curved layers have them anyway
    test::giveParameters(request.choices, {{key, supports ? "auto" : kParameters.at(key).first}});
    expectChangesFrom(request, first, mode + (std::string(" ") + key));
  }
  // Where the part is oriented by a search, overhangs decide the orientation.
  PlanRequest turned = boxRequest({{"orient", "leastRisky"}});
  default_ = stageKeys(turned);
  turned.choices.item().parameters["overhangAngle"] = "40";
  expectChangesFrom(turned, 0, "overhangAngle where the part is turned");
  // The contact of pieces with the plate depends on the layer height.
  turned = boxRequest({{"orient", "leastAfterCuts"}});
  default_ = stageKeys(turned);
  turned.choices.item().parameters["layerHeightMm"] = "0.7";
  expectChangesFrom(turned, 0, "layerHeightMm where the part is cut to be turned");
}

TEST_F(StageKeysOf, ParametersOfGroundsMatterToTheirModes) {
  const std::tuple<const char*, const char*, std::size_t> rows[] = {
      {"lathe", "rodAxis", 0},         {"lathe", "rodSides", 1},
      {"lathe", "rodProfile", 1},      {"lathe", "rodLayers", 1},
      {"lathe", "firstLayerMm", 1},    {"lathe", "overhangAngle", 1},
      {"lathe", "layerHeightMm", 1},   {"lathe", "beadWidthMm", 1},
      {"lathe", "layerShape", 6},      {"lathe", "voxelMm", 6},
      {"lathe", "infill", 3},          {"substrate", "rodAxis", 6},
      {"substrate", "layerShape", 1},  {"substrate", "layerCentre", 1},
      {"substrate", "endSurface", 1},  {"substrate", "firstLayerMm", 1},
      {"substrate", "rodProfile", 6},  {"substrate", "overhangAngle", 1},
      {"trace", "traceAngle", 1},      {"trace", "traceInset", 1},
      {"trace", "traceSpacing", 1},    {"trace", "tracePasses", 1},
      {"trace", "traceClosing", 1},    {"trace", "layerShape", 6},
      {"trace", "traceSidePasses", 1}, {"trace", "traceSideDepth", 1},
      {"trace", "traceFillLines", 1},  {"trace", "traceFillAngle", 1},
      {"substrate", "traceAngle", 6}};
  for (const auto& [mode, key, first] : rows) {
    PlanRequest request = boxRequest();
    request.choices.item().mode = mode;
    if (request.choices.item().mode == "lathe")
      request.choices.cell = "lathe";
    default_ = stageKeys(request);
    test::giveParameters(request.choices, {{key, kParameters.at(key).first}});
    expectChangesFrom(request, first, mode + (std::string(" ") + key));
  }
}

TEST_F(StageKeysOf, APlatformsMeshCountsByItsContent) {
  const fs::path mesh = folder_ / "ground.stl", copy = folder_ / "copy.stl";
  base::writeFile(mesh, "one");
  fs::copy(mesh, copy);
  PlanRequest request = boxRequest();
  request.choices.item().mode = "substrate";
  request.choices.item().platform = project::Platform("mesh:" + mesh.string());
  default_ = stageKeys(request);
  request.choices.item().platform = project::Platform("mesh:" + copy.string());
  expectChangesFrom(request, kStageCount, "a copy of the file");
  base::writeFile(copy, "two");
  expectChangesFrom(request, 0, "another content"); // the body determines the part's place
  fs::remove(copy);
  expectChangesFrom(request, 0, "a file that is gone");
}

TEST_F(StageKeysOf, DefaultOfTheModeIsUsed) {
  PlanRequest request = boxRequest();
  request.choices.item().mode = "lathe";
  request.choices.cell = "lathe";
  default_ = stageKeys(request);
  test::giveParameters(request.choices, {{"infill", "woven"}});
  expectChangesFrom(request, kStageCount, "woven is meant anyway");
  test::giveParameters(request.choices, {{"infill", "zigzag"}});
  expectChangesFrom(request, 3, "zigzag is another choice there");
}

TEST_F(StageKeysOf, ThePartCountsByItsContent) {
  PlanRequest copy = boxRequest();
  copy.item().loaded =
      loadedFrom("box.stl", std::make_shared<geometry::TriangleMesh>(*boxPart()->source), {}, false,
                 {}); // not mended yet: it will be when it is planned
  expectChangesFrom(copy, kStageCount, "a copy of the mesh");
  copy.item().loaded = loadedFrom("other.stl", boxPart()->source, {}, true, {});
  expectChangesFrom(copy, 5, "another name"); // is written into the programs
  auto moved = *boxPart()->source;
  moved.vertices[3].z() += 1e-9;
  copy.item().loaded =
      loadedFrom("box.stl", std::make_shared<geometry::TriangleMesh>(moved), {}, true, {});
  expectChangesFrom(copy, 0, "a vertex moved by nearly nothing");
}

TEST_F(StageKeysOf, RepairMattersWhereThereIsSomethingToMend) {
  auto open = *boxPart()->source;
  open.triangles.pop_back();
  PlanRequest mended, raw;
  mended.item().loaded = raw.item().loaded =
      loadedFrom("open.stl", std::make_shared<geometry::TriangleMesh>(open), {}, true, {});
  raw.choices.item().repair = false;
  EXPECT_NE(stageKeys(mended)[0], stageKeys(raw)[0]);
  // Independent of how the current part was loaded.
  mended.item().loaded = withRepair(mended.item().loaded, false, {});
  EXPECT_NE(stageKeys(mended)[0], stageKeys(raw)[0]);
  raw.item().loaded = mended.item().loaded;
  mended.item().loaded = withRepair(raw.item().loaded, true, {});
  EXPECT_NE(stageKeys(mended)[0], stageKeys(raw)[0]);
}

TEST_F(StageKeysOf, OptionsOfTheGreedySchemeMatterToIt) {
  for (const char* key : {"pieceClusters", "pieceRoot"}) {
    PlanRequest request = boxRequest();
    request.choices.item().mode = "planar";
    test::giveParameters(request.choices, {{"planarScheme", "greedy"}});
    default_ = stageKeys(request);
    test::giveParameter(request.choices, key, kParameters.at(key).first);
    expectChangesFrom(request, 1, key);
  }
}

TEST_F(StageKeysOf, WrongChoicesAreAnErrorBeforeAnythingRuns) {
  PlanRequest request = boxRequest();
  request.choices.item().mode = "curvd";
  EXPECT_THROW(stageKeys(request), base::Error);
  request = boxRequest();
  request.choices.item().placement.rotation.coeffs().setZero();
  EXPECT_THROW(stageKeys(request), base::Error);
  EXPECT_THROW(planPart(request, {}), base::Error);
}

TEST_F(StageKeysOf, TheCellCountsByItsContent) {
  fs::copy(folder_ / "cells" / "ur5-fixed.json", folder_ / "cells" / "other.json");
  replace("cells/other.json", "\"ur5-fixed\"", "\"other\"");
  PlanRequest request = boxRequest();
  request.choices.cell = "other";
  expectChangesFrom(request, 3, "another cell");
  request.choices.item().scale = "fit";
  PlanRequest here = request;
  here.choices.cell = "ur5-fixed";
  EXPECT_NE(stageKeys(request)[0], stageKeys(here)[0]) << "scale to fit asks what is in reach";

  replace("cells/ur5-fixed.json", "\"xyzMm\": [500, 0, 500]", "\"xyzMm\": [500, 0, 510]");
  expectChangesFrom(boxRequest(), 3, "the nozzle stands elsewhere");
}

TEST_F(StageKeysOf, ColoursOfAnArmDoNotMatter) {
  replace("robots/ur5.json", "\"cap\": \"#5d9cc6\"", "\"cap\": \"#00ff00\"");
  expectChangesFrom(boxRequest(), kStageCount, "other lids");
}

TEST_F(StageKeysOf, TheProcessCountsByItsNumbers) {
  const std::tuple<const char*, const char*, std::size_t> rows[] = {
      {"\"label\": \"FDM", "\"label\": \"Other", kStageCount},
      {"\"layerHeightMm\": { \"default\": 0.8", "\"layerHeightMm\": { \"default\": 0.7", 1},
      {"\"beadWidthMm\": { \"default\": 1.2", "\"beadWidthMm\": { \"default\": 1.3", 2},
      {"\"speedMmPerS\": 20.0", "\"speedMmPerS\": 25.0", 3},
      {"\"contactToleranceMm\": 0.4", "\"contactToleranceMm\": 0.3", 1},
      {"[12.0, 6.0]", "[12.0, 7.0]", 1},
      {"\"travelSpeedMmPerS\": 100.0", "\"travelSpeedMmPerS\": 90.0", 4},
      {"\"accelerationMmPerS2\": 500.0", "\"accelerationMmPerS2\": 400.0", 4},
      {"\"bridgeSpeedMmPerS\": 10.0", "\"bridgeSpeedMmPerS\": 9.0", 3},
      {"\"bridgeMm\": 6.0", "\"bridgeMm\": 9.0", 1},
      {"\"head\"", "\"features\": {\"infill\": {\"speedMmPerS\": 30}}, \"head\"", 3},
      {"\"head\"", "\"startLagS\": 0.3, \"head\"", 4},
      {"\"head\"", "\"stopLagS\": 0.3, \"head\"", 4},
      {"\"head\"", "\"overlapFactor\": 0.738, \"head\"", 2},
      {"\"head\"", "\"beadWords\": [{\"format\": \"krl\", \"start\": [\"ARC_ON()\"]}], \"head\"",
       5},
      // Sizes are of flat layers, see below.
      {"\"head\"", "\"scaleX\": 1.01, \"head\"", kStageCount},
      {"\"head\"", "\"scaleY\": 1.01, \"head\"", kStageCount},
      {"\"head\"", "\"outlineOffsetMm\": -0.1, \"head\"", kStageCount},
      {"\"head\"", "\"holeOffsetMm\": 0.1, \"head\"", kStageCount},
      {"\"primeS\": 0.2", "\"primeS\": 0.3", 5},
      {"\"material\": \"PLA\"", "\"material\": \"PETG\"", 5}};
  for (const auto& [was, is, first] : rows) {
    replace("processes/fdm-1.0.json", was, is);
    expectChangesFrom(boxRequest(), first, is);
    replace("processes/fdm-1.0.json", is, was);
  }
}

TEST_F(StageKeysOf, CorrectedSizesMatterToFlatLayers) {
  PlanRequest request = boxRequest();
  request.choices.item().mode = "flat";
  default_ = stageKeys(request);
  for (const char* size :
       {"\"scaleX\": 1.01, \"head\"", "\"scaleY\": 1.01, \"head\"",
        "\"outlineOffsetMm\": -0.1, \"head\"", "\"holeOffsetMm\": 0.1, \"head\""}) {
    replace("processes/fdm-1.0.json", "\"head\"", size);
    expectChangesFrom(request, 2, size);
    replace("processes/fdm-1.0.json", size, "\"head\"");
  }
}

TEST_F(StageKeysOf, BridgingLengthMattersToSupportsAndToolPaths) {
  PlanRequest request = boxRequest();
  request.choices.item().parameters["supports"] = "none";
  default_ = stageKeys(request);
  replace("processes/fdm-1.0.json", "\"bridgeMm\": 6.0", "\"bridgeMm\": 9.0");
  expectChangesFrom(request, 3, "no columns");
}

} // namespace
