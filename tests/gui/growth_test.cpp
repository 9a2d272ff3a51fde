// Growth in the viewport: replayed by the bar, coloured, with its front; spacing and missed voxels.
#include "gui/window_fixture.h"
#include "helpers/shapes.h"
#include "panels/findings_panel.h"
#include "timeline/layer_range_slider.h"
#include "timeline/timeline_bar.h"
#include "window/spacing_view.h"

#include <QCheckBox>
#include <QComboBox>
#include <QListView>
#include <QTest>
#include <QToolButton>

namespace voluta::test {
namespace {

using project::Stage;

class GrowthTest : public WindowTest {
protected:
  void planLayers(const geometry::TriangleMesh& mesh) {
    openPart(writePart("part.stl", mesh));
    clickMenu("runMenu", "planLayers");
    ASSERT_TRUE(planned(Stage::Layers));
  }
  void show(const char* subject) {
    QTest::mouseClick(find<QToolButton>(subject), Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return !window().presenter().busy(); }));
  }
  // By the keyboard: the list is open while it is chosen from.
  void colourBy(scene::ColourBy wanted) {
    auto* combo = find<QComboBox>("colourBy");
    combo->setFocus();
    combo->showPopup();
    const int row = combo->findData(static_cast<int>(wanted));
    ASSERT_TRUE(combo->model()->flags(combo->model()->index(row, 0)) & Qt::ItemIsEnabled);
    QWidget* list = combo->view();
    combo->view()->setCurrentIndex(combo->model()->index(row, 0));
    QTest::keyClick(list, Qt::Key_Return);
    ASSERT_TRUE(waitFor([&] { return !window().presenter().busy(); }));
    EXPECT_EQ(combo->currentIndex(), row);
  }
  const scene::ViewState& view() { return window().viewport().view(); }
  std::string legendTitle() { return base::english(window().viewport().scene().legend().title); }
  timeline::TimelineBar& bar() { return *find<timeline::TimelineBar>("timeline"); }

  // Pixels in the colour of the step being printed, whatever the light.
  static int pinkPixels(const QImage& image) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) {
        const QColor c(image.pixel(x, y));
        count += c.red() > c.green() + 70 && c.blue() > c.green() + 40;
      }
    return count;
  }
};

TEST_F(GrowthTest, TheBarReplaysStepsWithTheirFront) {
  planLayers(box({0, 0, 0}, {14, 14, 16}));
  EXPECT_EQ(bar().mode(), timeline::BarMode::Moves);
  show("subject1");
  ASSERT_EQ(bar().mode(), timeline::BarMode::Steps);
  const int steps = bar().stepCount();
  ASSERT_GT(steps, 12);
  EXPECT_EQ(bar().step(), steps);
  EXPECT_FALSE(view().growthStep) << "nothing is replayed yet";
  auto* layers = find<timeline::LayerRangeSlider>("layerSlider");
  EXPECT_TRUE(layers->isEnabled());
  const QImage whole = picture();
  EXPECT_EQ(pinkPixels(whole), 0);

  bar().setFocus();
  QTest::keyClick(&bar(), Qt::Key_Home);
  ASSERT_TRUE(view().growthStep);
  EXPECT_EQ(*view().growthStep, 0);
  EXPECT_FALSE(layers->isEnabled());
  QTest::keyClick(&bar(), Qt::Key_Right);
  EXPECT_EQ(*view().growthStep, 1);
  QTest::keyClick(&bar(), Qt::Key_Right, Qt::ControlModifier);
  EXPECT_EQ(*view().growthStep, 11);
  ASSERT_TRUE(waitFor([&] { return !window().presenter().busy(); }));
  const QImage grown = picture();
  EXPECT_GT(pinkPixels(grown), 300) << "the step being laid";
  EXPECT_GT(differingShare(whole, grown), 0.02);

  QTest::mouseClick(find<QCheckBox>("front"), Qt::LeftButton, {}, {8, 8});
  EXPECT_FALSE(view().front);
  const QImage bare = picture();
  EXPECT_GT(differingShare(grown, bare), 0.002) << "the front is gone";
  QTest::mouseClick(find<QCheckBox>("ghosts"), Qt::LeftButton, {}, {8, 8});
  EXPECT_GT(differingShare(bare, picture()), 0.01) << "what is to come";

  QTest::keyClick(&bar(), Qt::Key_Left);
  EXPECT_EQ(*view().growthStep, 10);
  bar().setSpeed(5);
  QTest::keyClick(&bar(), Qt::Key_Space);
  EXPECT_TRUE(bar().playing());
  ASSERT_TRUE(waitFor([&] { return bar().step() == steps; }, 20000));
  EXPECT_FALSE(bar().playing());
  EXPECT_FALSE(view().growthStep) << "grown: layers again";
  EXPECT_TRUE(layers->isEnabled());

  show("subject2");
  EXPECT_EQ(bar().mode(), timeline::BarMode::Moves);
}

TEST_F(GrowthTest, VoxelsAreColouredByLayerStepOrPeeling) {
  planLayers(box({0, 0, 0}, {14, 14, 16}));
  show("subject1");
  EXPECT_EQ(legendTitle(), "Layer");
  const QImage byLayer = picture();
  colourBy(scene::ColourBy::GrowthStep);
  EXPECT_EQ(legendTitle(), "Growth step");
  colourBy(scene::ColourBy::Peeling);
  ASSERT_TRUE(waitFor([&] { return legendTitle() == "Peeling rank"; }));
  EXPECT_GT(differingShare(byLayer, picture()), 0.01);
  auto* combo = find<QComboBox>("colourBy");
  const auto speed =
      combo->model()->index(combo->findData(static_cast<int>(scene::ColourBy::Speed)), 0);
  EXPECT_FALSE(combo->model()->flags(speed) & Qt::ItemIsEnabled) << "voxels have no speed";
}

TEST_F(GrowthTest, LayerSpacingIsAMapAndAHistogramWithWords) {
  planLayers(box({0, 0, 0}, {14, 14, 16}));
  show("subject2");
  const QImage byLayer = picture();
  colourBy(scene::ColourBy::Spacing);
  EXPECT_EQ(legendTitle(), "Layer spacing");
  EXPECT_GT(differingShare(byLayer, picture()), 0.01);
  auto* spacing = find<window::SpacingView>("layerSpacing");
  ASSERT_TRUE(waitFor([&] { return spacing->isVisible(); }));
  EXPECT_TRUE(spacing->words().startsWith("Mean 0.8")) << spacing->words().toStdString();
  EXPECT_TRUE(spacing->words().contains("Within 0.40–1.00 mm: 100 %"))
      << spacing->words().toStdString();
}

TEST_F(GrowthTest, AFindingOfMissedVoxelsFliesThereAndLooksThroughTheRest) {
  geometry::TriangleMesh mesh = box({0, 0, 0}, {14, 14, 10});
  const geometry::TriangleMesh afloat = box({4, 4, 16}, {9, 9, 20}); // nothing leads there
  const int first = static_cast<int>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), afloat.vertices.begin(), afloat.vertices.end());
  for (const auto& t : afloat.triangles)
    mesh.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  project::Choices alone = document().choices();
  alone.item().parameters["supports"] = "none";
  document().setChoices(alone, "supports");
  planLayers(mesh);
  ASSERT_GT(window().presenter().voxels().missed(), 0u);
  auto* panel = find<panels::FindingsPanel>("findings");
  auto* list = panel->findChild<QListView*>();
  ASSERT_GT(list->model()->rowCount(), 0);
  const QImage before = picture();
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                    list->visualRect(list->model()->index(0, 0)).center());
  EXPECT_EQ(page(), Page::Layers);
  EXPECT_TRUE(view().voxels);
  EXPECT_TRUE(view().seeThrough);
  ASSERT_TRUE(view().marker);
  EXPECT_GT(view().marker->z(), 14.0);
  EXPECT_GT(differingShare(before, picture()), 0.05);
  auto* layers = find<timeline::LayerRangeSlider>("layerSlider");
  layers->setFocus();
  QTest::keyClick(layers, Qt::Key_Down);
  EXPECT_FALSE(view().seeThrough) << "something else was asked for";
}

} // namespace
} // namespace voluta::test
