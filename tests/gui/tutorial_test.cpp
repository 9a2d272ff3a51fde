// What the tutorials of the manual say is done in the window. The pictures of the manual are taken
// here (VOLUTA_TEST_PICTURES), for docs/pictures.
#include "gui/window_fixture.h"
#include "helpers/lathe_parts.h"
#include "helpers/made_solids.h"
#include "pipeline/plan_result.h"
#include "scene/view_state.h"

#include <QAction>
#include <QTest>
#include <QToolButton>

namespace voluta::test {
namespace {

using project::Stage;

class TutorialTest : public WindowTest {
protected:
  void SetUp() override {
    WindowTest::SetUp();
    window().resize(1280, 800);
  }
  void openSample(const char* action) {
    find<QAction>(action)->trigger();
    ASSERT_TRUE(waitFor([&] { return document().source() && document().sourceReady(); }));
  }
  void choose(const std::function<void(project::Choices&)>& change) {
    project::Choices choices = document().choices();
    choices.item().automatic = false;
    change(choices);
    document().setChoices(choices, "choices of the tutorial");
  }
  void planAndShow(Stage stage, const char* page, const char* subject = nullptr) {
    window().planning().plan(stage);
    ASSERT_TRUE(planned(stage));
    choosePage(page);
    if (subject)
      QTest::mouseClick(find<QToolButton>(subject), Qt::LeftButton);
    ASSERT_TRUE(waitFor([&] { return !window().presenter().busy(); }));
    picture(); // in full detail
  }
  void expectPassed() {
    const auto result = document().lastResult();
    ASSERT_NE(result, nullptr);
    EXPECT_TRUE(std::ranges::none_of(result->job.report.findings, [](const plan::Finding& finding) {
      return finding.blocking;
    }));
  }
};

TEST_F(TutorialTest, FlatLayers) {
  openSample("sampleAccuracyPlate");
  choose([](project::Choices& choices) { choices.item().mode = "flat"; });
  planAndShow(Stage::Replay, Page::Layers, "subject2");
  expectPassed();
  keepPicture(window(), "tutorial_flat");
}

TEST_F(TutorialTest, CurvedLayers) {
  openSample("sampleMushroom");
  choose([](project::Choices& choices) { choices.item().mode = "curved"; });
  planAndShow(Stage::Layers, Page::Layers, "subject2");
  keepPicture(window(), "tutorial_curved");
}

TEST_F(TutorialTest, PlanarPieces) {
  openSample("sampleFork");
  choose([](project::Choices& choices) { choices.item().mode = "planar"; });
  planAndShow(Stage::Layers, Page::Layers, "subject4");
  keepPicture(window(), "tutorial_planar");
}

TEST_F(TutorialTest, AroundARod) {
  geometry::TriangleMesh tube = revolved({{-8, kBore}, {-8, 3.5}, {8, 3.5}, {8, kBore}}, 128);
  for (Eigen::Vector3d& v : tube.vertices)
    v = Eigen::Vector3d(v.y(), v.z(), v.x());
  openPart(writePart("tube.stl", tube));
  choose([](project::Choices& choices) {
    choices.item().mode = "lathe";
    choices.cell = "lathe";
    choices.item().platform = project::Platform("rod:5x200");
    choices.tool().process = "fdm-0.35";
  });
  planAndShow(Stage::Toolpath, Page::Layers);
  keepPicture(window(), "tutorial_lathe");
}

TEST_F(TutorialTest, OnABody) {
  openSample("sampleCurvedBar");
  planAndShow(Stage::Layers, Page::Layers, "subject1");
  keepPicture(window(), "tutorial_substrate");
}

} // namespace
} // namespace voluta::test
