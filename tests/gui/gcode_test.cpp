// A slicer's G-code in the window: opened like a part, its layers and paths are shown, planned and
// exported; its own parameters are offered, and only for such parts.
#include "base/files.h"
#include "forms/parameter_form.h"
#include "gui/window_fixture.h"
#include "helpers/shapes.h"
#include "window/presenters/presenter.h"

#include <QComboBox>
#include <QDir>
#include <QUndoStack>
#include <fmt/format.h>

namespace voluta::test {
namespace {

using project::Stage;

// A block of 16 x 16 x 4 mm: a wall and rows, as Cura comments them.
std::string blockOfCura() {
  std::string text = ";FLAVOR:Marlin\n;Layer height: 0.8\n;Generated with Cura_SteamEngine 5.4.0\n"
                     "M82\nG28\nG92 E0\n;LAYER_COUNT:5\n";
  const double perMm = 0.8 / 2.405; // Filament per mm of a bead 0.8 high, 1 wide
  double e = 0.0;
  for (int layer = 0; layer < 5; ++layer) {
    text += fmt::format(";LAYER:{}\nG0 F6000 X42 Y42 Z{:.1f}\n;TYPE:WALL-OUTER\nG1 F1200\n", layer,
                        0.8 * (layer + 1));
    for (const auto& [x, y] : {std::pair(58, 42), {58, 58}, {42, 58}, {42, 42}})
      text += fmt::format("G1 X{} Y{} E{:.5f}\n", x, y, e += 16.0 * perMm);
    text += ";TYPE:SKIN\nG0 X43 Y43\n";
    for (int row = 0; row < 15; ++row) {
      const int from = row % 2 ? 57 : 43, to = 100 - from;
      if (row > 0)
        text += fmt::format("G1 X{} Y{} E{:.5f}\n", from, 43 + row, e += perMm);
      text += fmt::format("G1 X{} Y{} E{:.5f}\n", to, 43 + row, e += 14.0 * perMm);
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
  bool offersPaths() {
    const auto* field = window().findChild<QWidget*>("Paths of the file");
    return field && !field->isHidden();
  }
};

TEST_F(GcodeTest, AFileIsOpenedShownPlannedAndExported) {
  openPart(writePart("box.stl", box({0, 0, 0}, {10.0, 10.0, 4.0})));
  EXPECT_FALSE(offersPaths());
  openPart(writeGcode());
  ASSERT_TRUE(document().source());
  ASSERT_TRUE(document().source()->toolPaths);
  EXPECT_NEAR(window().presenter().partBox().sizes().z(), 4.0, 1e-6);
  EXPECT_TRUE(offersPaths());
  keepPicture(window(), "gcode-prepare");
  choosePage(Page::Layers);
  const QImage before = picture();
  window().planning().plan(Stage::Replay);
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
  window().planning().plan(Stage::Toolpath);
  ASSERT_TRUE(planned(Stage::Toolpath));
  const auto result = document().result(Stage::Toolpath);
  ASSERT_TRUE(result->job.item().platform.mesh) << "a body is made below it";
  choosePage(Page::Layers);
  picture();
  keepPicture(window(), "gcode-cylinder");
  document().undoStack()->undo();
  document().undoStack()->undo();
  window().planning().plan(Stage::Toolpath);
  ASSERT_TRUE(planned(Stage::Toolpath));
  EXPECT_FALSE(document().result(Stage::Toolpath)->job.item().platform.mesh);
}

} // namespace
} // namespace voluta::test
