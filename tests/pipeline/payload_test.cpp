// The mass that the robot carries: the plate with the print, or the tool.
#include "pipeline/payload.h"

#include "pipeline/box_request.h"
#include "platform/platform_solid.h"
#include "process/own_materials.h"
#include "process/process.h"
#include "robot/cell.h"

#include "curved/platform_polygon.h"

#include <gtest/gtest.h>
#include <random>

using namespace voluta;

namespace {

robot::Cell cellOf(const std::string& id) {
  return robot::loadCell(id, process::loadProcess("fdm-1.0"), curved::platformDisc(200.0));
}

// The UR5 carries 5 kg; the plate is taken as 0.5 kg.
TEST(Payload, ThePrintOnACarriedPlateCounts) {
  const robot::Cell cell = cellOf("ur5-fixed");
  EXPECT_FALSE(pipeline::overload(cell, 1000.0 * 3.9));
  const auto nearly = pipeline::overload(cell, 1000.0 * 4.2);
  ASSERT_TRUE(nearly);
  EXPECT_FALSE(nearly->blocking);
  const auto above = pipeline::overload(cell, 1000.0 * 4.6);
  ASSERT_TRUE(above);
  EXPECT_TRUE(above->blocking);
  EXPECT_EQ(plan::englishReason(*above), "the flange carries 5.1 kg, 4.6 kg of it printed "
                                         "material; the robot is rated for 5 kg");
}

TEST(Payload, IsThatOfTheMassForRandomPrints) {
  const robot::Cell cell = cellOf("ur5-fixed");
  std::mt19937 random(7);
  for (int run = 0; run < 300; ++run) {
    const double kg = std::uniform_real_distribution(0.0, 8.0)(random);
    const auto found = pipeline::overload(cell, 1000.0 * kg);
    EXPECT_EQ(found.has_value(), kg + 0.5 > 4.5) << kg;
    EXPECT_EQ(found && found->blocking, kg + 0.5 > 5.0) << kg;
  }
}

TEST(Payload, APrintOnAFixedPlateDoesNotCount) {
  EXPECT_FALSE(pipeline::overload(cellOf("ur5-moving"), 1000.0 * 100.0));
}

// Each part weighs what its own tool prints, whatever the other one's material.
TEST(Payload, EachPartHasTheDensityOfItsTool) {
  pipeline::PlanRequest request;
  request.items.resize(2);
  request.choices.items.resize(2);
  request.choices.tools = {{"fdm-1.0"}, {process::processTextWith("fdm-1.0", "petg")}};
  for (std::size_t i = 0; i < 2; ++i) {
    request.item(i).loaded = test::loadedBox({-9, -8, 0}, {9, 8, 3});
    request.choices.item(i).mode = "flat";
    request.choices.item(i).placement.centreMm.x() = 60.0 * static_cast<double>(i) - 30.0;
  }
  request.choices.item(1).parameters["tool"] = "2";
  request.until = project::Stage::Load;
  const pipeline::PlanResult placed = pipeline::planPart(request, {});
  const auto densityOf = [&](int tool) {
    return placed.tooling().at(tool).process.material.densityGPerCm3;
  };
  ASSERT_NE(densityOf(0), densityOf(1));
  EXPECT_NEAR(pipeline::solidKg(placed), 18.0 * 16.0 * 3.0 * 1e-6 * (densityOf(0) + densityOf(1)),
              1e-9);
}

} // namespace
