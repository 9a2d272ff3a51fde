// Pieces of planar mode in the window: chosen in tree and viewport, moved apart, their cuts
// dragged by handles; projects of planar mode, which have no voxels.
#include "gui/window_fixture.h"
#include "helpers/octagon_prism.h"
#include "helpers/shapes.h"
#include "panels/findings_panel.h"
#include "panels/pieces_panel.h"
#include "planar/given_cuts.h"
#include "project/job.h"
#include "viewer/camera_control.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QListView>
#include <QPushButton>
#include <QSlider>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>
#include <cmath>

namespace voluta::test {
namespace {

using project::Stage;

constexpr const char* kCuts = R"([{"point": [4, 0, 20], "normal": [1, 0, 0]},
                                  {"point": [-4, 0, 20], "normal": [-1, 0, 0]}])";

// A leg of 8 x 8 x 16 with a bar of 32 x 8 x 8 across its top.
geometry::TriangleMesh tee() {
  return test::tee(16, 32);
}

class PiecesTest : public WindowTest {
protected:
  void choose(const char* mode) {
    choosePage(Page::Prepare);
    auto* combo = find<QComboBox>("mode");
    combo->setFocus();
    QTest::keyClick(combo, Qt::Key_Home);
    for (int i = 0; i < combo->count() && document().choices().item().mode != mode; ++i)
      QTest::keyClick(combo, Qt::Key_Down);
    ASSERT_EQ(document().choices().item().mode, mode);
  }
  void planTee() {
    openPart(writePart("tee.stl", tee()));
    choose("planar");
    document().setParameter("cutPlanes", kCuts);
    clickMenu("runMenu", "planLayers");
    ASSERT_TRUE(planned(Stage::Layers));
    choosePage(Page::Layers);
    QTest::mouseClick(find<QToolButton>("subject4"), Qt::LeftButton);
    ASSERT_TRUE(view().pieces);
  }
  // The pieces of the present choices are there and drawn.
  bool cutAnew() {
    return waitFor([&] {
      return document().upToDate(Stage::Decompose) && !window().livePreview().running() &&
             !window().planning().running() && !window().presenter().busy();
    });
  }
  const scene::ViewState& view() { return window().viewport().view(); }
  panels::PiecesPanel& panel() { return *find<panels::PiecesPanel>("pieces"); }
  QTreeWidget& tree() { return *find<QTreeWidget>("pieceTree"); }
  void clickRow(QTreeWidgetItem* item) {
    tree().scrollToItem(item);
    QTest::mouseClick(tree().viewport(), Qt::LeftButton, {}, tree().visualItemRect(item).center());
  }
  QTreeWidgetItem* row(int arm) { return tree().topLevelItem(0)->child(arm); }
  std::vector<planar::GivenCut> ownCuts() {
    const auto text = document().choices().item().parameters.find("cutPlanes");
    return text == document().choices().item().parameters.end()
               ? std::vector<planar::GivenCut>{}
               : planar::readGivenCuts(text->second, "the choices");
  }
  // Where a place of the part is in the viewport.
  QPoint onScreen(const Eigen::Vector3d& place) {
    const viewer::CameraControl camera(window().viewport().scene().renderer());
    const Eigen::Vector3d display = camera.project(place);
    return window().viewport().fromDisplay({display.x(), display.y()}).toPoint();
  }
  void drag(QPoint from, QPoint to) {
    viewer::Viewport& port = window().viewport();
    QTest::mouseMove(&port, from);
    QTest::mousePress(&port, Qt::LeftButton, {}, from);
    for (int step = 1; step <= 5; ++step)
      QTest::mouseMove(&port, from + (to - from) * step / 5);
    QTest::mouseRelease(&port, Qt::LeftButton, {}, to);
  }
};

TEST_F(PiecesTest, TreeAndViewportShowTheSamePieces) {
  planTee();
  EXPECT_FALSE(find<QToolButton>("subject1")->isVisible()) << "there are no voxels";
  EXPECT_FALSE(find<QComboBox>("colourBy")->isVisible());
  ASSERT_TRUE(panel().isVisible());
  ASSERT_EQ(tree().topLevelItemCount(), 1);
  ASSERT_EQ(tree().topLevelItem(0)->childCount(), 2);
  EXPECT_EQ(row(0)->text(1), QLocale().toString(0.77, 'f', 2) + QString::fromUtf8(" cm³"));
  EXPECT_TRUE(find<QLabel>("pieceTotal")->text().contains("192"))
      << find<QLabel>("pieceTotal")->text().toStdString();
  const scene::Legend legend = window().viewport().scene().legend();
  EXPECT_TRUE(legend.entries.empty()) << "the picture has the numbers";
  EXPECT_TRUE(legend.marks.empty()) << "nothing needs support";

  const QImage whole = picture();
  auto* explode = find<QSlider>("explode");
  explode->setFocus();
  QTest::keyClick(explode, Qt::Key_End);
  EXPECT_GT(view().explodeMm, 5.0);
  const QImage apart = picture();
  EXPECT_GT(differingShare(whole, apart), 0.005);
  QTest::mouseClick(find<QCheckBox>("basePlanes"), Qt::LeftButton, {}, {8, 8});
  EXPECT_TRUE(view().basePlanes);
  EXPECT_GT(differingShare(apart, picture()), 0.001);
  explode->setFocus(); // the box has it
  QTest::keyClick(explode, Qt::Key_Home);
  EXPECT_EQ(view().explodeMm, 0.0);
  QTest::mouseClick(find<QCheckBox>("basePlanes"), Qt::LeftButton, {}, {8, 8});

  const QImage plain = picture();
  clickRow(row(1));
  ASSERT_TRUE(view().piece);
  EXPECT_EQ(*view().piece, 2u);
  EXPECT_GT(differingShare(plain, picture()), 0.01) << "the others step back";
  EXPECT_EQ(window().viewport().tool(), viewer::Tool::CutPlane);
  window().viewport().setFocus();
  QTest::keyClick(&window().viewport(), Qt::Key_Escape);
  EXPECT_FALSE(view().piece);
  EXPECT_EQ(panel().selected(), -1);
  EXPECT_EQ(window().viewport().tool(), viewer::Tool::None);

  // By a click in the picture: on each arm, seen from the front.
  window().viewport().viewFrom({0, -1, 0});
  picture();
  for (const double x : {12.0, -12.0}) {
    QTest::mouseClick(&window().viewport(), Qt::LeftButton, {}, onScreen({x, -4, 20}));
    ASSERT_GE(panel().selected(), 1) << x;
    const int cut = window().presenter().pieces().cutOf(panel().selected());
    EXPECT_GT(window().presenter().pieces().cuts()[static_cast<std::size_t>(cut)].plane.normal.x() *
                  x,
              0.0);
    EXPECT_EQ(tree().currentItem()->data(0, Qt::UserRole).toInt(), panel().selected());
  }
  QTest::mouseClick(&window().viewport(), Qt::LeftButton, {}, onScreen({0, -4, 4}));
  EXPECT_EQ(panel().selected(), 0);
  EXPECT_EQ(window().viewport().tool(), viewer::Tool::None) << "it stands on the plate: no cut";

  // Elsewhere they are out of the way, and back where they were.
  choosePage(Page::Prepare);
  EXPECT_FALSE(view().pieces);
  choosePage(Page::Layers);
  EXPECT_TRUE(view().pieces);
  QTest::mouseClick(find<QToolButton>("subject2"), Qt::LeftButton);
  EXPECT_TRUE(view().layers);
  EXPECT_FALSE(panel().isVisible());
}

TEST_F(PiecesTest, NumbersAreInThePictureAndTheLegendStaysSmall) {
  planTee();
  window().viewport().viewFrom({0, -1, 0});
  EXPECT_TRUE(view().pieceNumbers);
  EXPECT_TRUE(window().viewport().scene().legend().entries.empty());
  const QImage numbered = picture();
  auto* numbers = find<QCheckBox>("pieceNumbers");
  QTest::mouseClick(numbers, Qt::LeftButton, {}, {8, 8});
  EXPECT_FALSE(view().pieceNumbers);
  EXPECT_GT(differingShare(numbered, picture()), 1e-4);
  EXPECT_EQ(window().viewport().scene().legend().entries.size(), 3u) << "then the legend has them";
  auto* legend = find<QWidget>("legend");
  EXPECT_TRUE(legend->isVisible());

  // The framed part is beside the legend, which a key hides.
  clickMenu("viewMenu", "frameAll");
  picture();
  for (const double x : {-16.0, 16.0})
    for (const double z : {16.0, 24.0})
      EXPECT_FALSE(legend->geometry().contains(onScreen({x, -4, z}))) << x << " " << z;
  QTest::keyClick(&window().viewport(), Qt::Key_L);
  EXPECT_FALSE(legend->isVisible());
  choosePage(Page::Prepare);
  choosePage(Page::Layers);
  EXPECT_FALSE(legend->isVisible()) << "it stays away";
  QTest::keyClick(&window().viewport(), Qt::Key_L);
  EXPECT_TRUE(legend->isVisible());
}

TEST_F(PiecesTest, HintNamesTheActionsForASelectedPiece) {
  planTee();
  auto* hint = find<QLabel>("pieceHint");
  EXPECT_TRUE(hint->text().startsWith("Click a piece"));
  clickRow(row(0));
  EXPECT_TRUE(hint->text().contains("Drag the arrow")) << hint->text().toStdString();
  clickRow(tree().topLevelItem(0));
  EXPECT_TRUE(hint->text().contains("is on the plate")) << hint->text().toStdString();
}

TEST_F(PiecesTest, AFindingIsLookedAtFromWhereItsFaceIsSeen) {
  openPart(writePart("tee.stl", tee()));
  choose("planar");
  // Only one arm is cut off: the other one's underside leans over.
  document().setParameter("cutPlanes", R"([{"point": [4, 0, 20], "normal": [1, 0, 0]}])");
  clickMenu("runMenu", "planLayers");
  ASSERT_TRUE(planned(Stage::Layers));
  choosePage(Page::Layers);
  QTest::mouseClick(find<QToolButton>("subject2"), Qt::LeftButton);
  find<QSlider>("explode")->setValue(50);
  window().viewport().viewFrom({0.5, -0.7, 0.5});
  auto* list = find<panels::FindingsPanel>("findings")->findChild<QListView*>("list");
  int at = -1;
  for (int i = 0; i < list->model()->rowCount() && at < 0; ++i)
    if (list->model()->index(i, 0).data().toString().contains("overhangs by"))
      at = i;
  ASSERT_GE(at, 0);
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                    list->visualRect(list->model()->index(at, 0)).center());
  EXPECT_TRUE(view().pieces);
  EXPECT_EQ(view().explodeMm, 0.0) << "the place is on the part";
  ASSERT_TRUE(view().marker);
  EXPECT_NEAR(view().marker->z(), 16.0, 0.01);
  EXPECT_LT(view().marker->x(), -4.0);
  picture();
  const Eigen::Vector3d eye = scene::towardsEye(window().viewport().scene().renderer());
  EXPECT_LT(eye.z(), 0.0) << "the underside is seen from below";
  const auto hit = window().viewport().scene().pick(
      static_cast<int>(window().viewport().toDisplay(onScreen(*view().marker)).x()),
      static_cast<int>(window().viewport().toDisplay(onScreen(*view().marker)).y()));
  ASSERT_TRUE(hit);
  EXPECT_LT(hit->normal.z(), -0.9);
}

TEST_F(PiecesTest, ACutIsDraggedAndUndone) {
  planTee();
  const auto before = ownCuts();
  ASSERT_EQ(before.size(), 2u);
  window().viewport().viewFrom({0, -1, 0});
  clickRow(row(0));
  picture();
  const auto& pieces = window().presenter().pieces();
  const auto cut = static_cast<std::size_t>(pieces.cutOf(panel().selected()));
  const Eigen::Vector3d place = pieces.cuts()[cut].point, normal = pieces.cuts()[cut].plane.normal;
  const int sign = normal.x() > 0.0 ? 1 : -1;
  const QPoint centre = onScreen(place);

  // Along the arrow, 25 pixels out.
  const double mmPerPixel =
      viewer::CameraControl(window().viewport().scene().renderer()).mmPerPixel(place) *
      window().viewport().devicePixelRatioF();
  drag(centre + QPoint(80 * sign, 0), centre + QPoint(105 * sign, 0));
  const auto moved = ownCuts();
  ASSERT_EQ(moved.size(), 2u);
  EXPECT_LT((moved[cut].plane.normal - normal).norm(), 1e-9);
  EXPECT_NEAR(moved[cut].plane.offsetMm - before[cut].plane.offsetMm, 25 * mmPerPixel,
              2 * mmPerPixel);
  EXPECT_EQ(document().undoStack()->undoText(), "move cut");
  ASSERT_TRUE(cutAnew());
  EXPECT_EQ(document().state(Stage::Layers), document::StageState::OutOfDate);
  EXPECT_GE(panel().selected(), 1) << "it stays chosen";
  // Some of the arm is carried by the leg now.
  EXPECT_NEAR(document().result(Stage::Decompose)->job.report.item().decomposition.riskyAreaMm2,
              8.0 * (moved[cut].plane.offsetMm - 4.0), 0.2);

  // Once more, tilted by the ring that faces the eye: 45 degrees along it from straight up.
  const QPoint now = onScreen(pieces.cuts()[cut].point);
  drag(now + QPoint(0, -65), now + QPoint(20 * sign, -62));
  const auto tilted = ownCuts();
  ASSERT_EQ(tilted.size(), 2u);
  const double angle = std::acos(std::min(1.0, tilted[cut].plane.normal.dot(normal)));
  EXPECT_NEAR(angle, std::atan2(20.0, 62.0), 0.06);
  EXPECT_NEAR(tilted[cut].plane.normal.y(), 0.0, 1e-6);
  ASSERT_TRUE(cutAnew());

  window().activateWindow();
  for (const auto& wanted : {moved, before}) {
    QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
    EXPECT_LT((ownCuts()[cut].plane.normal - wanted[cut].plane.normal).norm(), 1e-9);
    EXPECT_NEAR(ownCuts()[cut].plane.offsetMm, wanted[cut].plane.offsetMm, 1e-9);
  }
  ASSERT_TRUE(cutAnew());
  EXPECT_NEAR(document().result(Stage::Decompose)->job.report.item().decomposition.riskyAreaMm2,
              0.0, 1e-6);
}

TEST_F(PiecesTest, WithoutAPreviewADraggedCutIsMeasuredAndWaitsForPlan) {
  planTee();
  window().livePreview().setEnabled(false);
  window().viewport().viewFrom({0, -1, 0});
  clickRow(row(0));
  picture();
  const auto& pieces = window().presenter().pieces();
  const auto cut = static_cast<std::size_t>(pieces.cutOf(panel().selected()));
  const int sign = pieces.cuts()[cut].plane.normal.x() > 0.0 ? 1 : -1;
  const QPoint centre = onScreen(pieces.cuts()[cut].point);
  auto* total = find<QLabel>("pieceTotal");
  drag(centre + QPoint(80 * sign, 0), centre + QPoint(100 * sign, 0));
  EXPECT_EQ(document().state(Stage::Decompose), document::StageState::OutOfDate);
  EXPECT_TRUE(view().moved_T_base) << "the plane is seen where it is now";
  ASSERT_TRUE(waitFor([&] { return !window().presenter().busy(); }));
  EXPECT_TRUE(total->text().contains("Press Plan")) << total->text().toStdString();
  // Out of the part altogether: an error of one line, and no message box.
  const QPoint there = onScreen(pieces.cuts()[cut].point) + QPoint(20 * sign, 0);
  drag(there + QPoint(80 * sign, 0), there + QPoint(700 * sign, 0));
  ASSERT_TRUE(waitFor([&] { return !window().presenter().busy(); }));
  EXPECT_TRUE(total->text().contains("misses the part")) << total->text().toStdString();
  clickMenu("editMenu", "undo");
  clickMenu("editMenu", "undo");
  EXPECT_TRUE(document().upToDate(Stage::Decompose));
  EXPECT_FALSE(view().moved_T_base);
  EXPECT_TRUE(total->text().contains("192")) << total->text().toStdString();
}

TEST_F(PiecesTest, RootIsPickedOnThePartOnlyForSchemesThatNeedOne) {
  planTee();
  window().livePreview().setEnabled(false);
  EXPECT_FALSE(find<QPushButton>("pickRoot")->isVisible());
  document().setParameter("planarScheme", "greedy");
  EXPECT_FALSE(find<QPushButton>("pickRoot")->isVisible()) << "the cuts are the user's";
  QTest::mouseClick(find<QPushButton>("pieceCuts"), Qt::LeftButton);
  EXPECT_TRUE(ownCuts().empty());
  auto* pick = find<QPushButton>("pickRoot");
  ASSERT_TRUE(pick->isVisible());
  window().viewport().viewFrom({0, -1, 0});
  picture();
  QTest::mouseClick(pick, Qt::LeftButton);
  EXPECT_EQ(window().viewport().tool(), viewer::Tool::PickPoint);
  QTest::mouseClick(&window().viewport(), Qt::LeftButton, {}, onScreen({0, -4, 6}));
  EXPECT_EQ(window().viewport().tool(), viewer::Tool::None);
  EXPECT_FALSE(pick->isChecked());
  const QStringList root =
      QString::fromStdString(document().choices().item().parameters.at("pieceRoot")).split(',');
  ASSERT_EQ(root.size(), 3);
  EXPECT_NEAR(root[0].toDouble(), 0.0, 0.5);
  EXPECT_NEAR(root[1].toDouble(), -4.0, 0.01);
  EXPECT_NEAR(root[2].toDouble(), 6.0, 0.5);
  clickMenu("editMenu", "undo");
  EXPECT_EQ(document().choices().item().parameters.count("pieceRoot"), 0u);
  // A key gives it up.
  QTest::mouseClick(pick, Qt::LeftButton);
  window().viewport().setFocus();
  QTest::keyClick(&window().viewport(), Qt::Key_Escape);
  EXPECT_FALSE(pick->isChecked());
}

TEST_F(PiecesTest, AProjectOfPiecesOpensWithoutVoxels) {
  planTee();
  project::writeJob(path("tee.voluta").toStdString(), document().snapshot());
  answerBox("unsavedBox", QMessageBox::DestructiveRole);
  window().open("sample:vase");
  ASSERT_TRUE(waitFor([&] { return document().source()->name == "vase.stl"; }));
  ASSERT_TRUE(waitFor([&] { return !window().presenter().hasPieces(); }));
  answerBox("unsavedBox", QMessageBox::DestructiveRole);
  window().open(path("tee.voluta"));
  ASSERT_TRUE(waitFor([&] {
    return document().name() == "tee" && window().presenter().hasPieces() &&
           !window().presenter().busy();
  }));
  EXPECT_EQ(page(), Page::Layers);
  EXPECT_TRUE(document().upToDate(Stage::Decompose));
  QTest::mouseClick(find<QToolButton>("subject4"), Qt::LeftButton);
  EXPECT_TRUE(view().pieces);
  ASSERT_EQ(tree().topLevelItemCount(), 1);
  EXPECT_EQ(tree().topLevelItem(0)->childCount(), 2);
  clickRow(row(0));
  EXPECT_EQ(window().viewport().tool(), viewer::Tool::CutPlane);
  QTest::mouseClick(find<QToolButton>("subject2"), Qt::LeftButton);
  EXPECT_TRUE(view().layers);
  EXPECT_EQ(window().viewport().tool(), viewer::Tool::None);
  QTest::mouseClick(find<QToolButton>("subject0"), Qt::LeftButton);
  EXPECT_TRUE(view().layers) << "what the plan has come to";
}

// Not a test of time: how long the window's thread is kept, for the record.
TEST_F(PiecesTest, StretchesOfALargePart) {
  openPart(writePart("ball.stl", sphere({0, 0, 20}, 20, 120)));
  choose("planar");
  document().setParameter("cutPlanes",
                          R"([{"point": [0, 0, 26], "normal": [0, 0, 1]},
                              {"point": [10, 0, 14], "normal": [1, 0, -0.4]},
                              {"point": [-10, 0, 14], "normal": [-1, 0, -0.4]}])");
  clickMenu("runMenu", "planLayers");
  ASSERT_TRUE(planned(Stage::Layers));
  choosePage(Page::Layers);
  application().resetWatch();
  QTest::mouseClick(find<QToolButton>("subject4"), Qt::LeftButton);
  window().viewport().viewFrom({0, -1, 0});
  picture();
  for (int piece = 0; piece < 3; ++piece)
    clickRow(row(piece));
  auto* explode = find<QSlider>("explode");
  explode->setFocus();
  for (const auto key : {Qt::Key_End, Qt::Key_Home})
    QTest::keyClick(explode, key);
  const auto& pieces = window().presenter().pieces();
  const int chosen = pieces.pieceOf(0);
  QTest::mouseClick(&window().viewport(), Qt::LeftButton, {}, onScreen({0, -8, 36}));
  ASSERT_EQ(panel().selected(), chosen);
  const QPoint centre = onScreen(pieces.cuts()[0].point);
  drag(centre + QPoint(0, -80), centre + QPoint(0, -95));
  ASSERT_TRUE(cutAnew());
  EXPECT_EQ(pieces.count(), 4);
  for (const char* button : {"undo", "redo", "frameAll", "toggleSection", "toggleSection"}) {
    clickToolBar(button);
    ASSERT_TRUE(cutAnew());
    picture();
  }
  recordLongestStretch();
}

TEST_F(PiecesTest, OtherModesShowNoPieces) {
  openPart(writePart("tee.stl", tee()));
  choose("flat");
  clickMenu("runMenu", "planLayers");
  ASSERT_TRUE(planned(Stage::Layers));
  choosePage(Page::Layers);
  EXPECT_FALSE(find<QToolButton>("subject4")->isVisible());
  EXPECT_TRUE(find<QToolButton>("subject1")->isVisible());
  EXPECT_FALSE(panel().isVisible());
  EXPECT_FALSE(view().pieces);
}

} // namespace
} // namespace voluta::test
