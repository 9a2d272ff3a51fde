// Contract of every file in resources/materials, and the tools that use them.
#include "process/material.h"

#include "base/error.h"
#include "base/files.h"
#include "helpers/temporary_folder.h"
#include "process/cooling.h"
#include "process/own_materials.h"
#include "process/tooling.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <random>

namespace voluta::process {
namespace {

class Materials : public ::testing::Test {
protected:
  void SetUp() override { setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1); }
};

TEST_F(Materials, everyOneKeepsItsContract) {
  const std::vector<std::string> ids = materialIds();
  ASSERT_GE(ids.size(), 3u);
  for (const std::string& id : ids) {
    SCOPED_TRACE(id);
    const Material m = loadMaterial(id);
    EXPECT_EQ(m.id, id);
    EXPECT_TRUE(m.comesWithProgram);
    EXPECT_GT(m.densityGPerCm3, 0.5);
    EXPECT_LT(m.densityGPerCm3, 12.0);
    ASSERT_TRUE(m.nozzleC);
    EXPECT_TRUE(prints(m, *m.nozzleC));
    EXPECT_FALSE(prints(m, m.nozzleMaxC + 1));
    EXPECT_LE(m.fan, 1.0);
    EXPECT_EQ(materialNamed(m.label).id, id) << "processes name it by its label";
    Material back = readMaterialText(materialText(m), id);
    EXPECT_FALSE(back.comesWithProgram);
    back.comesWithProgram = true;
    EXPECT_EQ(back, m) << "written back the same";
  }
}

TEST_F(Materials, theDefaultIsPla) {
  EXPECT_EQ(Material(), loadMaterial("pla"));
  EXPECT_EQ(loadProcess("fdm-1.0").material, Material());
}

TEST_F(Materials, anUnknownNameHasNoTemperature) {
  const Material m = materialNamed("Wood-fill 40");
  EXPECT_EQ(m.label, "Wood-fill 40");
  EXPECT_FALSE(m.nozzleC);
  EXPECT_EQ(m.densityGPerCm3, 0.0);
  EXPECT_FALSE(m.comesWithProgram);
  EXPECT_TRUE(prints(m, 300.0));
  EXPECT_FALSE(prints(m, 500.0));
}

Material randomMaterial(std::mt19937_64& random) {
  const auto chance = [&] { return random() % 2 == 0; };
  const auto share = [&] { return static_cast<double>(random() % 1001) / 1000.0; };
  Material m;
  m.id = "own-" + std::to_string(random() % 1000);
  m.label = "Ow\"n \xC3\xA8 " + std::to_string(random() % 1000);
  m.densityGPerCm3 = 0.1 + 7.0 * share();
  m.nozzleMinC = 100 + static_cast<int>(random() % 100);
  m.nozzleMaxC = m.nozzleMinC + static_cast<int>(random() % 100);
  m.nozzleC = m.nozzleMinC + (m.nozzleMaxC - m.nozzleMinC) / 2;
  m.bedC = static_cast<int>(random() % 120);
  if (chance()) {
    m.nozzleC = m.bedC = std::nullopt;
    m.nozzleMinC = 100;
    m.nozzleMaxC = 450;
  }
  m.fan = share();
  if (chance())
    m.bridgeFan = share();
  if (chance())
    m.maxFlowMm3PerS = 0.1 + 50.0 * share();
  m.bridgeWidths = 10.0 * share();
  if (chance())
    m.bridgeMm = 10.0 * share();
  m.bridges.clear();
  for (double width = 0.1 + share(); chance(); width += 0.1 + share())
    m.bridges.push_back({width, 30.0 * share()});
  if (chance())
    m.minLayerTimeS = 0.5 + 100.0 * share();
  if (chance())
    m.maxLayerTimeS = 101.0 + 1000.0 * share();
  m.pricePerKg = 100.0 * share();
  m.colour = "#0a1B2c";
  m.notes = chance() ? "dry at 60" : "";
  m.comesWithProgram = false;
  return m;
}

TEST_F(Materials, areReadAsTheyWereWritten) {
  std::mt19937_64 random(5);
  for (int n = 0; n < 300; ++n) {
    const Material m = randomMaterial(random);
    EXPECT_EQ(readMaterialText(materialText(m), "a.json"), m) << materialText(m);
  }
}

TEST_F(Materials, needNoMoreThanTheirDensity) {
  const Material m =
      readMaterialText(R"({"id": "clay", "label": "Clay", "densityGPerCm3": 2})", "a.json");
  EXPECT_FALSE(m.nozzleC || m.bedC || m.bridgeFan || m.maxFlowMm3PerS || m.bridgeMm);
  EXPECT_FALSE(m.minLayerTimeS || m.maxLayerTimeS);
  EXPECT_EQ(m.fan, 0.0);
  EXPECT_EQ(m.pricePerKg, 0.0);
}

// Each error is one line with the file and the key.
TEST_F(Materials, namesFileAndKeyOfABadValue) {
  const struct {
    const char *key, *value;
  } cases[] = {{"densityGPerCm3", "0"},
               {"densityGPerCm3", "\"light\""},
               {"bedC", "-1"},
               {"bedC", "400"},
               {"fan", "1.5"},
               {"bridgeFan", "-0.1"},
               {"maxFlowMm3PerS", "0"},
               {"bridgeMm", "-1"},
               {"bridgeWidths", "-1"},
               {"bridgeSagMm", "-1"},
               {"bridges", "20"},
               {"bridges", "[20]"},
               {"bridges", "[[0.4, 20, 1]]"},
               {"bridges", "[[0, 20]]"},
               {"bridges", "[[0.4, -20]]"},
               {"bridges", "[[0.4, 2000]]"},
               {"bridges", "[[0.4, null]]"},
               {"bridges", "[[0.4, 20], [0.4, 10]]"},
               {"pricePerKg", "-1"},
               {"colour", "\"red\""},
               {"notes", "3"},
               {"density", "1"},
               {"minLayerTimeS", "0"},
               {"minLayerTimeS", "4000"},
               {"maxLayerTimeS", "-1"},
               {"minLayerTimeS", "50, \"maxLayerTimeS\": 40"}};
  for (const auto& c : cases) {
    std::string text = R"({"id": "a", "label": "A", )";
    if (c.key != std::string("densityGPerCm3"))
      text += R"("densityGPerCm3": 1, )";
    text += "\"" + std::string(c.key) + "\": " + c.value + "}";
    try {
      readMaterialText(text, "own.json");
      ADD_FAILURE() << text;
    } catch (const base::Error& e) {
      const std::string line = e.what();
      EXPECT_NE(line.find("own.json"), std::string::npos) << line;
      EXPECT_NE(line.find(c.key), std::string::npos) << line;
      EXPECT_EQ(line.find('\n'), std::string::npos) << line;
    }
  }
}

TEST_F(Materials, boundTheFlowAndTheBridgesOfAProcess) {
  Process p = loadProcess("fdm-1.0");
  EXPECT_EQ(flowLimit(p), p.maxFlowMm3PerS);
  p.material.maxFlowMm3PerS = 12.0;
  EXPECT_EQ(flowLimit(p), 12.0);
  p.material.maxFlowMm3PerS = 100.0;
  EXPECT_EQ(flowLimit(p), p.maxFlowMm3PerS);
}

TEST_F(Materials, bridgeFartherWithALittleSag) {
  Process p = loadProcess("fdm-0.4");
  EXPECT_DOUBLE_EQ(p.bridgeMm, 4.0);
  EXPECT_DOUBLE_EQ(saggingBridgeMm(p), 20.0) << "as PLA states for 0.45 mm";
  EXPECT_DOUBLE_EQ(saggingBridgeMm(p, 1.2), 12.0) << "of the bead, not of the process";
  EXPECT_DOUBLE_EQ(saggingBridgeMm(p, 1e6), p.bridgeMm) << "never less than without";
  p.material.bridgeMm = 7.0;
  EXPECT_DOUBLE_EQ(saggingBridgeMm(p), 7.0) << "whatever the process allows";
  p.material.bridges.clear();
  EXPECT_DOUBLE_EQ(saggingBridgeMm(p), p.bridgeMm);
}

TEST_F(Materials, bridgeAsTheirTableStates) {
  Material m;
  m.bridges = {{0.4, 20.0}, {0.8, 12.0}, {1.6, 10.0}};
  EXPECT_DOUBLE_EQ(bridgedMm(m, 0.2), 20.0) << "no more than the narrowest";
  EXPECT_DOUBLE_EQ(bridgedMm(m, 0.4), 20.0);
  EXPECT_DOUBLE_EQ(bridgedMm(m, 0.6), 16.0);
  EXPECT_DOUBLE_EQ(bridgedMm(m, 0.8), 12.0);
  EXPECT_DOUBLE_EQ(bridgedMm(m, 1.2), 11.0);
  EXPECT_NEAR(bridgedMm(m, 256.0 * 1.6), 10.0 / 8.0, 1e-12) << "256^(3/8) = 8";
  m.bridges.clear();
  EXPECT_EQ(bridgedMm(m, 0.4), 0.0) << "unknown";
}

TEST_F(Materials, ofOlderFilesStateOneLength) {
  const Material m = readMaterialText(
      R"({"id": "a", "label": "A", "densityGPerCm3": 1, "bridgeSagMm": 12})", "a.json");
  EXPECT_EQ(m.bridges, (std::vector<BridgedLength>{{0.45, 12.0}}));
  EXPECT_EQ(readMaterialText(materialText(m), "a.json"), m);
}

TEST_F(Materials, thatComeWithTheProgramBridgeLessWithWiderBeads) {
  for (const std::string& id : materialIds()) {
    const Material m = loadMaterial(id);
    ASSERT_FALSE(m.bridges.empty()) << id;
    for (std::size_t i = 0; i + 1 < m.bridges.size(); ++i)
      EXPECT_GT(m.bridges[i].lengthMm, m.bridges[i + 1].lengthMm) << id;
  }
}

TEST_F(Materials, theFanIsOffInTheFirstLayer) {
  Material m;
  m.fan = 0.5;
  plan::ToolPath path;
  EXPECT_EQ(fanShare(m, path), 0.0);
  path.layer = 1;
  EXPECT_EQ(fanShare(m, path), 0.5);
  path.kind = plan::PathKind::Bridge;
  EXPECT_EQ(fanShare(m, path), 0.5);
  m.bridgeFan = 1.0;
  EXPECT_EQ(fanShare(m, path), 1.0);
  path.layer = 0;
  EXPECT_EQ(fanShare(m, path), 0.0);
}

class OwnMaterials : public Materials {
protected:
  void SetUp() override {
    Materials::SetUp();
    setenv("VOLUTA_DATA", (folder_ / "data").c_str(), 1);
  }
  void TearDown() override { unsetenv("VOLUTA_DATA"); }
  std::filesystem::path write(const std::string& text) const {
    base::writeFile(folder_ / "own.json", text);
    return folder_ / "own.json";
  }
  test::TemporaryFolder folder_; // tests of one program may run at the same time
};

TEST_F(OwnMaterials, areImportedUsedAndExported) {
  Material m = loadMaterial("petg");
  m.id = "my-petg";
  m.label = "My PETG";
  m.bridgeMm = 4.0;
  m.maxFlowMm3PerS = 8.0;
  m.comesWithProgram = false;
  importMaterial(write(materialText(m)));
  EXPECT_EQ(loadMaterial("my-petg"), m);
  EXPECT_EQ(materialNamed("My-PETG"), m);
  const Process p = readProcessText(processTextWith("fdm-1.0", "my-petg"), "a.json");
  EXPECT_EQ(p.material, m);
  const std::string text = processTextWith("fdm-1.0", "my-petg");
  std::filesystem::remove(folder_ / "data" / "materials" / "my-petg.json");
  EXPECT_EQ(readProcessText(text, "a.json").material, m) << "the process needs no other file";
  importMaterial(write(materialText(m)));
  EXPECT_EQ(readProcessText(processTextWith(text, "pla"), "a.json").material, Material());
  // A file is as good as an id, wherever it lies.
  const std::string file = folder_ / "other.json";
  exportMaterial("my-petg", file);
  EXPECT_EQ(processTextWith("fdm-1.0", file), text);
  EXPECT_EQ(p.bridgeMm, 4.0) << "five bead widths are more than the material bridges";
  EXPECT_EQ(flowLimit(p), 8.0);
  exportMaterial("my-petg", folder_ / "out.json");
  EXPECT_EQ(readMaterialText(base::readFile(folder_ / "out.json"), ""), m);
}

TEST_F(OwnMaterials, cannotReplaceThoseOfTheProgramOrLeaveTheirFolder) {
  Material m;
  EXPECT_THROW(importMaterial(write(materialText(m))), base::Error);
  for (const char* id : {"", "../a", "a/b", ".a", "A b"}) {
    m.id = id;
    EXPECT_THROW(importMaterial(write(materialText(m))), base::Error) << id;
  }
  EXPECT_EQ(materialIds().size(), 3u);
  EXPECT_THROW(chosenMaterial("plaa"), base::Error);
}

TEST_F(Materials, refusesInvalidValues) {
  const auto text = [](const char* nozzle, const char* fan, const char* colour) {
    return std::string(R"({"id": "a", "label": "A", "densityGPerCm3": 1, "nozzleC": )") + nozzle +
           R"(, "bedC": 0, "bridgeWidths": 5, "pricePerKg": 0, "fan": )" + fan +
           R"(, "colour": ")" + colour + "\"}";
  };
  const char* usual = R"({"default": 200, "min": 180, "max": 220})";
  EXPECT_EQ(readMaterialText(text(usual, "0.5", "#a0B1c2"), "a.json").fan, 0.5);
  for (const std::string& bad :
       {text(usual, "1.5", "#a0B1c2"), text(usual, "0.5", "red"), std::string("{}"),
        text(R"({"default": 230, "min": 180, "max": 220})", "0.5", "#a0B1c2"),
        text(R"({"default": 170, "min": 180, "max": 220})", "0.5", "#a0B1c2")})
    EXPECT_THROW(readMaterialText(bad, "a.json"), base::Error) << bad;
}

TEST_F(Materials, aProcessStatesTheDensityOfAMaterialWithoutAFile) {
  std::string text = R"({"id": "own", "label": "Own", "nozzleDiameterMm": 1.0,
    "layerHeightMm": {"default": 0.8, "min": 0.4, "max": 1.0},
    "beadWidthMm": {"default": 1.2, "min": 1.0, "max": 2.0}, "stepMm": 1, "speedMmPerS": 20,
    "travelSpeedMmPerS": 100, "accelerationMmPerS2": 500, "contactToleranceMm": 0.4,
    "maxFlowMm3PerS": 40, "primeS": 0.2, "material": "MATERIAL",
    "head": [[0, 1], [10, 5]]})";
  const auto with = [&](const std::string& material, const std::string& more) {
    std::string own = text;
    own.replace(own.find("MATERIAL\""), 9, material + "\"" + more);
    return own;
  };
  EXPECT_EQ(readProcessText(with("PETG", ""), "own.json").material, loadMaterial("petg"));
  EXPECT_EQ(readProcessText(with("petg", R"(, "densityGPerCm3": 1.3)"), "own.json")
                .material.densityGPerCm3,
            1.3);
  EXPECT_EQ(readProcessText(with("clay", R"(, "densityGPerCm3": 2)"), "own.json").material.label,
            "clay");
  EXPECT_THROW(readProcessText(with("clay", ""), "own.json"), base::Error);
}

TEST(Tooling, findsTheToolOfAPath) {
  Tool fine, wide;
  fine.process.id = "fine";
  wide.process.id = "wide";
  const Tooling tooling({fine, wide});
  plan::ToolPath path;
  EXPECT_EQ(tooling.of(path).process.id, "fine");
  path.tool = 1;
  EXPECT_EQ(tooling.of(path).process.id, "wide");
  EXPECT_EQ(&tooling.of(path), &Tooling(tooling).of(path)) << "copies share the tools";
  path.tool = 2;
  EXPECT_THROW(tooling.of(path), base::Error);
  EXPECT_THROW(Tooling(std::vector<Tool>()), base::Error);
  const Tooling one{Process()};
  EXPECT_EQ(one.tools().size(), 1u);
}

} // namespace
} // namespace voluta::process
