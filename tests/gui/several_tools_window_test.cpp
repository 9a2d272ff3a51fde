// Two parts in two materials, by mouse and keys: from the files to the exported program.
#include "base/files.h"
#include "gui/window_fixture.h"
#include "helpers/shapes.h"

#include <QAction>
#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>

namespace voluta::test {
namespace {

using project::Stage;

class SeveralToolsTest : public WindowTest {
protected:
  void openTwoParts() {
    openPart(writePart("plinth.stl", box({0, 0, 0}, {20.0, 20.0, 4.0})));
    project::Choices choices = document().choices();
    choices.item().automatic = false;
    choices.item().mode = "flat";
    choices.cell = "ur5-moving";
    document().setChoices(choices, "flat");
    ASSERT_TRUE(planned(Stage::Load));
    answerFileDialog(writePart("tower.stl", box({0, 0, 0}, {14.0, 14.0, 4.0})));
    clickMenu("fileMenu", "addPart");
    ASSERT_TRUE(waitFor([&] {
      return document().partCount() == 2 && document().sourceReady() &&
             !window().planning().running() && document().upToDate(Stage::Load) &&
             !window().presenter().busy();
    }));
  }
  // As a user chooses an entry of a box with the keyboard.
  void chooseEntry(const char* name, const QString& text) {
    auto* box = find<QComboBox>(name);
    ASSERT_TRUE(box->isVisible()) << name;
    box->setFocus();
    const int wanted = box->findData(text) >= 0 ? box->findData(text) : box->findText(text);
    ASSERT_GE(wanted, 0) << text.toStdString();
    while (box->currentIndex() != wanted)
      QTest::keyClick(box, box->currentIndex() < wanted ? Qt::Key_Down : Qt::Key_Up);
  }
  void click(const char* button) {
    ASSERT_TRUE(find<QToolButton>(button)->isVisible()) << button;
    QTest::mouseClick(find<QToolButton>(button), Qt::LeftButton);
  }
  bool isRowShown(const char* key) {
    auto* row = window().findChild<QWidget*>(key);
    return row && row->isVisibleTo(&window());
  }
};

TEST_F(SeveralToolsTest, AToolIsAddedChangedRemovedAndUndone) {
  openTwoParts();
  EXPECT_FALSE(isRowShown("supportTool"));
  click("toolAdd");
  EXPECT_EQ(document().choices().tools.size(), 2u);
  EXPECT_TRUE(isRowShown("supportTool"));
  chooseEntry("toolMaterial2", "petg");
  EXPECT_NE(document().choices().tool(1).process, document().choices().tool(0).process);
  keepPicture(window(), "tools_two");
  for (std::size_t tools = 3; tools <= 4; ++tools) {
    click("toolAdd");
    EXPECT_EQ(document().choices().tools.size(), tools);
  }
  EXPECT_FALSE(find<QToolButton>("toolAdd")->isVisible());
  click("toolRemove3");
  EXPECT_EQ(document().choices().tools.size(), 3u);
  click("toolRemove2");
  click("toolRemove2");
  EXPECT_EQ(document().choices().tools.size(), 1u);
  EXPECT_FALSE(isRowShown("supportTool"));
  for (int k = 0; k < 3; ++k)
    document().undoStack()->undo();
  EXPECT_EQ(document().choices().tools.size(), 4u);
}

TEST_F(SeveralToolsTest, TwoPartsInTwoMaterialsAreExported) {
  openTwoParts();
  click("toolAdd");
  chooseEntry("toolMaterial2", "petg");
  document().setParameter("tool", "2"); // of the part that was added last
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Replay));
  const auto result = document().result(Stage::Replay);
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->job.report.replay.passed);
  EXPECT_EQ(result->job.report.motion.toolChanges, 1u);
  choosePage(Page::Layers);
  auto* colours = find<QComboBox>("colourBy");
  ASSERT_GE(colours->findText("Tool"), 0);
  colours->setCurrentIndex(colours->findText("Tool"));
  ASSERT_TRUE(waitFor([&] { return !window().presenter().busy(); }));
  keepPicture(window(), "tools_layers");
  choosePage(Page::Export);
  keepPicture(window(), "tools_export");
}

} // namespace
} // namespace voluta::test
