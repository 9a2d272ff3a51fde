// Anything done at random with a planned job of each mode; nothing breaks. ctest takes some hundred
// steps, the same each time; VOLUTA_MONKEY_SECONDS=1800 runs for half an hour, best in the asan
// build, and VOLUTA_MONKEY_SEED begins with others.
#include "gui/monkey.h"
#include "gui/planned_jobs.h"
#include "gui/rebuild_watch.h"
#include "helpers/shapes.h"
#include "timeline/layer_range_slider.h"
#include "timeline/timeline_bar.h"
#include "window/language.h"
#include "window/window_theme.h"

#include <QElapsedTimer>
#include <QFile>
#include <QTest>
#include <QUndoStack>

namespace voluta::test {
namespace {

constexpr int kSteps = 150, kModes = 5;
constexpr int kSeed = 20240601;

class MonkeyTest : public PlannedJobTest {
protected:
  void SetUp() override {
    QApplication::setQuitOnLastWindowClosed(false);
    PlannedJobTest::SetUp();
  }
  void TearDown() override {
    PlannedJobTest::TearDown();
    QApplication::setQuitOnLastWindowClosed(true);
    window::chooseLanguage("en"); // it may have found another
    window::applyAppearance(application(), window::Appearance::Light);
  }
  // The job as a file, so that it can be opened again after any action.
  void saveJob() {
    answerFileDialog(path("job.voluta"));
    clickMenu("fileMenu", "saveAs");
    ASSERT_TRUE(waitFor([&] { return !document().dirty(); }, 20000));
  }
  void startAgain() {
    openWindow();
    window().open(path("job.voluta"));
  }
  void expectSound() {
    const auto* layers = window().findChild<timeline::LayerRangeSlider*>("layerSlider");
    EXPECT_LE(layers->first(), layers->last());
    EXPECT_LT(layers->last(), std::max(1, layers->layerCount()));
    const auto* bar = window().findChild<timeline::TimelineBar*>("timeline");
    EXPECT_LE(bar->step(), bar->stepCount());
    const scene::ViewState& view = window().viewport().view();
    EXPECT_TRUE(view.sectionOrigin.allFinite());
    EXPECT_TRUE(document().choices().item().placement.rotation.coeffs().allFinite());
  }
};

TEST_P(MonkeyTest, BreaksNothing) {
  const int seconds = qEnvironmentVariableIntValue("VOLUTA_MONKEY_SECONDS") / kModes;
  const int seed = qEnvironmentVariableIsSet("VOLUTA_MONKEY_SEED")
                       ? qEnvironmentVariableIntValue("VOLUTA_MONKEY_SEED")
                       : kSeed;
  planJob(GetParam());
  saveJob();
  QFile none(path("none.stl"));
  ASSERT_TRUE(none.open(QIODevice::WriteOnly));
  none.write("this is no mesh");
  none.close();
  const QString other = writePart("other.stl", box({0, 0, 0}, {8, 6, 4}));
  Monkey monkey(
      [this] { return &window(); }, static_cast<unsigned>(seed),
      {{path("job.voluta"), path("job.voluta"), other, path("none.stl"), path("gone.stl")},
       folder_.path()});
  RebuildWatch watch;
  QElapsedTimer clock;
  clock.start();
  const auto enough = [&] {
    return seconds > 0 ? clock.elapsed() >= 1000LL * seconds : monkey.steps() >= kSteps;
  };
  monkey.run(enough, [&] {
    if (!window().isVisible())
      startAgain(); // Quit was found
    watch.watchAll();
    expectSound();
  });
  if (HasFailure())
    ADD_FAILURE() << "seed " << seed << "\n" << Monkey::lastSteps().toStdString();
  // Still sound: a part opens and is planned.
  openWindow();
  openPart(other);
  window().planning().plan(project::Stage::Layers);
  EXPECT_TRUE(planned(project::Stage::Layers));
}

INSTANTIATE_TEST_SUITE_P(Modes, MonkeyTest, everyMode(), modeOf);

} // namespace
} // namespace voluta::test
