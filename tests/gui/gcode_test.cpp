// A slicer's G-code in the window: opened like a part, its layers and paths are shown, planned and
// exported; its own parameters are offered, and only for such parts.
#include "base/files.h"
#include "forms/parameter_form.h"
#include "gui/window_fixture.h"
#include "helpers/shapes.h"
#include "window/presenters/presenter.h"

#include <cmath>
#include <fmt/format.h>

namespace voluta::test {
namespace {

using project::Stage;

// A block of 27 x 27 x 4 mm: a wall and rows, as Cura comments them.
std::string blockOfCura() {
  std::string text = ";FLAVOR:Marlin\n;Layer height: 0.8\n;Generated with Cura_SteamEngine 5.4.0\n"
                     "M82\nG28\nG92 E0\n;LAYER_COUNT:5\n";
  constexpr int kLow = 40, kHigh = 66;
  constexpr double kInset = 0.9;         // Of the rows' ends from the wall's middle
  constexpr double kPerMm = 0.8 / 2.405; // Filament per mm of beads 1 mm apart
  double e = 0.0;
  for (int layer = 0; layer < 5; ++layer) {
    text += fmt::format(";LAYER:{}\nG0 F6000 X{} Y{} Z{:.1f}\n;TYPE:WALL-OUTER\nG1 F1200\n", layer,
                        kLow, kLow, 0.8 * (layer + 1));
    for (const auto& [x, y] : {std::pair(kHigh, kLow), {kHigh, kHigh}, {kLow, kHigh}, {kLow, kLow}})
      text += fmt::format("G1 X{} Y{} E{:.5f}\n", x, y, e += (kHigh - kLow) * kPerMm);
    text += fmt::format(";TYPE:SKIN\nG0 X{} Y{}\n", kLow + kInset, kLow + 1);
    for (int y = kLow + 1; y < kHigh; ++y) {
      const bool back = (y - kLow) % 2 == 0;
      const double from = back ? kHigh - kInset : kLow + kInset, to = kLow + kHigh - from;
      if (y > kLow + 1)
        text += fmt::format("G1 X{:.1f} Y{} E{:.5f}\n", from, y, e += kPerMm);
      text += fmt::format("G1 X{:.1f} Y{} E{:.5f}\n", to, y, e += std::abs(to - from) * kPerMm);
    }
  }
  return text + "M104 S0\nM84\n";
}

class GcodeTest : public WindowTest {
protected:
  QString writeGcode() {
    const QString file = path("block.gcode");
    base::writeFile(file.toStdString(), blockOfCura());
    return file;
  }
  bool offers(const char* group) {
    const auto* field = window().findChild<QWidget*>(group);
    return field && !field->isHidden();
  }
  bool offersPaths() { return offers("Paths of the file"); }
};

TEST_F(GcodeTest, AFileIsOpenedShownPlannedAndExported) {
  openPart(writePart("box.stl", box({0, 0, 0}, {10.0, 10.0, 4.0})));
  EXPECT_FALSE(offersPaths());
  EXPECT_TRUE(offers("Tool-paths"));
  window().open(writeGcode());
  ASSERT_TRUE(waitFor([&] { return document().source() && document().source()->toolPaths; }));
  ASSERT_TRUE(planned(Stage::Load));
  EXPECT_NEAR(window().presenter().partBox().sizes().z(), 4.0, 1e-6);
  EXPECT_TRUE(offersPaths());
  EXPECT_FALSE(offers("Tool-paths")) << "walls and infill are those of the file";
  keepPicture(window(), "gcode-prepare");
  choosePage(Page::Layers);
  const QImage before = picture();
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Replay));
  EXPECT_GT(differingShare(before, picture()), 0.005) << "the paths are shown";
  keepPicture(window(), "gcode-layers");
  const auto result = document().result(Stage::Replay);
  EXPECT_TRUE(result->job.report.replay.passed);
  EXPECT_EQ(result->job.report.item().layers.count, 5);
  EXPECT_EQ(result->job.toolPlan->paths.size(), 10u);
  choosePage(Page::Simulate);
  keepPicture(window(), "gcode-simulate");
}

TEST_F(GcodeTest, BentOntoACylinderByItsOwnParameters) {
  openPart(writeGcode());
  document().setParameter("pathsOn", "cylinder");
  document().setParameter("pathsRadiusMm", "30");
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Replay));
  const auto result = document().result(Stage::Replay);
  EXPECT_TRUE(result->job.report.replay.passed);
  ASSERT_TRUE(result->job.item().platform.mesh) << "a body is made below it";
  choosePage(Page::Layers);
  picture();
  keepPicture(window(), "gcode-cylinder");
}

TEST_F(GcodeTest, AFileIsAddedBesideAPart) {
  openPart(writePart("box.stl", box({0, 0, 0}, {16.0, 16.0, 4.0})));
  chooseFlat();
  ASSERT_TRUE(planned(Stage::Load));
  answerFileDialog(writeGcode());
  clickMenu("fileMenu", "addPart");
  ASSERT_TRUE(waitFor([&] { return document().partCount() == 2 && document().sourceReady(); }));
  ASSERT_TRUE(planned(Stage::Load));
  EXPECT_TRUE(offersPaths()) << "the file is active";
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Replay));
  const auto result = document().result(Stage::Replay);
  EXPECT_TRUE(result->job.report.replay.passed);
  EXPECT_EQ(result->job.report.toolpath.items.size(), 2u);
  choosePage(Page::Layers);
  picture();
  keepPicture(window(), "gcode-beside");
}

} // namespace
} // namespace voluta::test
