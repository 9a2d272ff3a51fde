#include "gui/planned_jobs.h"

#include "helpers/lathe_parts.h"
#include "helpers/octagon_prism.h"
#include "helpers/shapes.h"

namespace voluta::test {

namespace {
constexpr const char* kCuts = R"([{"point": [4, 0, 20], "normal": [1, 0, 0]},
                                  {"point": [-4, 0, 20], "normal": [-1, 0, 0]}])";
constexpr double kRodMm = 40.0, kWidthMm = 3.3;

geometry::TriangleMesh partOf(const std::string& mode) {
  if (mode == "planar")
    return tee(16, 32);
  if (mode == "lathe")
    return revolved({{-8, 2.4}, {-8, 3.5}, {8, 3.5}, {8, 2.4}}, 128);
  if (mode == "substrate")
    return halfCylinderRib(kRodMm, kWidthMm, 1.05, 1.1);
  return box({0, 0, 0}, {9, 9, 5});
}
} // namespace

// Cells and robots that are saved stay in the test's folder.
void PlannedJobTest::SetUp() {
  qputenv("VOLUTA_DATA", folder_.path().toUtf8());
  WindowTest::SetUp();
}

void PlannedJobTest::TearDown() {
  WindowTest::TearDown();
  qunsetenv("VOLUTA_DATA");
}

void PlannedJobTest::planJob(const std::string& mode) {
  openPart(writePart(QString::fromStdString(mode) + ".stl", partOf(mode)));
  project::Choices choices = document().choices();
  choices.item().automatic = false;
  choices.item().mode = mode;
  if (mode == "planar")
    choices.item().parameters["cutPlanes"] = kCuts;
  if (mode == "lathe") {
    choices.cell = "lathe";
    choices.tool().process = "fdm-0.35";
    choices.item().platform = project::Platform("rod:5x200");
  }
  if (mode == "substrate") {
    choices.tool().process = "fdm-0.35";
    choices.item().platform =
        project::Platform("mesh:" + writePart("half.stl", halfCylinder(kRodMm, 20)).toStdString());
    choices.item().parameters = {
        {"firstLayerMm", "0.25"}, {"layerShape", "cylinder"}, {"layerHeightMm", "0.2"}};
  }
  document().setChoices(choices, "job");
  ASSERT_EQ(document().unusable(), nullptr) << document().unusable()->what();
  window().planning().plan(project::Stage::Replay);
  ASSERT_TRUE(planned(project::Stage::Replay)) << mode;
}

bool PlannedJobTest::settled() {
  return waitFor([&] { return !window().planning().running() && !window().presenter().busy(); });
}

} // namespace voluta::test
