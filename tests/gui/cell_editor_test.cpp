// The cell editor: obstacles from files, frames from measured points and by handles in the picture.
#include "base/data_files.h"
#include "base/files.h"
#include "base/units.h"
#include "cells/arm_import.h"
#include "geometry/formats/mesh_reader.h"
#include "gui/cell_fixture.h"
#include "helpers/shapes.h"
#include "robot/cell.h"
#include "robot/cell_draft.h"
#include "robot/urdf_arms.h"
#include "viewer/viewport.h"

#include <QCheckBox>
#include <QFile>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <algorithm>
#include <cmath>

namespace voluta::test {
namespace {

using Eigen::Vector3d;

class CellEditorTest : public CellWindowTest {
protected:
  static void press(QWidget& in, const char* button) {
    auto* found = in.findChild<QPushButton*>(button);
    ASSERT_NE(found, nullptr) << button;
    ASSERT_TRUE(found->isEnabled()) << button;
    QTest::mouseClick(found, Qt::LeftButton);
  }
  static robot::DraftBody body(window::CellEditor& editor, robot::DraftBody::Kind kind) {
    const auto bodies = editor.draft().bodies();
    return *std::ranges::find(bodies, kind, &robot::DraftBody::kind);
  }
  static void saveAs(window::CellEditor& editor, const char* id) {
    auto* name = editor.findChild<QLineEdit*>("cellName");
    name->selectAll();
    QTest::keyClicks(name, id);
    press(editor, "cellSave");
  }
  // Fills the dialog that comes up, and checks its text.
  void inMeasuring(const std::function<void(QDialog&, QPlainTextEdit&, QLabel&)>& work) {
    QTimer::singleShot(0, &window(), [work] {
      QDialog* dialog = nullptr;
      ASSERT_TRUE(waitFor([&] {
        dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
        return dialog && dialog->objectName() == "measureDialog";
      }));
      work(*dialog, *dialog->findChild<QPlainTextEdit*>("measureRows"),
           *dialog->findChild<QLabel*>("measureTold"));
      if (dialog->isVisible())
        dialog->reject();
    });
  }
  static void paste(QPlainTextEdit& into, const QString& text) {
    into.selectAll();
    into.insertPlainText(text);
  }
};

TEST_F(CellEditorTest, EscConfirmsBeforeItDiscardsEdits) {
  inEditor([&](window::CellEditor& editor) {
    choose(editor, "Nozzle");
    const robot::CellDraft before = editor.draft();
    type(editor, "placeX", 321.0);
    ASSERT_TRUE(settled(editor));
    const robot::CellDraft edited = editor.draft();
    ASSERT_FALSE(edited == before);
    answerBox("discardCellBox", QMessageBox::RejectRole);
    QTest::keyClick(&editor, Qt::Key_Escape);
    EXPECT_EQ(answeredBoxes(), 1);
    EXPECT_TRUE(editor.isVisible());
    EXPECT_TRUE(editor.draft() == edited);
    answerBox("discardCellBox", QMessageBox::DestructiveRole);
    QTest::keyClick(&editor, Qt::Key_Escape);
    EXPECT_EQ(answeredBoxes(), 2);
    EXPECT_FALSE(editor.isVisible());
  });
  EXPECT_EQ(document().choices().cell, "ur5-fixed");
  inEditor([&](window::CellEditor& editor) { // Nothing is lost without edits
    QTest::keyClick(&editor, Qt::Key_Escape);
    EXPECT_FALSE(editor.isVisible());
  });
  EXPECT_EQ(answeredBoxes(), 2);
}

TEST_F(CellEditorTest, AnObstacleFromAFileIsInTheWay) {
  const auto post = box({-30, -30, 0}, {30, 30, 900});
  const QString file = writePart("tool stand.stl", post);
  inEditor([&](window::CellEditor& editor) {
    answerFileDialog(file);
    press(editor, "cellAddFile");
    ASSERT_TRUE(waitFor(
        [&] { return editor.settled() && editor.draft().bodies().back().name == "tool stand"; }));
    // It is drawn at the robot's own foot, which is shown as a fault at once.
    EXPECT_TRUE(faults(editor).contains("tool stand")) << faults(editor).toStdString();
    EXPECT_EQ(editor.findChild<QTreeWidget*>("cellBodies")->currentItem()->text(0), "tool stand");
    type(editor, "placeX", -600.0);
    type(editor, "placeY", 950.0);
    type(editor, "frameTurnZ", 30.0);
    ASSERT_TRUE(settled(editor));
    EXPECT_TRUE(faults(editor).startsWith("No problems")) << faults(editor).toStdString();
    keepPicture(editor, "obstacle_from_file");
    saveAs(editor, "with-stand");
  });
  ASSERT_EQ(document().choices().cell, "with-stand");
  const robot::Cell cell = robot::loadCell("with-stand", process::loadProcess("fdm-1.0"),
                                           {{-40, -40}, {40, -40}, {40, 40}, {-40, 40}});
  const robot::Body& stand = cell.bodies().back();
  ASSERT_EQ(stand.name, "tool stand");
  ASSERT_EQ(stand.shapes.size(), 1u);
  const auto& solid = std::get<robot::Box>(stand.shapes.front());
  EXPECT_LT((solid.frame_T_box.translation() - Vector3d(-600, 950, 450)).norm(), 1e-3);
  EXPECT_NEAR(solid.half.maxCoeff(), 450.0, 1e-3);
  const int index = static_cast<int>(cell.bodies().size()) - 1;
  EXPECT_TRUE(std::ranges::any_of(cell.checkedPairs(), [&](const std::pair<int, int>& pair) {
    return pair.second == index;
  })) << "arm and obstacle are checked against each other";
}

TEST_F(CellEditorTest, FileWithoutAMeshGivesAnErrorAndChangesNothing) {
  QFile file(path("words.stl"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("no mesh at all");
  file.close();
  inEditor([&](window::CellEditor& editor) {
    const std::string before = editor.draft().text();
    answerFileDialog(path("words.stl"));
    press(editor, "cellAddFile");
    ASSERT_TRUE(waitFor([&] { return faults(editor).contains("words.stl:"); }))
        << faults(editor).toStdString();
    EXPECT_EQ(editor.draft().text(), before);
    editor.done(QDialog::Rejected);
  });
}

TEST_F(CellEditorTest, NozzleMovesToTheMeasuredPose) {
  inEditor([&](window::CellEditor& editor) {
    choose(editor, "Nozzle");
    const Eigen::Isometry3d before = body(editor, robot::DraftBody::Kind::Nozzle).pose;
    inMeasuring([&](QDialog& dialog, QPlainTextEdit& rows, QLabel& reported) {
      auto* use = dialog.findChild<QPushButton*>("measureUse");
      EXPECT_FALSE(use->isEnabled());
      paste(rows, "400 100 20\n550 100 20\n700 100 20");
      EXPECT_FALSE(use->isEnabled());
      EXPECT_TRUE(reported.text().contains("line")) << reported.text().toStdString();
      EXPECT_FALSE(reported.text().contains('\n')) << reported.text().toStdString();
      paste(rows, "400 100 20\n550 100 x");
      EXPECT_TRUE(reported.text().contains("'x' is not a number")) << reported.text().toStdString();
      paste(rows, "400 100 20\n400 250 20\n250 100 20");
      EXPECT_TRUE(reported.text().contains("400.000, 100.000, 20.000"))
          << reported.text().toStdString();
      EXPECT_TRUE(reported.text().contains("90.000")) << reported.text().toStdString();
      keepPicture(dialog, "measure_frame");
      press(dialog, "measureUse");
    });
    press(editor, "cellMeasure");
    const Eigen::Isometry3d measured = body(editor, robot::DraftBody::Kind::Nozzle).pose;
    EXPECT_LT((measured.translation() - Vector3d(400, 100, 20)).norm(), 1e-9);
    EXPECT_LT((measured.linear().col(0) - Vector3d::UnitY()).norm(), 1e-9);
    EXPECT_EQ(editor.findChild<QDoubleSpinBox*>("placeX")->value(), 400.0);
    ASSERT_TRUE(settled(editor));
    editor.activateWindow();
    ASSERT_TRUE(waitFor([&] { return editor.isActiveWindow(); }, 5000));
    QTest::keyClick(&editor, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(body(editor, robot::DraftBody::Kind::Nozzle).pose.isApprox(before, 1e-9));
    ASSERT_TRUE(settled(editor));
    editor.done(QDialog::Rejected);
  });
}

// A tip of known place, touched from five sides: the rows are flange poses.
TEST_F(CellEditorTest, ATipIsMeasuredByTouchingOnePoint) {
  project::Choices choices = document().choices();
  choices.cell = "ur5-moving";
  document().setChoices(choices, "cell");
  const Vector3d tip(3, -2, 210), point(400, -200, 50);
  QString rows;
  for (int i = 0; i < 5; ++i) {
    const Vector3d axis(std::cos(1.2 * i), std::sin(1.2 * i), 0.3);
    const Eigen::Quaterniond rotation(Eigen::AngleAxisd(2.6 + 0.1 * i, axis.normalized()));
    const Vector3d flange = point - rotation * tip;
    for (const double value : {flange.x(), flange.y(), flange.z(), rotation.w(), rotation.x(),
                               rotation.y(), rotation.z()})
      rows += QString::number(value, 'f', 9) + QLatin1Char(' ');
    rows += QLatin1Char('\n');
  }
  inEditor([&](window::CellEditor& editor) {
    choose(editor, "Nozzle");
    const Eigen::Matrix3d rotation = body(editor, robot::DraftBody::Kind::Nozzle).pose.linear();
    inMeasuring([&](QDialog& dialog, QPlainTextEdit& into, QLabel& reported) {
      paste(into, rows.section(QLatin1Char('\n'), 0, 2));
      EXPECT_FALSE(dialog.findChild<QPushButton*>("measureUse")->isEnabled()) << "three poses";
      EXPECT_FALSE(reported.text().isEmpty());
      paste(into, rows);
      EXPECT_TRUE(reported.text().contains("3.000, -2.000, 210.000"))
          << reported.text().toStdString();
      EXPECT_TRUE(reported.text().contains("5 rows")) << reported.text().toStdString();
      press(dialog, "measureUse");
    });
    press(editor, "cellMeasure");
    const Eigen::Isometry3d pose = body(editor, robot::DraftBody::Kind::Nozzle).pose;
    EXPECT_LT((pose.translation() - tip).norm(), 1e-6);
    EXPECT_LT((pose.linear() - rotation).norm(), 1e-9);
    ASSERT_TRUE(settled(editor));
    editor.done(QDialog::Rejected);
  });
}

// By the mouse: at the tip of the arrow along x, and along the ring about z.
TEST_F(CellEditorTest, ABodyIsMovedAndTurnedByItsHandles) {
  inEditor([&](window::CellEditor& editor) {
    press(editor, "cellAddBox");
    ASSERT_TRUE(settled(editor));
    auto* port = editor.findChild<viewer::Viewport*>();
    ASSERT_EQ(port->tool(), viewer::Tool::Frame);
    port->viewFrom(Vector3d(-0.5, -0.6, 0.6));
    const auto box = [&] { return editor.draft().bodies().back(); };
    const Eigen::Isometry3d before = box().pose;
    const viewer::CameraControl camera(port->scene().renderer());
    const auto onScreen = [&](const Vector3d& place) {
      const Vector3d display = camera.project(place);
      return port->fromDisplay({display.x(), display.y()});
    };
    const auto drag = [&](const QPointF& from, const QPointF& by) {
      QTest::mouseMove(port, from.toPoint());
      QTest::mousePress(port, Qt::LeftButton, {}, from.toPoint());
      for (int step = 1; step <= 5; ++step)
        QTest::mouseMove(port, (from + by * step / 5).toPoint());
      QTest::mouseRelease(port, Qt::LeftButton, {}, (from + by).toPoint());
    };
    // Along x, which ends 90 pixels from the middle if it is across the view.
    const Vector3d at = before.translation();
    const double reach = 90.0 * camera.mmPerPixel(at) * port->devicePixelRatioF();
    const QPointF tip = onScreen(at + 0.9 * reach * Vector3d::UnitX());
    const QPointF along = onScreen(at + (0.9 * reach + 100.0) * Vector3d::UnitX()) - tip;
    drag(tip, along);
    ASSERT_TRUE(settled(editor));
    const Vector3d moved = box().pose.translation() - at;
    EXPECT_NEAR(moved.x(), 100.0, 8.0);
    EXPECT_LT(moved.tail<2>().norm(), 1e-9) << "along its axis only";
    EXPECT_TRUE(box().pose.linear().isApprox(before.linear(), 1e-12));
    EXPECT_NEAR(editor.findChild<QDoubleSpinBox*>("placeX")->value(), box().pose.translation().x(),
                1e-3);
    keepPicture(editor, "handles");
    // About z: from a place of its ring to another 40 degrees on.
    const Eigen::Isometry3d here = box().pose;
    const auto onRing = [&](double degrees) {
      const double a = base::degreesToRadians(degrees);
      const double radius =
          0.72 * 90.0 * camera.mmPerPixel(here.translation()) * port->devicePixelRatioF();
      return onScreen(here.translation() + radius * Vector3d(std::cos(a), std::sin(a), 0.0));
    };
    drag(onRing(215.0), onRing(255.0) - onRing(215.0));
    ASSERT_TRUE(settled(editor));
    const Eigen::AngleAxisd turned(here.linear().transpose() * box().pose.linear());
    EXPECT_NEAR(turned.angle(), base::degreesToRadians(40.0), 0.1);
    EXPECT_GT(turned.axis().z(), 1.0 - 1e-9);
    EXPECT_LT((box().pose.translation() - here.translation()).norm(), 1e-9);
    // Two edits, each taken back by itself.
    QTest::keyClick(&editor, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(box().pose.isApprox(here, 1e-12));
    QTest::keyClick(&editor, Qt::Key_Z, Qt::ControlModifier);
    EXPECT_TRUE(box().pose.isApprox(before, 1e-12));
    ASSERT_TRUE(settled(editor));
    // A click on a handle that moves nothing is no edit.
    const std::string text = editor.draft().text();
    drag(onScreen(at + 0.9 * reach * Vector3d::UnitX()), QPointF(0, 0));
    ASSERT_TRUE(settled(editor));
    EXPECT_EQ(editor.draft().text(), text);
    editor.done(QDialog::Rejected);
  });
}

// The place for purges is added, moved by numbers, checked, taken back by the keys, and saved.
TEST_F(CellEditorTest, ThePlaceForPurgesIsAddedMovedAndSaved) {
  inEditor([&](window::CellEditor& editor) {
    EXPECT_FALSE(editor.findChild<QPushButton*>("cellAddPurgePlace")->isEnabled())
        << "the nozzle is fixed";
    editor.done(QDialog::Rejected);
  });
  project::Choices choices = document().choices();
  choices.cell = "ur5-moving";
  document().setChoices(choices, "cell");
  inEditor([&](window::CellEditor& editor) {
    auto* port = editor.findChild<viewer::Viewport*>();
    const auto shown = [&] {
      EXPECT_TRUE(settled(editor));
      QTest::qWait(300); // the new scene is painted
      return port->grabFrame().convertToFormat(QImage::Format_RGB32);
    };
    const auto place = [&] {
      return body(editor, robot::DraftBody::Kind::PurgePlace).pose.translation();
    };
    const QImage without = shown();
    press(editor, "cellAddPurgePlace");
    ASSERT_TRUE(settled(editor));
    EXPECT_EQ(editor.findChild<QTreeWidget*>("cellBodies")->currentItem()->text(0),
              "Place for purges");
    EXPECT_FALSE(editor.findChild<QPushButton*>("cellAddPurgePlace")->isEnabled()) << "one only";
    EXPECT_FALSE(editor.findChild<QWidget*>("frameTurnX")->isVisible()) << "a point";
    EXPECT_EQ(port->tool(), viewer::Tool::Move);
    EXPECT_TRUE(faults(editor).startsWith("No problems")) << faults(editor).toStdString();
    keepPicture(editor, "purge_place");
    const Vector3d beside = place();
    const QImage there = shown();
    EXPECT_GT(differingShare(without, there), 0.0005);
    type(editor, "placeX", 5000.0);
    ASSERT_TRUE(settled(editor));
    EXPECT_EQ(place(), Vector3d(5000.0, beside.y(), beside.z()));
    EXPECT_TRUE(faults(editor).contains("does not reach the place for purges"))
        << faults(editor).toStdString();
    QTest::keyClick(&editor, Qt::Key_Z, Qt::ControlModifier);
    ASSERT_TRUE(settled(editor));
    EXPECT_EQ(place(), beside);
    press(editor, "cellRemove");
    ASSERT_TRUE(settled(editor));
    EXPECT_TRUE(editor.findChild<QPushButton*>("cellAddPurgePlace")->isEnabled());
    QTest::keyClick(&editor, Qt::Key_Z, Qt::ControlModifier);
    ASSERT_TRUE(settled(editor));
    auto* bodies = editor.findChild<QTreeWidget*>("cellBodies");
    const auto found = bodies->findItems("Place for purges", Qt::MatchExactly | Qt::MatchRecursive);
    ASSERT_EQ(found.size(), 1);
    bodies->setCurrentItem(found.front());
    type(editor, "placeZ", 40.0);
    ASSERT_TRUE(settled(editor));
    saveAs(editor, "with-purges");
  });
  ASSERT_EQ(document().choices().cell, "with-purges");
  const robot::Cell cell = robot::loadCell("with-purges", process::loadProcess("fdm-1.0"),
                                           {{-40, -40}, {40, -40}, {40, 40}, {-40, 40}});
  ASSERT_TRUE(cell.purgePlaceMm());
  EXPECT_EQ(cell.purgePlaceMm()->z(), 40.0);
}

// An arm with visual meshes is drawn with them, and with its solids where these are chosen.
TEST_F(CellEditorTest, AnImportedArmLooksLikeItsMeshes) {
  base::writeFile(path("link.stl").toStdString(),
                  geometry::writeStl(box({-0.05, -0.05, 0.0}, {0.05, 0.05, 0.3})));
  const UrdfArm arm = irb1200();
  base::writeFile(path("arm.urdf").toStdString(), urdfOf(arm, [&](std::size_t i) {
                    std::string link;
                    for (const UrdfTube& tube : arm.links[i])
                      link += urdfTube(tube);
                    return link + "<visual><geometry><mesh filename=\"link.stl\"/></geometry>"
                                  "</visual>";
                  }));
  robot::UrdfOptions options;
  options.id = "boxy";
  const cells::ArmImport import =
      cells::importArm(path("arm.urdf").toStdString(), options, robot::Mount::Flange,
                       process::loadProcess("fdm-1.0"), base::RunContext{});
  cells::writeImport(import, base::userDataFolder());
  project::Choices choices = document().choices();
  choices.cell = "boxy-moving";
  document().setChoices(choices, "cell");
  inEditor([&](window::CellEditor& editor) {
    auto* port = editor.findChild<viewer::Viewport*>();
    auto* solids = editor.findChild<QCheckBox*>("cellSolids");
    const auto shown = [&] {
      EXPECT_TRUE(settled(editor));
      QTest::qWait(300); // the new scene is painted
      return port->grabFrame().convertToFormat(QImage::Format_RGB32);
    };
    const QImage meshes = shown();
    keepPicture(editor, "link_meshes");
    QTest::mouseClick(solids, Qt::LeftButton, {}, QPoint(8, solids->height() / 2));
    const QImage tubes = shown();
    EXPECT_GT(differingShare(meshes, tubes), 0.005);
    keepPicture(editor, "link_solids");
    QTest::mouseClick(solids, Qt::LeftButton, {}, QPoint(8, solids->height() / 2));
    EXPECT_LT(differingShare(meshes, shown()), 0.001);
    // A box that is added leaves the arm as it looks.
    press(editor, "cellAddBox");
    EXPECT_LT(differingShare(meshes, shown()), 0.2);
    editor.done(QDialog::Rejected);
  });
}

} // namespace
} // namespace voluta::test
