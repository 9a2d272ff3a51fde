// Several parts on the plate, by mouse and keys: added, selected, moved, copied, removed, planned,
// saved and reopened.
#include "base/files.h"
#include "gui/window_fixture.h"
#include "helpers/shapes.h"
#include "panels/findings_model.h"
#include "panels/findings_panel.h"
#include "panels/part_list.h"
#include "pictures/job_picture.h"

#include <QAction>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QLabel>
#include <QListView>
#include <QMimeData>
#include <QPushButton>
#include <QTest>
#include <QToolButton>
#include <QTreeWidget>
#include <QUndoStack>
#include <future>

namespace voluta::test {
namespace {

using project::Stage;

class SeveralPartsTest : public WindowTest {
protected:
  // Flat layers: mode auto would plan several ways.
  void openFlat() {
    openPart(writePart("plinth.stl", box({0, 0, 0}, {20.0, 20.0, 6.0})));
    chooseFlat();
    ASSERT_TRUE(planned(Stage::Load));
  }
  void addByMenu() {
    answerFileDialog(writePart("tower.stl", box({0, 0, 0}, {10.0, 10.0, 15.0})));
    clickMenu("fileMenu", "addPart");
    ASSERT_TRUE(settled(2));
  }
  bool settled(std::size_t parts) {
    return waitFor([&] {
      return document().partCount() == parts && document().sourceReady() &&
             !window().planning().running() && document().upToDate(Stage::Load) &&
             !window().presenter().busy();
    });
  }
  QTreeWidget& rows() { return *find<QTreeWidget>("partRows"); }
  bool listShown() { return find<panels::PartList>("partList")->isVisible(); }
  void click(const char* button) { QTest::mouseClick(find<QToolButton>(button), Qt::LeftButton); }
  void clickRow(int row) {
    QTest::mouseClick(rows().viewport(), Qt::LeftButton, {},
                      rows().visualItemRect(rows().topLevelItem(row)).center());
  }
  Eigen::AlignedBox3d boxOf(std::size_t item) {
    return geometry::bounds(*document().result(Stage::Load)->job.item(item).part);
  }
  std::vector<double> xs() {
    std::vector<double> all;
    for (const project::ItemChoices& item : document().jobChoices().items)
      all.push_back(item.placement.centreMm.x());
    return all;
  }
};

TEST_F(SeveralPartsTest, OnePartHasNoList) {
  openFlat();
  EXPECT_FALSE(listShown());
  EXPECT_TRUE(find<QAction>("addPart")->isEnabled());
  EXPECT_TRUE(find<QAction>("removePart")->isEnabled());
  keepPicture(window(), "parts_one");
}

TEST_F(SeveralPartsTest, AddedSelectedMovedCopiedRemovedAndUndone) {
  openFlat();
  addByMenu();
  ASSERT_TRUE(listShown());
  ASSERT_EQ(rows().topLevelItemCount(), 2);
  EXPECT_EQ(rows().topLevelItem(0)->text(0), "plinth");
  EXPECT_EQ(rows().topLevelItem(1)->text(0), "tower");
  EXPECT_EQ(rows().topLevelItem(1)->text(2), "10 × 10 × 15");
  EXPECT_EQ(rows().indexOfTopLevelItem(rows().currentItem()), 1);
  EXPECT_NEAR(boxOf(1).min().x() - boxOf(0).max().x(), 10.0, 1e-6);
  keepPicture(window(), "parts_two");

  clickRow(0);
  EXPECT_EQ(document().active(), 0u);
  EXPECT_NEAR(window().presenter().partBox().sizes().x(), 20.0, 1e-6);
  keepPicture(window(), "parts_first");
  clickRow(1);
  EXPECT_NEAR(window().presenter().partBox().sizes().x(), 10.0, 1e-6);

  window().viewport().setFocus();
  QTest::keyClick(&window().viewport(), Qt::Key_C); // centres the active part only
  ASSERT_TRUE(settled(2));
  EXPECT_EQ(xs(), (std::vector{0.0, 0.0}));
  document().undoStack()->undo();
  ASSERT_TRUE(settled(2));
  EXPECT_EQ(xs(), (std::vector{0.0, 25.0}));

  click("partDuplicate");
  ASSERT_TRUE(settled(3));
  EXPECT_EQ(rows().topLevelItem(2)->text(0), "tower (2)");
  EXPECT_EQ(xs(), (std::vector{0.0, 25.0, 49.0}));
  keepPicture(window(), "parts_three");
  clickRow(0);
  click("partRemove");
  ASSERT_TRUE(settled(2));
  EXPECT_EQ(rows().topLevelItem(0)->text(0), "tower");
  document().undoStack()->undo();
  ASSERT_TRUE(settled(3));
  EXPECT_EQ(document().active(), 0u);
  document().undoStack()->undo();
  document().undoStack()->undo();
  ASSERT_TRUE(settled(1));
  EXPECT_FALSE(listShown());
}

// Each part has its own mode; a choice for the job is one for all.
TEST_F(SeveralPartsTest, TheFormIsThatOfTheActivePart) {
  openFlat();
  addByMenu();
  auto* mode = find<QComboBox>("mode");
  ASSERT_NE(mode, nullptr);
  const int flat = mode->currentIndex();
  mode->setFocus();
  mode->setCurrentIndex(mode->findData("auto"));
  EXPECT_TRUE(document().jobChoices().item(1).automatic);
  EXPECT_FALSE(document().jobChoices().item(0).automatic);
  EXPECT_EQ(rows().topLevelItem(1)->text(1), "Automatic");
  EXPECT_EQ(rows().topLevelItem(0)->text(1), "Flat layers");
  const bool explained = !document().unusable() || find<QLabel>("notice")->isVisible();
  EXPECT_TRUE(explained) << "why they cannot be planned together";
  keepPicture(window(), "parts_automatic");
  clickRow(0);
  EXPECT_EQ(mode->currentIndex(), flat);
  document().undoStack()->undo();
  EXPECT_EQ(document().active(), 1u) << "the part of the edit that was undone";
  EXPECT_EQ(mode->currentIndex(), flat);
  auto* process = find<QComboBox>("process");
  process->setFocus();
  process->setCurrentIndex(process->findData("fdm-0.35"));
  EXPECT_EQ(document().jobChoices().tool().process, "fdm-0.35");
}

TEST_F(SeveralPartsTest, ArrangedPartsLeaveRoomForTheHead) {
  openFlat();
  addByMenu();
  click("partDuplicate");
  ASSERT_TRUE(settled(3));
  const auto placeOf = [&](std::size_t i) {
    return document().jobChoices().item(i).placement.centreMm;
  };
  const Eigen::Vector2d before = placeOf(2);
  auto* arrange = find<QToolButton>("partArrange");
  ASSERT_NE(arrange, nullptr);
  QTest::mouseClick(arrange, Qt::LeftButton);
  EXPECT_NE(placeOf(2), before);
  EXPECT_GT((placeOf(2) - placeOf(1)).norm(), 1.0);
  keepPicture(window(), "parts_arranged");
  document().undoStack()->undo();
  EXPECT_EQ(placeOf(2), before);
}

// A remedy changes the part that its finding concerns.
TEST_F(SeveralPartsTest, AFindingNamesItsPartAndItsRemedyChangesIt) {
  openFlat();
  answerFileDialog(writePart("tiny.stl", box({0, 0, 0}, {0.02, 0.02, 0.02})));
  clickMenu("fileMenu", "addPart");
  ASSERT_TRUE(settled(2));
  document().setActive(0);
  auto* list = find<panels::FindingsPanel>("findings")->findChild<QListView*>("list");
  ASSERT_NE(list, nullptr);
  ASSERT_TRUE(waitFor([&] { return list->model()->rowCount() > 0; }, 5000));
  const QString detail =
      list->model()->index(0, 0).data(panels::FindingsModel::DetailRole).toString();
  EXPECT_TRUE(detail.startsWith("tiny")) << qPrintable(detail);
  list->setCurrentIndex(list->model()->index(0, 0));
  auto* metres = find<QPushButton>("remedy_unitsMetres");
  ASSERT_NE(metres, nullptr);
  QTest::mouseClick(metres, Qt::LeftButton);
  EXPECT_EQ(document().jobChoices().item(1).units, "m");
  EXPECT_EQ(document().jobChoices().item(0).units, "mm");
  EXPECT_EQ(document().active(), 1u);
}

// Clicks the point of the picture under the middle of a part.
TEST_F(SeveralPartsTest, AClickInThePictureSelectsAPart) {
  openFlat();
  addByMenu();
  auto& viewport = window().viewport();
  const auto clickPart = [&](std::size_t item) {
    viewport.lookAt(boxOf(item).center(), 30.0);
    QTest::qWait(800); // the camera flies there
    QTest::mouseClick(&viewport, Qt::LeftButton, {}, viewport.rect().center());
  };
  clickPart(0);
  keepPicture(window(), "parts_close");
  EXPECT_TRUE(waitFor([&] { return document().active() == 0; }, 3000));
  clickPart(1);
  EXPECT_TRUE(waitFor([&] { return document().active() == 1; }, 3000));
}

TEST_F(SeveralPartsTest, PlannedSavedAndReopened) {
  openFlat();
  addByMenu();
  QTest::keyClick(find<QComboBox>("printOrder"), Qt::Key_Down);
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Toolpath));
  ASSERT_TRUE(waitFor([&] { return !window().planning().running(); }));
  std::vector<bool> printed(2, false);
  for (const plan::ToolPath& path : document().result(Stage::Toolpath)->job.toolPlan->paths)
    printed[static_cast<std::size_t>(path.item)] = true;
  EXPECT_EQ(printed, (std::vector{true, true}));
  choosePage(Page::Layers);
  EXPECT_GT(window().presenter().patchLayers(), 0);
  EXPECT_GE(find<QComboBox>("colourBy")->findText("Part"), 0);
  keepPicture(window(), "parts_layers");
  find<QComboBox>("colourBy")->setCurrentIndex(find<QComboBox>("colourBy")->findText("Part"));
  keepPicture(window(), "parts_coloured");

  answerFileDialog(path("two.voluta"));
  clickMenu("fileMenu", "save");
  ASSERT_TRUE(waitFor([&] { return !document().dirty(); }, 20000));
  openWindow();
  window().open(path("two.voluta"));
  ASSERT_TRUE(waitFor([&] { return document().partCount() == 2 && !window().presenter().busy(); }));
  EXPECT_TRUE(document().upToDate(Stage::Toolpath));
  choosePage(Page::Prepare);
  EXPECT_TRUE(listShown());
  EXPECT_EQ(rows().topLevelItemCount(), 2);
}

// Voxels are those of the active part; the others stay as solids.
TEST_F(SeveralPartsTest, VoxelsFollowTheActivePart) {
  openPart("sample:vase");
  document().setScale("0.5");
  document().duplicatePart();
  document().setScale("0.4");
  ASSERT_TRUE(settled(2));
  window().planning().plan(Stage::Decompose);
  ASSERT_TRUE(planned(Stage::Decompose));
  const int layersOfSmall = window().presenter().voxelLayers();
  EXPECT_GT(layersOfSmall, 0);
  choosePage(Page::Layers);
  window().viewport().frameAll();
  keepPicture(window(), "parts_voxels");
  window().viewport().lookAt(boxOf(0).center(), 30.0);
  QTest::qWait(800); // the camera flies there
  QTest::mouseClick(&window().viewport(), Qt::LeftButton, {}, window().viewport().rect().center());
  ASSERT_TRUE(waitFor([&] { return document().active() == 0; }, 3000));
  ASSERT_TRUE(planned(Stage::Decompose));
  EXPECT_GT(window().presenter().voxelLayers(), layersOfSmall);
  keepPicture(window(), "parts_voxels_first");
}

// Pictures of a job show all its parts.
TEST_F(SeveralPartsTest, PicturesOfAJobShowAllParts) {
  openFlat();
  document().duplicatePart();
  ASSERT_TRUE(settled(2));
  window().planning().plan(Stage::Toolpath);
  ASSERT_TRUE(planned(Stage::Toolpath));
  project::Job both = document().result(Stage::Toolpath)->job;
  project::Job one = both;
  one.items.resize(1);
  one.choices.items.resize(1);
  pictures::PictureOptions look;
  look.width = 400;
  look.height = 250;
  // The window's thread has a context of its own.
  const auto drawn = [&](const project::Job& job) {
    return std::async(std::launch::async, [&] { return pictures::jobPicture(job, look); }).get();
  };
  for (const char* show : {"part", "pieces", "layers"}) {
    look.show = show;
    const scene::Image all = drawn(both);
    EXPECT_NE(all.rgb, drawn(one).rgb) << show;
    if (const QString folder = qEnvironmentVariable("VOLUTA_TEST_PICTURES"); !folder.isEmpty())
      base::writeFile((folder + "/job_" + show + ".png").toStdString(), scene::pngBytes(all));
  }
}

TEST_F(SeveralPartsTest, DroppedPartsAreAdded) {
  openFlat();
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(writePart("tower.stl", box({0, 0, 0}, {10.0, 10.0, 15.0}))),
                QUrl::fromLocalFile(writePart("post.stl", box({0, 0, 0}, {5.0, 5.0, 20.0})))});
  answerBox("dropBox", QMessageBox::AcceptRole);
  QDragEnterEvent enter(QPoint(200, 200), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&window(), &enter);
  QDropEvent event(QPointF(200, 200), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&window(), &event);
  EXPECT_TRUE(settled(3));
  EXPECT_EQ(rows().topLevelItem(2)->text(0), "post");
}

} // namespace
} // namespace voluta::test
