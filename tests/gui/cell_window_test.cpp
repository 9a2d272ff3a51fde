// The cell: where its head reaches, and a cell of the user's own, edited and planned in.
#include "base/data_files.h"
#include "base/files.h"
#include "gui/cell_fixture.h"
#include "helpers/shapes.h"
#include "panels/object_tree.h"
#include "panels/reach_panel.h"
#include "pipeline/cell_reach.h"
#include "pipeline/checked_program.h"
#include "pipeline/resolved.h"
#include "pipeline/stage_options.h"
#include "robot/cell_draft.h"
#include "robot/urdf/link_meshes.h"
#include "robot/urdf_arms.h"
#include "viewer/camera_control.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QTabWidget>
#include <QTest>
#include <QTimer>
#include <QWheelEvent>

namespace voluta::test {
namespace {

using project::Stage;

// Of pixels that are of a colour, and neither grey nor the part's pale blue.
double colouredShare(const QImage& picture) {
  int coloured = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x)
      coloured += picture.pixelColor(x, y).hsvSaturation() > 65;
  return static_cast<double>(coloured) / (picture.width() * picture.height());
}

double orangeShare(const QImage& picture) {
  int orange = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const QColor colour = picture.pixelColor(x, y);
      orange += colour.red() > 120 && colour.green() < 0.7 * colour.red() &&
                colour.blue() < 0.4 * colour.red() && colour.green() > 0.35 * colour.red();
    }
  return static_cast<double>(orange) / (picture.width() * picture.height());
}

class CellTest : public CellWindowTest {
protected:
  panels::ReachPanel* reach() { return find<panels::ReachPanel>("reach"); }
  QPushButton* moveButton() { return reach()->findChild<QPushButton*>("reachMove"); }
  bool reachKnown() {
    return waitFor([&] {
      return document().upToDate(Stage::Load) && !window().planning().running() &&
             !window().presenter().busy() && !reach()->isLooking();
    });
  }
  // The position of a place of the fixed frame in the viewport.
  QPoint onScreen(const Eigen::Vector3d& place) {
    const viewer::CameraControl camera(window().viewport().scene().renderer());
    const Eigen::Vector3d display = camera.project(place);
    return window().viewport().fromDisplay({display.x(), display.y()}).toPoint();
  }
  bool isSeen(const Eigen::Vector3d& place) {
    return window().viewport().rect().contains(onScreen(place));
  }
  Eigen::Vector3d nozzleAtHome() {
    const project::Choices& choices = document().choices();
    const robot::Cell cell = pipeline::cellToMap(choices, pipeline::resolve(choices).process());
    return cell.work_T_tool(cell.home()).translation();
  }
  QString reachText() { return reach()->findChild<QLabel*>("reachState")->text(); }
  void click(QAbstractButton* button) {
    for (QWidget* up = button; up; up = up->parentWidget())
      if (auto* area = qobject_cast<QScrollArea*>(up))
        area->ensureWidgetVisible(button);
    QTest::mouseClick(button, Qt::LeftButton, {}, QPoint(10, button->height() / 2));
  }
};

TEST_F(CellTest, PartBeyondThePlateIsAmberAndOneClickMovesItBack) {
  openPart(writePart("block.stl", box({0, 0, 0}, {40.0, 40.0, 40.0})));
  find<QTabWidget>("prepareTabs")->setCurrentIndex(1);
  ASSERT_TRUE(reachKnown());
  EXPECT_TRUE(reachText().startsWith("Fully reachable upright")) << reachText().toStdString();
  EXPECT_FALSE(window().viewport().view().partBeyond);
  EXPECT_FALSE(window().viewport().view().reach);
  const QImage before = picture();
  click(reach()->findChild<QCheckBox*>("reachMap"));
  EXPECT_TRUE(window().viewport().view().reach);
  EXPECT_GT(colouredShare(picture()), colouredShare(before) + 0.02);

  geometry::Placement shifted;
  shifted.centreMm = {400.0, 0.0};
  document().place(shifted, "move");
  ASSERT_TRUE(reachKnown());
  EXPECT_TRUE(window().viewport().view().partBeyond);
  EXPECT_TRUE(reachText().startsWith("The part is off")) << reachText().toStdString();
  ASSERT_TRUE(moveButton()->isEnabled());
  click(moveButton());
  ASSERT_TRUE(reachKnown());
  EXPECT_FALSE(window().viewport().view().partBeyond);
  EXPECT_LT(document().choices().item().placement.centreMm.norm(), 125.0);
  QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(reachKnown());
  EXPECT_TRUE(window().viewport().view().partBeyond);
}

// On another maker's arm, too: one click, from where no better place is left.
TEST_F(CellTest, OneClickMovesThePartToTheBestPlaceOfAnotherArm) {
  openPart(writePart("block.stl", box({0, 0, 0}, {40.0, 40.0, 40.0})));
  project::Choices choices = document().choices();
  choices.cell = "kr6-r900-moving";
  document().setChoices(choices, "cell");
  find<QTabWidget>("prepareTabs")->setCurrentIndex(1);
  ASSERT_TRUE(reachKnown());
  geometry::Placement shifted;
  shifted.centreMm = {900.0, 300.0};
  document().place(shifted, "move");
  ASSERT_TRUE(reachKnown());
  EXPECT_TRUE(reachText().startsWith("The part is off")) << reachText().toStdString();
  click(moveButton());
  ASSERT_TRUE(reachKnown());
  EXPECT_TRUE(reachText().startsWith("Fully reachable upright")) << reachText().toStdString();
  EXPECT_FALSE(moveButton()->isEnabled()) << "it is there";
  EXPECT_LT(document().choices().item().placement.centreMm.norm(), 200.0);
  EXPECT_FALSE(window().viewport().view().partBeyond);
  keepPicture(window(), "best_place");
  QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(reachKnown());
  EXPECT_EQ(document().choices().item().placement.centreMm, shifted.centreMm);
}

// A post beside the plate, of the user's own: saved, taken, and a body of the planned job.
TEST_F(CellTest, AnOwnCellWithAnObstacleIsPlannedIn) {
  openPart(writePart("block.stl", box({0, 0, 0}, {16.0, 16.0, 4.0})));
  ASSERT_TRUE(reachKnown());
  inEditor([&](window::CellEditor& editor) {
    EXPECT_TRUE(faults(editor).startsWith("No problems")) << faults(editor).toStdString();
    QTest::mouseClick(editor.findChild<QPushButton*>("cellAddBox"), Qt::LeftButton);
    ASSERT_TRUE(settled(editor));
    choose(editor, "box");
    type(editor, "edgeX", 30.0);
    type(editor, "placeX", 480.0);
    type(editor, "placeY", 260.0);
    ASSERT_TRUE(settled(editor));
    // Undone and done again by the keys.
    QTest::keyClick(&editor, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_NE(editor.draft().bodies().back().pose.translation().y(), 260.0);
    QTest::keyClick(&editor, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    EXPECT_EQ(editor.draft().bodies().back().pose.translation().y(), 260.0);
    EXPECT_EQ(editor.draft().bodies().back().sizeMm->x(), 30.0);
    auto* name = editor.findChild<QLineEdit*>("cellName");
    name->selectAll();
    QTest::keyClicks(name, "my cell");
    ASSERT_TRUE(settled(editor));
    EXPECT_FALSE(editor.findChild<QPushButton*>("cellSave")->isEnabled()) << "a blank in the name";
    name->selectAll();
    QTest::keyClicks(name, "my-cell");
    ASSERT_TRUE(editor.findChild<QPushButton*>("cellSave")->isEnabled());
    QTest::mouseClick(editor.findChild<QPushButton*>("cellSave"), Qt::LeftButton);
  });
  EXPECT_EQ(document().choices().cell, "my-cell");
  EXPECT_GE(find<QComboBox>("cell")->findData("my-cell"), 0);
  EXPECT_TRUE(std::filesystem::exists(base::userDataFolder() / "cells" / "my-cell.json"));
  ASSERT_TRUE(reachKnown());
  clickMenu("runMenu", "plan");
  ASSERT_TRUE(planned(Stage::Replay));
  const auto result = document().result(Stage::Motion);
  ASSERT_TRUE(result->cell);
  EXPECT_EQ(result->cell->id(), "my-cell");
  EXPECT_TRUE(std::ranges::any_of(result->cell->bodies(),
                                  [](const robot::Body& body) { return body.name == "box"; }));
  EXPECT_EQ(result->job.report.motion.collisions, 0u);
}

TEST_F(CellTest, FaultsOfACellAreShownAtOnce) {
  inEditor([&](window::CellEditor& editor) {
    choose(editor, "Nozzle");
    type(editor, "placeX", 0.0);
    type(editor, "placeZ", 20.0);
    ASSERT_TRUE(settled(editor));
    EXPECT_TRUE(faults(editor).contains("the nozzle is inside")) << faults(editor).toStdString();
    QTest::keyClick(&editor, Qt::Key_Z, Qt::ControlModifier);
    QTest::keyClick(&editor, Qt::Key_Z, Qt::ControlModifier);
    ASSERT_TRUE(settled(editor));
    EXPECT_TRUE(faults(editor).startsWith("No problems")) << faults(editor).toStdString();
    type(editor, "cellCarried", 7.0);
    ASSERT_TRUE(settled(editor));
    EXPECT_TRUE(faults(editor).contains("7 kg")) << faults(editor).toStdString();
    EXPECT_TRUE(editor.findChild<QPushButton*>("cellSave")->isEnabled()) << "told, not forbidden";
    editor.done(QDialog::Rejected);
  });
  EXPECT_EQ(document().choices().cell, "ur5-fixed");
}

TEST_F(CellTest, AnArmFromAUrdfIsImportedAndItsCellTaken) {
  openPart(writePart("block.stl", box({0, 0, 0}, {20.0, 20.0, 6.0})));
  QFile urdf(path("arm.urdf"));
  ASSERT_TRUE(urdf.open(QIODevice::WriteOnly));
  urdf.write(QByteArray::fromStdString(urdfOf(irb1200())));
  urdf.close();
  answerFileDialog(path("arm.urdf"));
  bool imported = false;
  auto* timer = new QTimer(&window());
  QObject::connect(timer, &QTimer::timeout, timer, [&] {
    for (QWidget* widget : QApplication::topLevelWidgets()) {
      auto* button = widget->objectName() == "armImportDialog" && widget->isVisible()
                         ? widget->findChild<QPushButton*>("armImport")
                         : nullptr;
      if (!button || !button->isEnabled() || imported)
        continue;
      imported = true;
      EXPECT_FALSE(widget->findChild<QPlainTextEdit*>("armFound")->toPlainText().isEmpty());
      widget->findChild<QLineEdit*>("armName")->setText("mine");
      QTest::mouseClick(button, Qt::LeftButton);
    }
  });
  timer->start(50);
  clickMenu("fileMenu", "importArm");
  ASSERT_TRUE(waitFor([&] { return document().choices().cell == "mine-moving"; }, 30000));
  EXPECT_TRUE(imported);
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Replay));
  EXPECT_TRUE(document().result(Stage::Replay)->job.report.replay.passed);
}

// The cell of an earlier import may have been measured since.
TEST_F(CellTest, ASecondImportOfAnArmKeepsTheFirstUnlessItMayBeReplaced) {
  QFile urdf(path("arm.urdf"));
  ASSERT_TRUE(urdf.open(QIODevice::WriteOnly));
  urdf.write(QByteArray::fromStdString(urdfOf(irb1200())));
  urdf.close();
  ASSERT_TRUE(QDir(path({})).mkpath("cells"));
  const QString cell = path("cells/mine-moving.json");
  QFile measured(cell);
  ASSERT_TRUE(measured.open(QIODevice::WriteOnly));
  measured.write("measured");
  measured.close();
  answerFileDialog(path("arm.urdf"));
  answerBox("replaceArmBox", QMessageBox::RejectRole);
  int imports = 0;
  QString proposed;
  auto* timer = new QTimer(&window());
  QObject::connect(timer, &QTimer::timeout, timer, [&] {
    for (QWidget* widget : QApplication::topLevelWidgets()) {
      auto* button = widget->objectName() == "armImportDialog" && widget->isVisible()
                         ? widget->findChild<QPushButton*>("armImport")
                         : nullptr;
      if (!button || !button->isEnabled() || QApplication::activeModalWidget() != widget)
        continue;
      auto* name = widget->findChild<QLineEdit*>("armName");
      if (imports == 0)
        name->setText("mine");
      else
        proposed = name->text();
      ++imports;
      QTest::mouseClick(button, Qt::LeftButton);
    }
  });
  timer->start(50);
  clickMenu("fileMenu", "importArm");
  ASSERT_TRUE(waitFor([&] { return document().choices().cell == "mine-2-moving"; }, 30000));
  EXPECT_EQ(imports, 2);
  EXPECT_EQ(proposed, "mine-2");
  EXPECT_EQ(answeredBoxes(), 1);
  ASSERT_TRUE(measured.open(QIODevice::ReadOnly));
  EXPECT_EQ(measured.readAll(), "measured");
}

// The machine is drawn about the part before anything is planned: that of the chosen cell, and its
// eye button hides it.
TEST_F(CellTest, TheMachineIsDrawnOnPrepare) {
  openPart(writePart("block.stl", box({0, 0, 0}, {16.0, 16.0, 4.0})));
  ASSERT_TRUE(reachKnown());
  find<QAction>("showArm")->trigger();
  const QImage ur5 = picture();
  keepPicture(window(), "prepare-ur5");
  auto* cells = find<QComboBox>("cell");
  cells->setCurrentIndex(cells->findData("kr6-r900-moving"));
  emit cells->activated(cells->currentIndex());
  ASSERT_TRUE(reachKnown());
  const QImage kr6 = picture();
  keepPicture(window(), "prepare-kr6");
  EXPECT_GT(differingShare(ur5, kr6), 0.1);
  EXPECT_GT(orangeShare(kr6), orangeShare(ur5) + 0.05) << "KUKA's orange";
  EXPECT_TRUE(isSeen({0.0, 0.0, 0.0}));
  EXPECT_TRUE(isSeen(nozzleAtHome()));

  auto* tree = find<panels::ObjectTree>("tree");
  tree->setFocus();
  tree->select(panels::SceneItem::Cell);
  QTest::keyClick(tree, Qt::Key_Space);
  EXPECT_LT(orangeShare(picture()), 0.001);
  QTest::keyClick(tree, Qt::Key_Space);
  EXPECT_LT(differingShare(kr6, picture()), 0.001);
}

// Beside the machine the part is large enough to be worked on, and layers have the picture to
// themselves, unless the user has put the camera where it is.
TEST_F(CellTest, ThePartIsLargeBesideTheMachineAndLargerWithoutIt) {
  openPart(writePart("cube.stl", box({0, 0, 0}, {100.0, 100.0, 100.0})));
  ASSERT_TRUE(reachKnown());
  find<QAction>("showArm")->trigger();
  picture();
  keepPicture(window(), "prepare-cube");
  // From its nearest corner to the farthest one.
  const auto heightOfPart = [&] {
    return onScreen({50, -50, 0}).y() - onScreen({-50, 50, 100}).y();
  };
  const int besideMachine = heightOfPart(), height = window().viewport().height();
  EXPECT_TRUE(isSeen(nozzleAtHome()));
  EXPECT_GT(besideMachine, height / 8);
  choosePage(Page::Layers);
  picture();
  EXPECT_GT(heightOfPart(), 2 * besideMachine);
  viewer::Viewport& viewport = window().viewport();
  QTest::keyClick(&viewport, Qt::Key_Left); // turned, the camera still frames all
  choosePage(Page::Prepare);
  QTest::keyClick(&viewport, Qt::Key_Right);
  picture();
  EXPECT_NEAR(heightOfPart(), besideMachine, 0.1 * besideMachine);

  QWheelEvent wheel(viewport.rect().center(), viewport.mapToGlobal(viewport.rect().center()), {},
                    {0, 240}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
  QApplication::sendEvent(&viewport, &wheel);
  const int nearer = heightOfPart();
  EXPECT_GT(nearer, besideMachine);
  choosePage(Page::Layers);
  EXPECT_NEAR(heightOfPart(), nearer, 0.1 * nearer);
}

// While an edit places the part anew the machine keeps its place, its plate included.
TEST_F(CellTest, ThePlateStaysWhileThePartIsPlacedAnew) {
  openPart(writePart("block.stl", box({0, 0, 0}, {16.0, 16.0, 4.0})));
  choosePage(Page::Prepare);
  ASSERT_TRUE(reachKnown());
  const QImage before = picture();
  document().setScale("1.1");
  window().planning().cancel();
  ASSERT_FALSE(document().upToDate(Stage::Load));
  ASSERT_TRUE(waitFor([&] { return !window().presenter().busy(); }));
  EXPECT_LT(differingShare(before, picture()), 0.001);
  keepPicture(window(), "prepare-placed-anew");
}

// An arm with meshes of its own: a box in place of its forearm, which its solids are far from.
class DrawnArmTest : public CellTest {
protected:
  void SetUp() override {
    qputenv("VOLUTA_DATA", folder_.path().toUtf8());
    const std::filesystem::path own = base::userDataFolder();
    const auto copied = [&](const char* folder, const char* from, const char* to) {
      std::string text =
          base::readFile(base::resourceFolder() / folder / (std::string(from) + ".json"));
      for (const char* key : {"\"id\": \"", "\"robot\": \""})
        if (const std::size_t at = text.find(key + std::string(from) + "\"");
            at != std::string::npos)
          text.replace(at + std::string(key).size(), std::string(from).size(), to);
      return text;
    };
    std::filesystem::create_directories(own / "robots");
    std::filesystem::create_directories(own / "cells");
    base::writeFile(own / "robots" / "my-ur5.json", copied("robots", "ur5", "my-ur5"));
    robot::writeLinkMeshes(own / "robots" / "my-ur5.json",
                           {{3, box({-300.0, -150.0, -150.0}, {0.0, 150.0, 150.0})}});
    std::string cell = copied("cells", "ur5-fixed", "my-cell");
    const std::string robot = "\"robot\": \"ur5\"";
    cell.replace(cell.find(robot), robot.size(), "\"robot\": \"my-ur5\"");
    base::writeFile(own / "cells" / "my-cell.json", cell);
    CellTest::SetUp();
  }
};

TEST_F(DrawnArmTest, IsSeenAsTheSolidsThatAreCheckedWhileItPrints) {
  openPart(writePart("block.stl", box({0, 0, 0}, {16.0, 16.0, 4.0})));
  auto* cells = find<QComboBox>("cell");
  cells->setCurrentIndex(cells->findData("my-cell"));
  emit cells->activated(cells->currentIndex());
  ASSERT_TRUE(waitFor([&] { return document().choices().cell == "my-cell"; }));
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Replay));
  choosePage(Page::Simulate);
  auto* solids = find<QCheckBox>("simulateSolids");
  ASSERT_TRUE(solids->isVisible());
  EXPECT_FALSE(solids->isChecked());
  const auto drawn = [&] { return waitFor([&] { return !window().presenter().busy(); }); };
  ASSERT_TRUE(drawn());
  const QImage meshes = picture();
  keepPicture(window(), "simulate-meshes");
  click(solids);
  ASSERT_TRUE(solids->isChecked());
  ASSERT_TRUE(drawn());
  const QImage checked = picture();
  keepPicture(window(), "simulate-solids");
  const double changed = differingShare(meshes, checked);
  EXPECT_GT(changed, 0.02);
  click(solids);
  ASSERT_TRUE(drawn());
  EXPECT_LT(differingShare(meshes, picture()), 0.4 * changed) << "and back";
}

} // namespace
} // namespace voluta::test
