// Contract of every file in resources/materials, and the tools that use them.
#include "process/material.h"

#include "base/error.h"
#include "process/tooling.h"

#include <algorithm>
#include <cstdlib>
#include <gtest/gtest.h>

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

TEST_F(Materials, refusesWhatCannotBe) {
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
