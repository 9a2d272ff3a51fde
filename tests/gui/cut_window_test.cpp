// Cutting, splitting and renaming parts in the window.
#include "geometry/measures.h"
#include "gui/part_view_fixture.h"
#include "helpers/shapes.h"
#include "panels/cut_panel.h"
#include "panels/object_tree.h"
#include "planar/plane_cut.h"
#include "viewer/camera_control.h"
#include "window/view_tools.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>

namespace voluta::test {
namespace {

using project::Stage;

class CutWindowTest : public PartViewTest {
protected:
  QWidget* panel() { return find<QWidget>("cutPanel"); }
  QString state() { return find<QLabel>("cutState")->text(); }
  QPushButton* apply() { return find<QPushButton>("cutApply"); }
  void clickTool(const char* id) {
    QTest::mouseClick(find<window::ViewTools>("viewTools")->button(find<QAction>(id)),
                      Qt::LeftButton);
  }
  bool ready() {
    return waitFor([&] { return apply()->isEnabled(); }, 20000);
  }
  void openTool() {
    clickTool("toolCut");
    EXPECT_TRUE(panel()->isVisible());
    EXPECT_TRUE(ready()) << state().toStdString();
  }
  void type(const char* name, const char* value) {
    auto* box = find<QDoubleSpinBox>(name);
    box->setFocus();
    box->selectAll();
    QTest::keyClicks(box, value);
    QTest::keyClick(box, Qt::Key_Return);
  }
  void choose(const char* name, int index) {
    auto* combo = find<QComboBox>(name);
    combo->setCurrentIndex(index);
    emit combo->activated(index);
  }
  void cut() {
    const std::uint64_t before = document().revision();
    QTest::mouseClick(apply(), Qt::LeftButton);
    EXPECT_TRUE(waitFor([&] { return document().revision() != before; }, 20000))
        << state().toStdString();
    EXPECT_TRUE(settled());
  }
  double volumeOf(std::size_t item) { return geometry::volume(*document().sources()[item]->mesh); }
  // Of the placed item.
  Eigen::AlignedBox3d boxOf(std::size_t item) {
    return geometry::bounds(*document().result(Stage::Load)->job.item(item).part);
  }
  std::string nameOf(std::size_t item) { return document().sources()[item]->name; }
};

TEST_F(CutWindowTest, ABlockBecomesTwoPartsInOneStep) {
  openFlat(writePart("block.stl", box({-15, -10, 0}, {15, 10, 40})));
  EXPECT_FALSE(panel()->isVisible());
  openTool();
  EXPECT_EQ(viewport().tool(), viewer::Tool::CutPlane);
  EXPECT_FALSE(find<QWidget>("prepareTabs")->isVisible());
  EXPECT_TRUE(state().contains("12.0")) << state().toStdString();
  const QImage middle = picture();
  keepPicture(window(), "cut_tool");
  type("cutPosition", "10");
  ASSERT_TRUE(ready());
  EXPECT_TRUE(state().contains("6.00")) << state().toStdString();
  EXPECT_GT(differingShare(middle, picture()), 0.001) << "the halves have changed";
  cut();
  ASSERT_EQ(document().partCount(), 2u);
  EXPECT_EQ(viewport().tool(), viewer::Tool::None);
  EXPECT_FALSE(panel()->isVisible());
  EXPECT_TRUE(find<QWidget>("prepareTabs")->isVisible());
  EXPECT_NEAR(volumeOf(0), 30 * 20 * 10, 1e-6);
  EXPECT_NEAR(volumeOf(1), 30 * 20 * 30, 1e-6);
  EXPECT_EQ(nameOf(0), "block A.stl");
  EXPECT_EQ(nameOf(1), "block B.stl");
  for (const std::size_t item : {0u, 1u})
    EXPECT_NEAR(boxOf(item).min().z(), 0.0, 1e-9) << "stands on the plate";
  EXPECT_TRUE(boxOf(0).intersection(boxOf(1)).isEmpty());
  EXPECT_EQ(document().active(), 0u);
  keepPicture(window(), "cut_done");
  document().undoStack()->undo();
  EXPECT_EQ(document().partCount(), 1u);
  EXPECT_EQ(nameOf(0), "block.stl");
  document().undoStack()->redo();
  ASSERT_EQ(document().partCount(), 2u);
  // The half is cut again.
  ASSERT_TRUE(settled());
  openTool();
  choose("cutAxis", 0);
  ASSERT_TRUE(ready());
  cut();
  ASSERT_EQ(document().partCount(), 3u);
  EXPECT_EQ(nameOf(0), "block AA.stl");
  EXPECT_EQ(nameOf(1), "block AB.stl");
  EXPECT_NEAR(volumeOf(0) + volumeOf(1) + volumeOf(2), 24000.0, 1e-6);
}

TEST_F(CutWindowTest, HandlesAndNumbersMoveThePlane) {
  openFlat(writePart("block.stl", box({-15, -10, 0}, {15, 10, 40})));
  openTool();
  viewport().viewFrom(Eigen::Vector3d(0.3, -1, 0.3).normalized());
  picture();
  // The arrow along the normal.
  const viewer::CameraControl camera(viewport().scene().renderer());
  const auto at = [&](const Eigen::Vector3d& place) {
    const Eigen::Vector3d display = camera.project(place);
    return viewport().fromDisplay({display.x(), display.y()}).toPoint();
  };
  const Eigen::Vector3d middle(0, 0, 20);
  const Eigen::Vector3d tip =
      middle + 60.0 * viewport().mmPerPoint(middle) * Eigen::Vector3d::UnitZ();
  const QPoint from = at(tip), to = at(tip + Eigen::Vector3d(0, 0, 8));
  QTest::mouseMove(&viewport(), from);
  QTest::mousePress(&viewport(), Qt::LeftButton, {}, from);
  QTest::mouseMove(&viewport(), (from + to) / 2);
  QTest::mouseMove(&viewport(), to);
  QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, to);
  auto* position = find<QDoubleSpinBox>("cutPosition");
  EXPECT_NEAR(position->value(), 28.0, 1.0);
  ASSERT_TRUE(ready());
  EXPECT_NEAR(document().choices().item().placement.liftMm, 0.0, 1e-12) << "the part has not moved";
  type("cutTilt1", "30");
  ASSERT_TRUE(ready());
  keepPicture(window(), "cut_tilted");
  EXPECT_NEAR(find<QDoubleSpinBox>("cutTilt1")->value(), 30.0, 1e-6);
  // A number typed halfway is no number yet; leaving the field takes it.
  position->setFocus();
  position->selectAll();
  QTest::keyClicks(position, "1");
  QTest::keyClick(position, Qt::Key_Tab);
  EXPECT_NEAR(position->value(), 1.0, 1e-9);
  // Parallel to a clicked face.
  QTest::mouseClick(find<QPushButton>("cutFace"), Qt::LeftButton);
  EXPECT_EQ(viewport().tool(), viewer::Tool::PickPoint);
  QTest::mouseClick(&viewport(), Qt::LeftButton, {}, at({2, -10, 36}));
  EXPECT_EQ(viewport().tool(), viewer::Tool::CutPlane);
  EXPECT_EQ(find<QComboBox>("cutAxis")->currentIndex(), 1);
  EXPECT_NEAR(find<QDoubleSpinBox>("cutTilt1")->value(), 0.0, 1e-6);
  // Escape while a face is picked returns to the plane, Escape again closes.
  QTest::mouseClick(find<QPushButton>("cutFace"), Qt::LeftButton);
  viewport().setFocus();
  QTest::keyClick(&viewport(), Qt::Key_Escape);
  EXPECT_TRUE(waitFor([&] { return viewport().tool() == viewer::Tool::CutPlane; }, 2000));
  QTest::keyClick(&viewport(), Qt::Key_Escape);
  EXPECT_FALSE(panel()->isVisible());
  EXPECT_EQ(document().partCount(), 1u);
}

TEST_F(CutWindowTest, DowelsBecomePartsAndSurviveSaving) {
  openFlat(writePart("beam.stl", box({-40, -15, 0}, {40, 15, 30})));
  openTool();
  choose("cutAxis", 0);
  choose("cutJoint", 1);
  ASSERT_TRUE(ready()) << state().toStdString();
  find<QCheckBox>("cutApart")->click();
  find<QCheckBox>("cutLayFlat")->click();
  ASSERT_TRUE(ready());
  picture();
  keepPicture(window(), "cut_dowels");
  type("cutSize", "40");
  EXPECT_TRUE(waitFor([&] { return state().startsWith("No room"); }, 20000))
      << state().toStdString();
  EXPECT_FALSE(apply()->isEnabled());
  keepPicture(window(), "cut_no_room");
  type("cutSize", "6");
  ASSERT_TRUE(ready());
  cut();
  ASSERT_EQ(document().partCount(), 4u);
  EXPECT_EQ(nameOf(2), "beam dowel.stl");
  EXPECT_NEAR(boxOf(0).max().z(), 40.0, 1e-6) << "laid on its cut face";
  EXPECT_NEAR(boxOf(2).max().z(), 16.0, 1e-6) << "upright";
  const double lower = volumeOf(0);
  EXPECT_LT(lower, 36000.0);
  keepPicture(window(), "cut_dowels_done");
  const QString file = path("cut.voluta");
  answerFileDialog(file);
  clickMenu("fileMenu", "saveAs");
  ASSERT_TRUE(waitFor([&] { return document().projectFile() == file; }, 20000));
  window().open(file);
  ASSERT_TRUE(waitFor([&] { return !document().dirty() && document().partCount() == 4; }, 20000));
  EXPECT_NEAR(volumeOf(0), lower, 1e-9);
  EXPECT_EQ(nameOf(1), "beam B.stl");
}

TEST_F(CutWindowTest, ThePlaneFollowsAnotherPartAndTheToolEndsWithThePage) {
  openFlat(writePart("block.stl", box({-15, -10, 0}, {15, 10, 40})));
  document().duplicatePart();
  ASSERT_TRUE(settled());
  openTool();
  document().setScale("0.5"); // the active one, the copy
  ASSERT_TRUE(settled());
  ASSERT_TRUE(ready());
  EXPECT_TRUE(state().contains("1.50")) << state().toStdString();
  document().setActive(0);
  ASSERT_TRUE(settled());
  EXPECT_TRUE(waitFor([&] { return state().contains("12.0"); }, 20000)) << state().toStdString();
  document().undoStack()->undo();
  ASSERT_TRUE(settled());
  ASSERT_TRUE(ready());
  document().removePart();
  ASSERT_TRUE(settled());
  ASSERT_TRUE(ready());
  document().removePart();
  EXPECT_FALSE(panel()->isVisible());
  document().undoStack()->undo();
  ASSERT_TRUE(settled());
  openTool();
  choosePage(Page::Layers);
  EXPECT_EQ(viewport().tool(), viewer::Tool::None);
  choosePage(Page::Prepare);
  EXPECT_FALSE(panel()->isVisible());
  EXPECT_TRUE(find<QWidget>("prepareTabs")->isVisible());
  openTool(); // the window closes with the tool open
}

TEST_F(CutWindowTest, APlannedPartIsCutPlannedAndUndone) {
  openFlat(writePart("tile.stl", box({-12, -8, 0}, {12, 8, 8})));
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Replay));
  choosePage(Page::Prepare);
  openTool();
  find<QComboBox>("cutKeep")->setFocus();
  choose("cutAxis", 0);
  ASSERT_TRUE(ready());
  cut();
  EXPECT_FALSE(document().upToDate(Stage::Replay));
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Replay));
  EXPECT_EQ(document().lastResult()->job.items.size(), 2u);
  document().undoStack()->undo();
  EXPECT_TRUE(document().upToDate(Stage::Replay)) << "the plan of the whole part is back";
  choosePage(Page::Prepare);
  ASSERT_TRUE(settled());
  // Only one half is kept.
  openTool();
  choose("cutKeep", 2);
  ASSERT_TRUE(ready());
  keepPicture(window(), "cut_keep_upper");
  cut();
  ASSERT_EQ(document().partCount(), 1u);
  EXPECT_EQ(nameOf(0), "tile B.stl");
  openTool();
  auto* position = find<QDoubleSpinBox>("cutPosition");
  position->setFocus();
  position->selectAll();
  QTest::keyClicks(position, "-"); // and the window closes
}

TEST_F(CutWindowTest, AMeshOfSeveralBodiesIsSplit) {
  geometry::TriangleMesh bodies = box({0, 0, 0}, {20, 20, 10});
  append(bodies, box({40, 0, 0}, {50, 10, 25}));
  append(bodies, box({2, 2, 30}, {8, 8, 36})); // above the first one
  openFlat(writePart("three.stl", bodies));
  const Eigen::AlignedBox3d whole = boxOf(0);
  clickTool("splitPart");
  ASSERT_TRUE(waitFor([&] { return document().partCount() == 3; }, 20000));
  ASSERT_TRUE(settled());
  EXPECT_NEAR(volumeOf(0), 4000.0, 1e-6);
  EXPECT_NEAR(volumeOf(1), 2500.0, 1e-6);
  EXPECT_NEAR(volumeOf(2), 216.0, 1e-6);
  EXPECT_EQ(nameOf(1), "three 2.stl");
  EXPECT_NEAR(boxOf(0).min().x(), whole.min().x(), 1e-6) << "keeps its place";
  EXPECT_NEAR(boxOf(1).max().x(), whole.max().x(), 1e-6);
  EXPECT_TRUE(boxOf(2).intersection(boxOf(0)).isEmpty()) << "beside, not in, the first";
  keepPicture(window(), "split");
  document().undoStack()->undo();
  EXPECT_EQ(document().partCount(), 1u);
}

TEST_F(CutWindowTest, APartIsRenamedInTheTree) {
  openFlat(writePart("block.stl", box({-15, -10, 0}, {15, 10, 40})));
  auto* tree = find<panels::ObjectTree>("tree");
  const auto rename = [&](const char* name, int end) {
    QTest::keyClick(&window(), Qt::Key_F2);
    QLineEdit* line = nullptr;
    EXPECT_TRUE(waitFor([&] { return (line = tree->findChild<QLineEdit*>()) != nullptr; }, 2000));
    if (!line)
      return;
    line->selectAll();
    QTest::keyClicks(line, name);
    EXPECT_FALSE(line->text().contains(".stl"));
    QTest::keyClick(line, static_cast<Qt::Key>(end));
    EXPECT_TRUE(waitFor([&] { return !tree->findChild<QLineEdit*>(); }, 2000));
    QApplication::processEvents();
  };
  rename("left foot", Qt::Key_Return);
  EXPECT_EQ(nameOf(0), "left foot.stl");
  EXPECT_TRUE(tree->topLevelItem(0)->text(0).contains("left foot"))
      << tree->topLevelItem(0)->text(0).toStdString();
  EXPECT_TRUE(window().windowTitle().startsWith("left foot"));
  rename("nothing", Qt::Key_Escape);
  EXPECT_EQ(nameOf(0), "left foot.stl");
  rename(" ", Qt::Key_Return);
  EXPECT_EQ(nameOf(0), "left foot.stl");
  EXPECT_TRUE(tree->topLevelItem(0)->text(0).contains("left foot"));
  rename("a/b v1.2", Qt::Key_Return);
  EXPECT_EQ(nameOf(0), "a-b v1.2.stl");
  document().undoStack()->undo();
  document().undoStack()->undo();
  EXPECT_EQ(nameOf(0), "block.stl");
  EXPECT_TRUE(tree->topLevelItem(0)->text(0).contains("block"));
}

TEST_F(CutWindowTest, TheMenuHasUnitAndRepair) {
  openFlat(writePart("block.stl", box({-1, -1, 0}, {1, 1, 2})));
  auto* tree = find<panels::ObjectTree>("tree");
  emit tree->customContextMenuRequested(tree->visualItemRect(tree->topLevelItem(0)).center());
  QMenu* menu = nullptr;
  ASSERT_TRUE(waitFor(
      [&] { return (menu = qobject_cast<QMenu*>(QApplication::activePopupWidget())) != nullptr; },
      5000));
  QAction *unit = nullptr, *repair = nullptr;
  QStringList texts;
  for (QAction* action : menu->actions()) {
    texts << action->text().remove('&');
    if (action->menu())
      unit = action;
    if (action->text().remove('&') == "Repair the mesh")
      repair = action;
  }
  for (const char* wanted : {"Rename part", "Cut…", "Split to parts"})
    EXPECT_TRUE(texts.contains(QString::fromUtf8(wanted))) << texts.join(", ").toStdString();
  ASSERT_TRUE(unit && repair);
  EXPECT_TRUE(repair->isChecked());
  keepPicture(*menu, "part_menu");
  for (QAction* action : unit->menu()->actions())
    if (action->text().remove('&') == "inch")
      action->trigger();
  menu->close();
  ASSERT_TRUE(settled());
  EXPECT_NEAR(boxOf(0).sizes().x(), 50.8, 1e-6);
  document().undoStack()->undo();
  ASSERT_TRUE(settled());
  EXPECT_NEAR(boxOf(0).sizes().x(), 2.0, 1e-6);
}

} // namespace
} // namespace voluta::test
