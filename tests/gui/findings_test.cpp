// A click on a finding shows its place, and its remedy can be clicked.
#include "gui/window_fixture.h"
#include "helpers/shapes.h"
#include "panels/findings_panel.h"
#include "plan/finding_kinds.h"
#include "timeline/timeline_bar.h"
#include "viewer/camera_control.h"

#include <QAction>
#include <QLabel>
#include <QListView>
#include <QPushButton>
#include <QTest>
#include <QToolButton>
#include <QWheelEvent>
#include <algorithm>
#include <vtkCamera.h>
#include <vtkRenderer.h>

namespace voluta::test {
namespace {

using project::Stage;

class FindingsTest : public WindowTest {
protected:
  panels::FindingsPanel* panel() { return find<panels::FindingsPanel>("findings"); }

  void clickFinding(int row) {
    auto* list = panel()->findChild<QListView*>("list");
    const QModelIndex index = list->model()->index(row, 0);
    ASSERT_TRUE(index.isValid());
    list->scrollTo(index);
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(index).center());
    QTest::qWait(20);
  }

  void openFlat(const geometry::TriangleMesh& part, const std::string& platform = {}) {
    openPart(writePart("part.stl", part));
    project::Choices choices = document().choices();
    choices.item().automatic = false;
    choices.item().mode = "flat";
    choices.item().parameters["supports"] = "none";
    if (!platform.empty()) {
      choices.item().platform = project::Platform(platform);
      choices.parameters["rimSupports"] = "none";
    }
    choices.formats = {"urscript"};
    document().setChoices(choices, "flat");
    clickToolBar("plan");
    ASSERT_TRUE(planned(Stage::Replay));
  }

  vtkCamera* camera() { return window().viewport().scene().renderer()->GetActiveCamera(); }
  Eigen::Vector3d eye() { return Eigen::Vector3d(camera()->GetPosition()); }
  double eyeDistance() { return camera()->GetDistance(); }
  // Is the place, in the fixed frame, within the viewport?
  bool isSeen(const Eigen::Vector3d& place) {
    viewer::Viewport& viewport = window().viewport();
    const Eigen::Vector3d at = viewer::CameraControl(viewport.scene().renderer()).project(place);
    return viewport.rect().contains(viewport.fromDisplay({at.x(), at.y()}).toPoint());
  }

  // Is the place in the picture, with nothing before it? Clipped and hidden geometry does not
  // count.
  scene::Between before(const Eigen::Vector3d& place) {
    const scene::Scene& scene = window().viewport().scene();
    return scene.between(place, scene.towardsEye(), 15.0, true);
  }
};

// A table: its top overhangs where flat layers begin it.
geometry::TriangleMesh table() {
  geometry::TriangleMesh whole = box({-4, -4, 0}, {4, 4, 12.5});
  const geometry::TriangleMesh top = box({-16, -4, 12}, {16, 4, 15});
  const int first = static_cast<int>(whole.vertices.size());
  whole.vertices.insert(whole.vertices.end(), top.vertices.begin(), top.vertices.end());
  for (const auto& t : top.triangles)
    whole.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  return whole;
}

TEST_F(FindingsTest, TheNozzleIsNeverBeforeThePlaceOfAFinding) {
  openFlat(table());
  const auto& findings = document().presentResult()->job.report.findings;
  const auto timed =
      std::ranges::find_if(findings, [](const plan::Finding& f) { return f.whenS && f.where; });
  ASSERT_NE(timed, findings.end());
  panel()->setFindings({*timed});
  for (const char* view : {"viewTop", "viewOblique", "viewFront"}) {
    SCOPED_TRACE(view);
    choosePage(Page::Simulate);
    find<QAction>(view)->trigger();
    clickFinding(0);
    EXPECT_EQ(page(), Page::Simulate);
    ASSERT_TRUE(window().viewport().view().marker);
    EXPECT_FALSE(before(*timed->where).machine());
    EXPECT_FALSE(before(*timed->where).printed);
    picture();
    keepPicture(window(), (std::string("finding-") + view + "").c_str());
  }
  const auto& roles = window().viewport().view().roles;
  EXPECT_TRUE(std::ranges::all_of(roles, [](bool shown) { return shown; }))
      << "the machine stays where the camera can go round it";
}

// The card above the findings says what a remedy has changed.
TEST_F(FindingsTest, ARemedyShowsBeforeAndAfterAndIsTakenBack) {
  openFlat(table(), "disc:60"); // on which supports can stand
  auto* list = panel()->findChild<QListView*>("list");
  auto* card = panel()->findChild<QWidget*>("effect");
  ASSERT_FALSE(card->isVisible());
  const auto planBefore = document().lastResult();
  const double airBefore = planBefore->job.report.replay.unsupportedFraction;
  ASSERT_GT(airBefore, 0.001);
  QPushButton* remedy = nullptr;
  for (int row = 0; row < list->model()->rowCount() && !remedy; ++row) {
    clickFinding(row);
    remedy = panel()->findChild<QPushButton*>("remedy_addSupports");
  }
  ASSERT_NE(remedy, nullptr);
  QTest::mouseClick(remedy, Qt::LeftButton);
  EXPECT_TRUE(card->isVisible());
  const auto lines = [&] { return panel()->findChild<QLabel*>("effectLines")->text(); };
  EXPECT_TRUE(lines().contains("when the plan is done")) << lines().toStdString();
  ASSERT_TRUE(planned(Stage::Replay));
  EXPECT_TRUE(lines().contains("Before:")) << lines().toStdString();
  const double airAfter = document().lastResult()->job.report.replay.unsupportedFraction;
  const auto percent = [](double share) {
    return QLocale().toString(100.0 * share, 'f', 1) + " %";
  };
  EXPECT_TRUE(
      lines().contains("Printed in the air: " + percent(airBefore) + " → " + percent(airAfter)))
      << lines().toStdString();
  EXPECT_LT(airAfter, airBefore);
  keepPicture(window(), "remedy-effect");
  QTest::mouseClick(panel()->findChild<QToolButton*>("effectUndo"), Qt::LeftButton);
  EXPECT_FALSE(card->isVisible());
  EXPECT_EQ(document().choices().item().parameters.at("supports"), "none");
  ASSERT_TRUE(planned(Stage::Replay)) << "the plan before is shown again";
  EXPECT_NEAR(document().lastResult()->job.report.replay.unsupportedFraction, airBefore, 1e-12);
}

TEST_F(FindingsTest, APlaceInsideThePartIsShownByACut) {
  openFlat(box({0, 0, 0}, {20, 20, 14}));
  plan::Finding inside = plan::verbatimFinding(Stage::Toolpath, "gouge", "inside the part", "");
  const Eigen::AlignedBox3d box = window().presenter().partBox();
  inside.where = box.center();
  panel()->setFindings({inside});
  clickFinding(0);
  // The layers above the place are not shown: it needs no cut.
  EXPECT_EQ(page(), Page::Layers);
  ASSERT_TRUE(window().viewport().view().marker);
  EXPECT_FALSE(before(box.center()).printed);
  picture();
  keepPicture(window(), "finding-inside");
  choosePage(Page::Prepare);
  plan::Finding wall = plan::verbatimFinding(Stage::Load, "thinPart", "inside the part", "");
  wall.where = box.center();
  panel()->setFindings({wall});
  clickFinding(0);
  EXPECT_EQ(page(), Page::Prepare);
  EXPECT_TRUE(window().viewport().view().sectionOn);
  keepPicture(window(), "finding-inside-prepare");
  choosePage(Page::Layers);
  EXPECT_FALSE(window().viewport().view().sectionOn) << "the cut goes with the mark";
}

TEST_F(FindingsTest, APlaceOnTheOutsideNeedsNoCut) {
  openFlat(box({0, 0, 0}, {20, 20, 14}));
  const Eigen::AlignedBox3d box = window().presenter().partBox();
  plan::Finding outside = plan::verbatimFinding(Stage::Load, "thinPart", "on its far side", "");
  // The camera looks from the front: it moves round the part.
  outside.where = Eigen::Vector3d(box.center().x(), box.max().y(), box.center().z());
  panel()->setFindings({outside});
  clickFinding(0);
  EXPECT_FALSE(window().viewport().view().sectionOn);
  EXPECT_FALSE(before(*outside.where).printed);
}

TEST_F(FindingsTest, ButtonsAreInSightOnASmallScreenInEveryLanguage) {
  openPart(writePart("tiny.stl", box({0, 0, 0}, {0.5, 0.4, 0.3})));
  for (const char* language : {"language_it", "language_en"}) {
    find<QAction>(language)->trigger();
    window().resize(853, 533);
    QTest::qWait(100);
    clickFinding(0);
    for (const char* name : {"remedy_unitsMetres", "remedy_unitsInches", "show"}) {
      const auto* button = panel()->findChild<QPushButton*>(name);
      ASSERT_NE(button, nullptr) << name;
      EXPECT_TRUE(waitFor([&] { return button->visibleRegion().contains(button->rect()); }, 1000))
          << language << " " << name;
      EXPECT_GE(button->width(), button->sizeHint().width()) << language << " " << name;
    }
    keepPicture(window(), (std::string("finding-small-") + language + "").c_str());
  }
}

TEST_F(FindingsTest, AnotherPlateIsSeenWholeUnlessTheCameraIsTheUsers) {
  openPart(writePart("part.stl", box({0, 0, 0}, {20, 20, 14})));
  const auto choose = [&](const char* platform) {
    project::Choices choices = document().choices();
    choices.item().platform = project::Platform(platform);
    choices.item().platformStays = choices.item().automatic;
    document().setChoices(choices, "platform");
    ASSERT_TRUE(planned(Stage::Load));
    QTest::qWait(50);
  };
  choose("disc:60");
  const double near = eyeDistance();
  choose("disc:240");
  EXPECT_GT(eyeDistance(), 1.2 * near) << "a larger plate needs room";
  for (const Eigen::Vector3d& rim : {Eigen::Vector3d(120, 0, 0), Eigen::Vector3d(-120, 0, 0),
                                     Eigen::Vector3d(0, 120, 0), Eigen::Vector3d(0, -120, 0)})
    EXPECT_TRUE(isSeen(rim)) << rim.transpose();
  keepPicture(window(), "plate-240");
  choose("disc:60");
  EXPECT_NEAR(eyeDistance(), near, 0.05 * near);

  viewer::Viewport& viewport = window().viewport();
  QWheelEvent wheel(viewport.rect().center(), viewport.mapToGlobal(viewport.rect().center()), {},
                    {0, 240}, Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
  QApplication::sendEvent(&viewport, &wheel);
  const Eigen::Vector3d users = eye();
  choose("disc:240");
  EXPECT_LT((eye() - users).norm(), 1e-6) << "the user has put the camera there";
}

TEST_F(FindingsTest, TheVolumeOnThePartTabFollowsTheScale) {
  openPart(writePart("part.stl", box({0, 0, 0}, {20, 20, 10}))); // 4 cm³
  const auto volume = [&] { return find<QLabel>("text")->text(); };
  EXPECT_TRUE(volume().contains(QString::fromUtf8("4.0 cm³"))) << volume().toStdString();
  document().setScale("2");
  ASSERT_TRUE(planned(Stage::Load));
  EXPECT_TRUE(volume().contains(QString::fromUtf8("32.0 cm³"))) << volume().toStdString();
}

} // namespace
} // namespace voluta::test
