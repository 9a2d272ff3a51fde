// What is put into a part, and surfaces that are painted, in the window.
#include "gui/regions_fixture.h"

namespace voluta::test {
namespace {

// The part leaves room for it, the print pauses, and the layers show it in its place.
TEST_F(RegionsWindowTest, AnInsertIsGivenByClicksPlannedAndShown) {
  openFlat(open(block()));
  openTool();
  add("box");
  chooseUse("insert");
  EXPECT_EQ(regions()[0].use, "insert:0");
  EXPECT_FALSE(panel()->findChild<QWidget*>("region.infillDensity")->isVisible());
  EXPECT_TRUE(problem().isEmpty()) << problem().toStdString();
  ASSERT_TRUE(bodiesDrawn());
  picture();
  keepPicture(window(), "regions_insert");
  clickToolBar("plan");
  ASSERT_TRUE(planned(Stage::Replay));
  ASSERT_EQ(document().lastResult()->job.toolPlan->inserts.size(), 1u);
  const int layer = document().lastResult()->job.toolPlan->inserts[0].layer;
  choosePage(Page::Layers);
  auto* layers = find<timeline::LayerRangeSlider>("layerSlider");
  EXPECT_EQ(layers->events(), std::vector{layer}) << "the slider marks it";
  layers->setRange(0, layer - 2);
  const QImage open = picture();
  layers->setRange(0, layer - 1);
  picture();
  keepPicture(window(), "regions_insert_in");
  EXPECT_GT(differingShare(open, picture()), 0.002);
}

// "Print this face smooth": its layers are there soon after the stroke.
TEST_F(RegionsWindowTest, LayersGrowWhileTheBrushRests) {
  openFlat(open(block()));
  openTool();
  add("painted");
  ASSERT_TRUE(bodiesDrawn());
  auto* grows = find<QCheckBox>("regionPaintGrows");
  EXPECT_FALSE(grows->isVisible()) << "it has no layers of its own";
  chooseUse("surface");
  EXPECT_TRUE(grows->isVisible());
  const auto paintWith = [&](int choice) {
    auto* with = find<QComboBox>("regionPaintWith");
    with->setCurrentIndex(choice);
    emit with->activated(choice);
  };
  paintWith(1); // whole faces
  viewport().viewFrom(Eigen::Vector3d(0.3, -0.5, 1).normalized());
  picture();
  const viewer::CameraControl camera(viewport().scene().renderer());
  const auto paint = [&](double x) {
    const Eigen::Vector3d display = camera.project({x, 0.0, 12.0});
    QTest::mouseClick(&viewport(), Qt::LeftButton, {},
                      viewport().fromDisplay({display.x(), display.y()}).toPoint());
  };
  paint(2.0);
  ASSERT_TRUE(planned(Stage::Layers));
  EXPECT_TRUE(panel()->isVisible()) << "the page stays";
  keepPicture(window(), "regions_grown");
  ASSERT_EQ(document().lastResult()->job.report.item().layers.regions.size(), 1u);
  EXPECT_EQ(*document().lastResult()->job.reached, Stage::Layers);
  // Switched off, nothing is planned.
  grows->setChecked(false);
  document().undoStack()->undo();
  ASSERT_TRUE(bodiesDrawn());
  paintWith(0); // a brush
  paint(2.0);
  ASSERT_TRUE(waitFor([&] { return regions()[0].mesh != nullptr; }, 20000));
  QTest::qWait(2000);
  EXPECT_FALSE(document().upToDate(Stage::Layers));
}

TEST_F(RegionsWindowTest, ASurfaceIsPaintedStrokeByStroke) {
  openFlat(open(block()));
  openTool();
  add("painted");
  EXPECT_TRUE(problem().contains("nothing is painted", Qt::CaseInsensitive));
  ASSERT_TRUE(bodiesDrawn());
  ASSERT_EQ(viewport().tool(), viewer::Tool::Paint);
  EXPECT_TRUE(find<QAction>("plan")->isEnabled()) << "the region has no effect yet";
  viewport().viewFrom(Eigen::Vector3d(0.3, -0.5, 1).normalized());
  picture();
  const viewer::CameraControl camera(viewport().scene().renderer());
  const auto at = [&](double x, double y) {
    const Eigen::Vector3d display = camera.project({x, y, 12.0});
    return viewport().fromDisplay({display.x(), display.y()}).toPoint();
  };
  const auto area = [&] { return regions()[0].mesh ? geometry::area(*regions()[0].mesh) : 0.0; };
  const auto stroke = [&](Qt::KeyboardModifiers keys) {
    const int before = document().undoStack()->index();
    QTest::mousePress(&viewport(), Qt::LeftButton, keys, at(-5, 0));
    for (int x = -4; x <= 5; ++x) // as densely as a hand's
      QTest::mouseMove(&viewport(), at(x, 0));
    QTest::mouseRelease(&viewport(), Qt::LeftButton, keys, at(5, 0));
    EXPECT_TRUE(waitFor([&] { return document().undoStack()->index() != before; }, 20000));
  };
  stroke({});
  ASSERT_TRUE(regions()[0].mesh);
  EXPECT_NEAR(area(), 28.3 + 10 * 6, 14.0) << "a disc of 6 mm along 10 mm";
  EXPECT_EQ(document().undoStack()->undoText(), "Paint region");
  EXPECT_TRUE(problem().isEmpty()) << problem().toStdString();
  picture();
  keepPicture(window(), "regions_painted");
  // A smaller eraser.
  type(find<QDoubleSpinBox>("regionPaintSize"), "1");
  const double painted = area();
  stroke(Qt::ShiftModifier);
  EXPECT_LT(area(), painted - 10.0);
  EXPECT_GT(area(), 20.0);
  document().undoStack()->undo();
  EXPECT_NEAR(area(), painted, 1e-9);
  // A hand that is faster than the events paints the line between them.
  document().undoStack()->undo();
  EXPECT_EQ(area(), 0.0);
  type(find<QDoubleSpinBox>("regionPaintSize"), "3");
  const int index = document().undoStack()->index();
  QTest::mousePress(&viewport(), Qt::LeftButton, {}, at(-5, 0));
  QTest::mouseMove(&viewport(), at(5, 0));
  QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, at(5, 0));
  ASSERT_TRUE(waitFor([&] { return document().undoStack()->index() != index; }, 20000));
  EXPECT_NEAR(area(), 28.3 + 10 * 6, 6.0);
  picture();
  keepPicture(window(), "regions_fast_stroke");
  auto* with = find<QComboBox>("regionPaintWith");
  with->setCurrentIndex(1);
  emit with->activated(1);
  stroke({});
  EXPECT_NEAR(area(), 24 * 24, 1e-6) << "the whole upper side, once";
  // Beside the part the mouse moves the camera.
  const Eigen::Vector3d eye = viewport().scene().towardsEye();
  const QPoint beside = at(-20, 0);
  QTest::mousePress(&viewport(), Qt::LeftButton, {}, beside);
  QTest::mouseMove(&viewport(), beside + QPoint(-30, 0));
  QTest::mouseMove(&viewport(), beside + QPoint(-60, 0));
  QTest::mouseRelease(&viewport(), Qt::LeftButton, {}, beside + QPoint(-60, 0));
  EXPECT_GT((viewport().scene().towardsEye() - eye).norm(), 0.01);
  ASSERT_TRUE(settled());
}

TEST_F(RegionsWindowTest, ARectanglePaintsWhatIsSeenInIt) {
  openFlat(open(block()));
  openTool();
  add("painted");
  ASSERT_TRUE(bodiesDrawn());
  viewport().viewFrom(Eigen::Vector3d(0.0, -0.02, 1.0).normalized());
  picture();
  auto* with = find<QComboBox>("regionPaintWith");
  with->setCurrentIndex(2);
  emit with->activated(2);
  EXPECT_FALSE(find<QDoubleSpinBox>("regionPaintSize")->isVisible());
  const viewer::CameraControl camera(viewport().scene().renderer());
  const Eigen::Vector3d top(0.0, 0.0, 12.0), display = camera.project(top);
  const QPoint middle = viewport().fromDisplay({display.x(), display.y()}).toPoint();
  const double mm = viewport().mmPerPoint(top);
  const auto area = [&] { return regions()[0].mesh ? geometry::area(*regions()[0].mesh) : 0.0; };
  const auto drag = [&](const QPoint& from, const QPoint& to, Qt::MouseButton button) {
    const int before = document().undoStack()->index();
    QTest::mousePress(&viewport(), button, {}, middle + from);
    QTest::mouseMove(&viewport(), middle + (from + to) / 2);
    QTest::mouseMove(&viewport(), middle + to);
    picture();
    keepPicture(window(), "regions_rectangle");
    QTest::mouseRelease(&viewport(), button, {}, middle + to);
    ASSERT_TRUE(waitFor([&] { return document().undoStack()->index() != before; }, 20000));
  };
  drag({-60, -40}, {60, 40}, Qt::LeftButton);
  const double painted = 120 * 80 * mm * mm;
  EXPECT_NEAR(area(), painted, 0.05 * painted);
  for (const Eigen::Vector3d& v : regions()[0].mesh->vertices)
    EXPECT_NEAR(v.z(), 12.0, 1e-6) << "hidden sides are not painted";
  drag({0, -60}, {80, 60}, Qt::RightButton);
  EXPECT_NEAR(area(), 0.5 * painted, 0.05 * painted);
  picture();
  keepPicture(window(), "regions_rectangle_erased");
}

} // namespace
} // namespace voluta::test
