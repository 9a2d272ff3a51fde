// Voxels that follow the edits, and the buttons beside findings.
#include "gui/window_fixture.h"
#include "helpers/shapes.h"
#include "panels/findings_panel.h"
#include "plan/finding_kinds.h"

#include <QAction>
#include <QComboBox>
#include <QLabel>
#include <QListView>
#include <QPushButton>
#include <QTest>
#include <QUndoStack>

namespace voluta::test {
namespace {

using document::StageState;
using project::Stage;

class PreviewTest : public WindowTest {
protected:
  void planLayers(const QString& file) {
    openPart(file);
    clickMenu("runMenu", "planLayers");
    ASSERT_TRUE(planned(Stage::Layers));
  }
  QString summary() { return find<QLabel>("summary")->text(); }
  // The voxels of the present choices are there and drawn.
  bool previewed() {
    return waitFor([&] {
      return document().upToDate(Stage::Decompose) && !window().livePreview().running() &&
             !window().planning().running() && !window().presenter().busy();
    });
  }
  void setPlatform(const char* platform) {
    project::Choices choices = document().choices();
    choices.item().platform = project::Platform(platform);
    document().setChoices(choices, "platform");
  }
  QPushButton* remedy(const char* id) {
    return find<panels::FindingsPanel>("findings")
        ->findChild<QPushButton*>(QString("remedy_") + id);
  }
  // Chooses the first finding of that kind by the mouse.
  void clickFinding(const QString& words) {
    auto* list = find<panels::FindingsPanel>("findings")->findChild<QListView*>();
    for (int row = 0; row < list->model()->rowCount(); ++row) {
      const QModelIndex index = list->model()->index(row, 0);
      if (index.data().toString().contains(words)) {
        list->scrollTo(index);
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(index).center());
        return;
      }
    }
    ADD_FAILURE() << "no finding says " << words.toStdString();
  }
};

geometry::TriangleMesh plinth() {
  return box({0, 0, 0}, {9, 9, 5});
}

// A post, an arm, and a tip below the arm's end: the front of a wide platform closes under it.
geometry::TriangleMesh hook() {
  geometry::TriangleMesh mesh;
  const double x[] = {0, 6, 22, 28}, z[] = {0, 6, 20, 26};
  // The outline in x and z, extruded along y.
  const std::vector<std::pair<double, double>> outline{{x[0], z[0]}, {x[1], z[0]}, {x[1], z[2]},
                                                       {x[2], z[2]}, {x[2], z[1]}, {x[3], z[1]},
                                                       {x[3], z[3]}, {x[0], z[3]}};
  const int n = static_cast<int>(outline.size());
  for (const double y : {0.0, 6.0})
    for (const auto& [px, pz] : outline)
      mesh.vertices.emplace_back(px, y, pz);
  for (int i = 0; i < n; ++i) {
    const int next = (i + 1) % n;
    mesh.triangles.push_back({i, next, n + next});
    mesh.triangles.push_back({i, n + next, n + i});
  }
  // Convex pieces of the outline: post, arm, tip.
  const int caps[][3] = {{0, 1, 2}, {0, 2, 7}, {2, 3, 7}, {3, 6, 7}, {3, 4, 6}, {4, 5, 6}};
  for (const auto& c : caps) {
    mesh.triangles.push_back({c[0], c[2], c[1]});
    mesh.triangles.push_back({n + c[0], n + c[1], n + c[2]});
  }
  for (auto& t : mesh.triangles)
    std::swap(t[1], t[2]);
  return mesh;
}

TEST_F(PreviewTest, TheGrowthListInWordsStartsAPreviewOnThePageOfTheEdit) {
  planLayers(writePart("plinth.stl", plinth()));
  choosePage(Page::Prepare);
  EXPECT_FALSE(window().viewport().view().voxels);
  auto* growth = find<QComboBox>("growth");
  EXPECT_EQ(growth->count(), 6);
  EXPECT_NE(growth->currentText(), "auto") << "plain words";
  window().viewport().lookAt({0, 0, 5}, 15.0); // at the part, which is small beside the machine
  const QImage before = picture();
  growth->setFocus();
  QTest::keyClick(growth, Qt::Key_End); // greedy
  ASSERT_EQ(document().choices().item().growth.id(), "greedy");
  EXPECT_EQ(document().state(Stage::Decompose), StageState::OutOfDate);
  ASSERT_TRUE(previewed());
  EXPECT_EQ(document().state(Stage::Layers), StageState::OutOfDate);
  EXPECT_TRUE(window().viewport().view().voxels);
  EXPECT_TRUE(summary().contains("Preview")) << summary().toStdString();
  EXPECT_TRUE(find<QWidget>("legend")->isVisible()) << "what the colours mean";
  EXPECT_GT(differingShare(before, picture()), 0.02);
  QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(waitFor([&] { return !document().voxelsAhead() && !window().presenter().busy(); }));
  EXPECT_FALSE(window().viewport().view().voxels);
  EXPECT_FALSE(summary().contains("Preview"));
}

TEST_F(PreviewTest, PlanTakesThePreviewOn) {
  planLayers(writePart("plinth.stl", plinth()));
  setPlatform("disc:40");
  ASSERT_TRUE(previewed());
  EXPECT_TRUE(window().viewport().view().voxels) << "newer than the layers";
  const auto previewed = document().result(Stage::Decompose)->job.item().decomposition();
  clickMenu("runMenu", "planLayers");
  ASSERT_TRUE(planned(Stage::Layers));
  EXPECT_EQ(document().result(Stage::Decompose)->job.item().decomposition(), previewed);
  EXPECT_FALSE(window().viewport().view().voxels);
  EXPECT_TRUE(window().viewport().view().layers);
  EXPECT_FALSE(summary().contains("Preview"));
}

TEST_F(PreviewTest, ThePartIsInSightWhileItIsHandled) {
  planLayers(writePart("plinth.stl", plinth()));
  choosePage(Page::Prepare);
  setPlatform("disc:40");
  ASSERT_TRUE(previewed());
  EXPECT_TRUE(window().viewport().view().voxels);
  clickToolBar("toolMove");
  EXPECT_TRUE(window().viewport().view().part);
  EXPECT_FALSE(window().viewport().view().voxels);
  clickToolBar("toolMove");
  EXPECT_TRUE(window().viewport().view().voxels);
  // Moved voxels would be outside the part.
  QTest::keyClick(&window(), Qt::Key_C);
  geometry::Placement moved = document().choices().item().placement;
  moved.centreMm.x() += 12.0;
  document().place(moved, "move");
  EXPECT_FALSE(window().viewport().view().voxels);
  ASSERT_TRUE(previewed());
  EXPECT_TRUE(window().viewport().view().voxels);
}

TEST_F(PreviewTest, CanBeTurnedOffAndTheWindowRemembers) {
  planLayers(writePart("plinth.stl", plinth()));
  EXPECT_TRUE(find<QAction>("livePreview")->isChecked());
  clickMenu("runMenu", "livePreview");
  EXPECT_FALSE(window().livePreview().enabled());
  setPlatform("disc:40");
  EXPECT_FALSE(waitFor([&] { return window().livePreview().running(); }, 700));
  EXPECT_EQ(document().state(Stage::Decompose), StageState::OutOfDate);
  window_ = std::make_unique<window::MainWindow>(window::Appearance::Light);
  EXPECT_FALSE(window().livePreview().enabled());
}

TEST_F(PreviewTest, AButtonCuresAFindingAndUndoTakesItBack) {
  project::Choices wide = document().choices();
  wide.item().platform = project::Platform("disc:150");
  wide.item().parameters["supports"] = "none";
  wide.item().parameters["frontShape"] = "flat";
  document().setChoices(wide, "platform");
  planLayers(writePart("hook.stl", hook()));
  const auto missed = [&] {
    return document().result(Stage::Decompose)->job.report.item().decomposition.missedVoxels;
  };
  const std::size_t before = missed();
  ASSERT_GT(before, 0U);
  clickFinding("shadowed");
  QPushButton* shrink = remedy("shrinkPlatform");
  ASSERT_NE(shrink, nullptr);
  ASSERT_TRUE(shrink->isVisible());
  EXPECT_EQ(shrink->text(), "Shrink platform");
  QTest::mouseClick(shrink, Qt::LeftButton);
  EXPECT_EQ(document().choices().item().platform.text(), "fit:0");
  ASSERT_TRUE(previewed());
  EXPECT_LT(missed(), before);
  EXPECT_EQ(document().undoStack()->undoText(), "Shrink platform");
  QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().choices().item().platform.text(), "disc:150");
  ASSERT_TRUE(previewed());
  EXPECT_EQ(missed(), before);
}

TEST_F(PreviewTest, PartInTheAirIsDroppedByTheButtonOfTheFinding) {
  planLayers(writePart("plinth.stl", plinth()));
  geometry::Placement lifted = document().choices().item().placement;
  lifted.liftMm = 5.0;
  document().place(lifted, "lift");
  ASSERT_TRUE(waitFor([&] { return document().failure() != nullptr; }));
  clickFinding("does not touch");
  ASSERT_NE(remedy("dropToPlate"), nullptr);
  QTest::mouseClick(remedy("dropToPlate"), Qt::LeftButton);
  EXPECT_EQ(document().choices().item().placement.liftMm, 0.0);
  ASSERT_TRUE(previewed());
  EXPECT_EQ(document().failure(), nullptr);
  EXPECT_EQ(document().state(Stage::Layers), StageState::Done) << "as it was before the lift";
}

TEST_F(PreviewTest, AThinWallOffersTheWidthThatHoldsIt) {
  geometry::TriangleMesh part = plinth();
  append(part, box({14, 0, 0}, {14.5, 9, 6}));
  planLayers(writePart("fin.stl", part));
  clickFinding("thinner than a voxel");
  ASSERT_NE(remedy("narrowVoxels"), nullptr);
  EXPECT_EQ(remedy("narrowVoxels")->text(), "Use voxel width 0.5 mm");
  QTest::mouseClick(remedy("narrowVoxels"), Qt::LeftButton);
  ASSERT_TRUE(previewed());
  for (const auto& finding : document().presentResult()->job.report.findings)
    EXPECT_NE(voluta::plan::reportId(finding), "thinWalls");
}

} // namespace
} // namespace voluta::test
