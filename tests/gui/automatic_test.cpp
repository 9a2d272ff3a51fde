// Mode Automatic in the window: chosen in the list, planned, told, saved and opened again.
#include "gui/window_fixture.h"
#include "helpers/shapes.h"
#include "pipeline/automatic.h"

#include <QComboBox>
#include <QLabel>
#include <QTest>

namespace voluta::test {
namespace {

using project::Stage;

class AutomaticTest : public WindowTest {
protected:
  void chooseMode(const char* id) {
    auto* combo = find<QComboBox>("mode");
    combo->setFocus();
    combo->setCurrentIndex(combo->findData(QString::fromLatin1(id)));
  }
  QString mode() { return find<QComboBox>("mode")->currentData().toString(); }
  QString notice() { return find<QLabel>("notice")->text(); }
};

TEST_F(AutomaticTest, WhatIsTakenIsTold) {
  openPart(writePart("part.stl", box({0, 0, 0}, {14, 14, 8})));
  chooseMode("auto");
  EXPECT_TRUE(document().choices().automatic);
  EXPECT_FALSE(notice().contains("Taken")) << "nothing is planned";
  clickMenu("runMenu", "planLayers");
  ASSERT_TRUE(planned(Stage::Layers));
  EXPECT_EQ(mode(), "auto");
  const auto& first = pipeline::automaticWays().front();
  EXPECT_EQ(document().choices().mode, first.mode);
  EXPECT_EQ(document().state(Stage::Layers), document::StageState::Done);
  EXPECT_TRUE(notice().contains("Taken: Curved layers, plate of the cell")) << qPrintable(notice());
}

TEST_F(AutomaticTest, WhatWasPlannedByHandIsOutOfDateAndPlanTriesTheWays) {
  openPart(writePart("part.stl", box({0, 0, 0}, {14, 14, 8})));
  chooseMode("curved");
  auto choices = document().choices();
  choices.platform = project::Platform("fit:10");
  window().document().setChoices(choices, "platform");
  clickMenu("runMenu", "planLayers");
  ASSERT_TRUE(planned(Stage::Layers));
  EXPECT_EQ(document().state(Stage::Layers), document::StageState::Done);
  chooseMode("auto");
  EXPECT_NE(document().state(Stage::Layers), document::StageState::Done);
  clickMenu("runMenu", "planLayers");
  ASSERT_TRUE(planned(Stage::Layers));
  EXPECT_TRUE(notice().contains("Taken: Curved layers, plate of the cell")) << qPrintable(notice());
  EXPECT_EQ(document().state(Stage::Layers), document::StageState::Done);
}

TEST_F(AutomaticTest, AWayByHandIsWhatItWas) {
  openPart(writePart("part.stl", box({0, 0, 0}, {14, 14, 8})));
  chooseMode("auto");
  chooseMode("flat");
  EXPECT_FALSE(document().choices().automatic);
  EXPECT_EQ(document().choices().mode, "flat");
  window().document().undoStack()->undo();
  EXPECT_TRUE(document().choices().automatic);
  EXPECT_EQ(mode(), "auto");
}

TEST_F(AutomaticTest, ANewProjectBeginsAsTheProgramSays) {
  project::Choices start;
  start.automatic = true;
  window().document().startWith(start);
  EXPECT_EQ(mode(), "auto");
  openPart(writePart("part.stl", box({0, 0, 0}, {14, 14, 8})));
  EXPECT_EQ(mode(), "auto");
}

} // namespace
} // namespace voluta::test
