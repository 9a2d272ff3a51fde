// The Prepare page as a designer sees it: part and plate in the view, tools beside them, numbers
// typed for the handles, copies.
#include "gui/window_fixture.h"
#include "helpers/shapes.h"
#include "panels/part_list.h"
#include "window/view_tools.h"

#include <QAction>
#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>
#include <QTreeWidgetItemIterator>
#include <QUndoStack>
#include <algorithm>
#include <string>
#include <vector>

namespace voluta::test {
namespace {

using project::Stage;

class PrepareViewTest : public WindowTest {
protected:
  void openFlat(const Eigen::Vector3d& size = {20.0, 30.0, 12.0}) {
    openPart(writePart("plinth.stl", box({0, 0, 0}, size)));
    chooseFlat("rect:200x200");
    ASSERT_TRUE(settled());
    QTest::qWait(50); // the plate is drawn and framed
  }
  bool settled() {
    return waitFor([&] {
      return document().sourceReady() && !window().planning().running() &&
             (document().partCount() == 0 || document().upToDate(Stage::Load)) &&
             !window().presenter().busy();
    });
  }
  const scene::ViewState& view() { return window().viewport().view(); }
  // Pixels in the part's colour.
  double partShare() {
    const QImage shown = picture();
    long long found = 0;
    for (int y = 0; y < shown.height(); ++y)
      for (int x = 0; x < shown.width(); ++x) {
        const QColor c = shown.pixelColor(x, y);
        found += c.blue() > c.red() + 60;
      }
    return static_cast<double>(found) / (static_cast<double>(shown.width()) * shown.height());
  }
  void key(Qt::Key key) { QTest::keyClick(&window(), key); }
  // As a user: to the widget that has the focus.
  void type(const char* keys) {
    for (const char* c = keys; *c; ++c)
      QTest::keyClick(QApplication::focusWidget(), *c);
  }
  void enter() { QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return); }
  const geometry::Placement& placement() { return document().choices().item().placement; }
  std::vector<std::string> labels() { return window().viewport().scene().sizeLabels(); }
  QToolButton* tool(const char* action) {
    return find<window::ViewTools>("viewTools")->button(find<QAction>(action));
  }
};

TEST_F(PrepareViewTest, PartAndPlateAreInTheMiddleAndTheArmIsDimmed) {
  openFlat();
  EXPECT_TRUE(view().cell);
  EXPECT_TRUE(view().cellDimmed);
  EXPECT_TRUE(view().plateRuled);
  const std::vector<std::string> shown = labels();
  ASSERT_EQ(shown.size(), 4u) << "the origin is below the part";
  EXPECT_EQ(shown[0], "X 20.0 mm");
  EXPECT_EQ(shown[1], "Y 30.0 mm");
  EXPECT_EQ(shown[2], "Z 12.0 mm");
  EXPECT_EQ(shown[3], "200 \u00d7 200 mm");
  const double home = partShare();
  EXPECT_GT(home, 0.002);
  keepPicture(window(), "prepare_home");
  key(Qt::Key_Z);
  const double near = partShare();
  EXPECT_GT(near, 0.08);
  EXPECT_GT(near, 2.0 * home);
  keepPicture(window(), "prepare_z");
  key(Qt::Key_Home);
  EXPECT_NEAR(partShare(), home, 0.2 * home);
  key(Qt::Key_A);
  EXPECT_FALSE(view().cellDimmed);
  EXPECT_TRUE(find<QAction>("showArm")->isChecked());
  keepPicture(window(), "prepare_arm");
  key(Qt::Key_A);
  EXPECT_TRUE(view().cellDimmed);
  choosePage(Page::Simulate);
  EXPECT_TRUE(view().cell);
  EXPECT_FALSE(view().cellDimmed);
  EXPECT_FALSE(view().plateRuled);
  EXPECT_TRUE(labels().empty());
}

TEST_F(PrepareViewTest, HiddenThingsDoNotCountForHome) {
  openFlat();
  const double home = partShare();
  auto* tree = find<QTreeWidget>("tree");
  for (QTreeWidgetItemIterator at(tree); *at; ++at)
    if ((*at)->text(0) == "Platform")
      QTest::mouseClick(
          tree->viewport(), Qt::LeftButton, {},
          QPoint(tree->columnViewportPosition(2) + 8, tree->visualItemRect(*at).center().y()));
  ASSERT_FALSE(view().platform);
  key(Qt::Key_Home);
  EXPECT_GT(partShare(), 2.0 * home);
  keepPicture(window(), "prepare_without_plate");
}

// Read by a program of its own, and drawn as any part.
TEST_F(PrepareViewTest, AStepFileOpensAsAPart) {
  openPart(QStringLiteral(VOLUTA_SOURCE_DIR "/tests/install/box.step"));
  ASSERT_TRUE(settled());
  EXPECT_EQ(document().name(), QStringLiteral("box")) << "the name of the product";
  const std::vector<std::string> shown = labels();
  ASSERT_GE(shown.size(), 3u);
  EXPECT_EQ(shown[0], "X 10.0 mm");
  EXPECT_EQ(shown[2], "Z 30.0 mm");
}

TEST_F(PrepareViewTest, ToolsAreInTheViewWithTheirKeys) {
  EXPECT_FALSE(find<window::ViewTools>("viewTools")->isVisible()) << "no part";
  openFlat();
  EXPECT_TRUE(find<window::ViewTools>("viewTools")->isVisible());
  for (const char* action :
       {"addPart", "removePart", "duplicatePart", "copiesOfPart", "arrangeParts", "toolMove",
        "toolTurn", "toolScale", "toolLayFlat", "toolMeasure", "dropToPlate", "centrePart"}) {
    QToolButton* button = tool(action);
    ASSERT_NE(button, nullptr) << action;
    EXPECT_TRUE(button->isVisible()) << action;
    EXPECT_GE(button->width(), 40) << action;
    EXPECT_FALSE(button->icon().isNull()) << action;
    EXPECT_TRUE(button->toolTip().endsWith(')')) << action << ": the key is missing";
    EXPECT_TRUE(window().viewport().rect().contains(
        QRect(button->mapTo(&window().viewport(), QPoint(0, 0)), button->size())))
        << action;
  }
  // On a small screen they are smaller, and still beside each other.
  const QSize usual = window().size();
  window().resize(853, 533);
  ASSERT_TRUE(waitFor([&] { return tool("toolMove")->width() < 40; }, 5000));
  EXPECT_GE(tool("toolMove")->width(), 28);
  EXPECT_LE(tool("centrePart")->x() - tool("toolMove")->x(), tool("toolMove")->width())
      << "two columns at most";
  EXPECT_TRUE(tool("centrePart")->visibleRegion().contains(tool("centrePart")->rect().center()));
  keepPicture(window(), "prepare_small");
  window().resize(usual);
  QTest::mouseClick(tool("toolMove"), Qt::LeftButton);
  EXPECT_EQ(window().viewport().tool(), viewer::Tool::Move);
  QTest::mouseClick(tool("removePart"), Qt::LeftButton);
  EXPECT_EQ(document().partCount(), 0u);
  EXPECT_FALSE(find<window::ViewTools>("viewTools")->isVisible());
  document().undoStack()->undo();
  EXPECT_EQ(document().partCount(), 1u);
  ASSERT_TRUE(settled());
  choosePage(Page::Simulate);
  EXPECT_FALSE(find<window::ViewTools>("viewTools")->isVisible());
}

TEST_F(PrepareViewTest, NumbersAreTypedForTheHandles) {
  openFlat();
  key(Qt::Key_M);
  type("x10");
  EXPECT_DOUBLE_EQ(placement().centreMm.x(), 0.0) << "a preview until Enter";
  keepPicture(window(), "prepare_typed");
  enter();
  EXPECT_DOUBLE_EQ(placement().centreMm.x(), 10.0);
  ASSERT_TRUE(settled());
  type("y-2.5");
  enter();
  EXPECT_DOUBLE_EQ(placement().centreMm.y(), -2.5);
  ASSERT_TRUE(settled());
  type("x99");
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
  EXPECT_DOUBLE_EQ(placement().centreMm.x(), 10.0);
  EXPECT_EQ(window().viewport().tool(), viewer::Tool::Move);
  document().undoStack()->undo();
  document().undoStack()->undo();
  EXPECT_TRUE(placement().centreMm.isZero());
  ASSERT_TRUE(settled());
  key(Qt::Key_R);
  type("z90");
  enter();
  ASSERT_TRUE(settled());
  EXPECT_EQ(labels()[0], "X 30.0 mm");
  key(Qt::Key_S);
  type("150");
  enter();
  ASSERT_TRUE(settled());
  EXPECT_EQ(labels()[0], "X 45.0 mm");
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Escape);
  EXPECT_EQ(window().viewport().tool(), viewer::Tool::None);
  type("x");
  EXPECT_TRUE(view().sectionOn) << "without handles, a key of a command";
}

TEST_F(PrepareViewTest, ASizeInMmOrInchesScalesThePart) {
  openFlat();
  find<QTabWidget>("prepareTabs")->setCurrentIndex(1);
  auto* placing = find<QWidget>("placement");
  const auto enterSize = [&](const char* name, const char* text) {
    auto* box = placing->findChild<QDoubleSpinBox*>(name);
    QTest::mouseClick(box, Qt::LeftButton);
    box->selectAll();
    QTest::keyClicks(box, text);
    QTest::keyClick(box, Qt::Key_Return);
  };
  EXPECT_DOUBLE_EQ(placing->findChild<QDoubleSpinBox*>("sizeY")->value(), 30.0);
  enterSize("sizeX", "50");
  ASSERT_TRUE(settled());
  EXPECT_EQ(document().choices().item().scale, "2.5");
  EXPECT_NEAR(placing->findChild<QDoubleSpinBox*>("sizeY")->value(), 75.0, 0.01);
  EXPECT_EQ(labels()[1], "Y 75.0 mm");
  auto* unit = placing->findChild<QComboBox*>("sizeUnit");
  unit->setFocus();
  QTest::keyClick(unit, Qt::Key_Down);
  EXPECT_NEAR(placing->findChild<QDoubleSpinBox*>("sizeX")->value(), 50.0 / 25.4, 0.001);
  enterSize("sizeZ", "1");
  ASSERT_TRUE(settled());
  EXPECT_EQ(labels()[2], "Z 25.4 mm");
  keepPicture(window(), "prepare_size");
  document().undoStack()->undo();
  EXPECT_EQ(document().choices().item().scale, "2.5");
}

TEST_F(PrepareViewTest, PartsAreCopiedPastedSelectedAndRemoved) {
  openFlat();
  window().viewport().setFocus();
  QTest::keySequence(&window(), QKeySequence::Copy);
  QTest::keySequence(&window(), QKeySequence::Paste);
  ASSERT_TRUE(settled());
  ASSERT_EQ(document().partCount(), 2u);
  EXPECT_EQ(document().jobChoices().item(1).mode, "flat");
  EXPECT_NE(placement().centreMm.x(), 0.0);
  QTest::keySequence(&window(), QKeySequence::SelectAll);
  EXPECT_EQ(find<panels::PartList>("partList")->selection().size(), 2u);
  QTest::keySequence(&window(), QKeySequence::Copy);
  QTest::keyClick(&window(), Qt::Key_Delete);
  EXPECT_EQ(document().partCount(), 0u);
  QTest::keySequence(&window(), QKeySequence::Paste);
  ASSERT_TRUE(settled());
  EXPECT_EQ(document().partCount(), 2u);
  while (document().undoStack()->canUndo())
    document().undoStack()->undo();
  while (document().undoStack()->canRedo())
    document().undoStack()->redo();
  ASSERT_TRUE(settled());
  EXPECT_EQ(document().partCount(), 2u);
}

TEST_F(PrepareViewTest, CopiesAreCountedOrFillThePlate) {
  openFlat();
  const auto copies = [&](const char* button, const char* count) {
    QTest::mouseClick(tool("copiesOfPart"), Qt::LeftButton);
    auto* dialog = find<QDialog>("copiesDialog");
    auto* box = dialog->findChild<QSpinBox*>("copiesCount");
    if (*count) {
      box->selectAll();
      QTest::keyClicks(box, count);
    }
    const std::uint64_t before = document().revision();
    QTest::mouseClick(dialog->findChild<QPushButton*>(button), Qt::LeftButton);
    return waitFor([&] { return document().revision() != before; }) && settled();
  };
  ASSERT_TRUE(copies("copiesOk", "6"));
  EXPECT_EQ(document().partCount(), 6u);
  keepPicture(window(), "prepare_six");
  ASSERT_TRUE(copies("copiesOk", "2"));
  EXPECT_EQ(document().partCount(), 2u);
  document().undoStack()->undo();
  EXPECT_EQ(document().partCount(), 6u);
  ASSERT_TRUE(copies("copiesFill", ""));
  EXPECT_GT(document().partCount(), 6u);
  keepPicture(window(), "prepare_filled");
  for (const project::ItemChoices& item : document().jobChoices().items)
    EXPECT_LT(item.placement.centreMm.cwiseAbs().maxCoeff(), 100.0);
  document().undoStack()->undo();
  EXPECT_EQ(document().partCount(), 6u);
}

// A plate that is made for the part, as large as its parts need.
TEST_F(PrepareViewTest, APlateMadeForThePartHasNoSizeAndCannotBeFilled) {
  openFlat();
  project::Choices choices = document().choices();
  choices.item().platform = project::Platform("fit");
  document().setChoices(choices, "platform");
  ASSERT_TRUE(settled());
  ASSERT_TRUE(waitFor([&] { return labels().size() == 3; }, 5000));
  answerBox("messageBox", QMessageBox::AcceptRole);
  QTest::mouseClick(tool("copiesOfPart"), Qt::LeftButton);
  QTest::mouseClick(find<QDialog>("copiesDialog")->findChild<QPushButton*>("copiesFill"),
                    Qt::LeftButton);
  EXPECT_TRUE(waitFor([&] { return answeredBoxes() == 1; }, 10000));
  EXPECT_EQ(document().partCount(), 1u);
}

} // namespace
} // namespace voluta::test
