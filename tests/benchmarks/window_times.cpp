// Times of the window with a project or a part of one's own, on a quiet machine:
// VOLUTA_GUI_JOB=FILE VOLUTA_GUI_PART=MESH xvfb-run -a bin/window_times [--gtest_filter=*Sliders]
#include "base/units.h"
#include "curved/front_surface.h"
#include "curved/peeling_field.h"
#include "gui/window_fixture.h"
#include "pipeline/stage_options.h"
#include "timeline/layer_range_slider.h"
#include "timeline/timeline_bar.h"

#include <QCheckBox>
#include <QComboBox>
#include <QElapsedTimer>
#include <QListView>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>
#include <algorithm>
#include <ctime>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <sstream>
#include <unistd.h>
#include <vector>

namespace voluta::test {
namespace {

using project::Stage;

class WindowTimes : public WindowTest {
protected:
  timeline::TimelineBar& bar() { return *find<timeline::TimelineBar>("timeline"); }
  void setPlatform(const char* platform) {
    project::Choices choices = document().choices();
    choices.item().platform = project::Platform(platform);
    document().setChoices(choices, "platform");
  }
  // Drags from one place of a slider to another and prints the times of the frames; those of the
  // press itself are left out.
  void drag(QWidget* slider, QPoint from, QPoint to, const char* what) {
    constexpr int kSteps = 60;
    std::vector<double> frames;
    double stretch = 0.0;
    QTest::mousePress(slider, Qt::LeftButton, {}, from);
    for (int i = 1; i <= kSteps; ++i) {
      application().resetWatch();
      QTest::mouseMove(slider, from + (to - from) * i / kSteps);
      QTest::qWait(1);
      stretch = std::max(stretch, application().longestMs());
      if (application().longestFrameMs() > 0.0)
        frames.push_back(application().longestFrameMs());
    }
    QTest::mouseRelease(slider, Qt::LeftButton, {}, to);
    QTest::qWait(300);
    ASSERT_FALSE(frames.empty());
    const double first = frames.front();
    std::sort(frames.begin(), frames.end());
    std::cout << what << ": " << frames.size() << " frames, median " << frames[frames.size() / 2]
              << " ms, longest " << frames.back() << " ms, the first " << first
              << " ms; longest stretch beside frames " << stretch << " ms\n";
  }
};

// VOLUTA_GUI_JOB: with voxels.
TEST_F(WindowTimes, GrowthSteps) {
  const QString job = qEnvironmentVariable("VOLUTA_GUI_JOB");
  if (job.isEmpty())
    GTEST_SKIP() << "VOLUTA_GUI_JOB names no project";
  window().resize(1280, 800);
  window().open(job);
  ASSERT_TRUE(
      waitFor([&] { return window().presenter().hasVoxels() && !window().presenter().busy(); }));
  const auto d = document().result(Stage::Decompose)->job.item().decomposition();
  const auto timed = [&](const char* what, auto work) {
    QElapsedTimer timer;
    timer.start();
    work();
    std::cout << what << ": " << timer.nsecsElapsed() / 1e6 << " ms\n";
  };
  const std::int32_t highest = *std::max_element(d->rank.begin(), d->rank.end());
  for (const int share : {1, 2, 3, 4})
    timed("front", [&] { curved::frontSurface(*d, highest * share / 4); });
  timed("peeling field", [&] { curved::peelingField(*d, {}); });
  timed("drawing by steps", [&] { scene::drawVoxels(*d, {.bySteps = true}); });

  choosePage(Page::Layers);
  application().resetWatch();
  QTest::mouseClick(find<QToolButton>("subject1"), Qt::LeftButton);
  ASSERT_TRUE(waitFor([&] { return !window().presenter().busy(); }));
  auto* colours = find<QComboBox>("colourBy");
  colours->setFocus();
  colours->showPopup();
  colours->view()->setCurrentIndex(
      colours->model()->index(colours->findData(static_cast<int>(scene::ColourBy::Peeling)), 0));
  QTest::keyClick(colours->view(), Qt::Key_Return);
  ASSERT_TRUE(waitFor([&] { return !window().presenter().busy(); }));
  std::cout << "voxels on show, coloured anew: longest stretch " << application().longestMs()
            << " ms (" << application().longestWhat().toStdString() << ")\n";
  picture();
  auto* slider = bar().findChild<QWidget*>("scrubSlider");
  const QPoint end(slider->width() - 8, slider->height() / 2), begin(8, slider->height() / 2);
  drag(slider, end, begin, "growth slider with the front");
  bar().setStep(bar().stepCount());
  QTest::mouseClick(find<QCheckBox>("ghosts"), Qt::LeftButton, {}, {8, 8});
  picture();
  drag(slider, end, begin, "with later voxels too");
}

// Whole frames while sliders are dragged. VOLUTA_GUI_JOB: planned as far as the motion.
TEST_F(WindowTimes, Sliders) {
  const QString job = qEnvironmentVariable("VOLUTA_GUI_JOB");
  if (job.isEmpty())
    GTEST_SKIP() << "VOLUTA_GUI_JOB names no project";
  window().resize(1280, 800);
  window().open(job);
  ASSERT_TRUE(waitFor([&] {
    return window().presenter().hasPaths() && window().presenter().clock() &&
           !window().presenter().busy();
  }));
  choosePage(Page::Layers);
  picture();
  auto* layers = find<timeline::LayerRangeSlider>("layerSlider");
  const QPoint top(layers->width() - 17, 28);
  drag(layers, top, top + QPoint(0, layers->height() / 2), "layer slider");
  auto* moves = bar().findChild<QWidget*>("scrubSlider");
  ASSERT_NE(moves, nullptr);
  drag(moves, QPoint(moves->width() - 8, moves->height() / 2),
       QPoint(moves->width() / 4, moves->height() / 2), "move slider");
  choosePage(Page::Simulate);
  picture();
  drag(moves, QPoint(8, moves->height() / 2), QPoint(moves->width() - 8, moves->height() / 2),
       "time-line with the robot");
}

// VOLUTA_GUI_PART: a mesh; VOLUTA_GUI_VOXEL_MM: the voxel width.
TEST_F(WindowTimes, FromTheEditToThePicture) {
  const QString part = qEnvironmentVariable("VOLUTA_GUI_PART");
  if (part.isEmpty())
    GTEST_SKIP() << "VOLUTA_GUI_PART names no mesh";
  window().resize(1280, 800);
  document().setParameter("voxelMm", qEnvironmentVariable("VOLUTA_GUI_VOXEL_MM", "1"));
  openPart(part);
  clickMenu("runMenu", "planLayers");
  ASSERT_TRUE(waitFor([&] { return document().upToDate(Stage::Layers); }, 600000));
  ASSERT_TRUE(planned(Stage::Layers));
  choosePage(Page::Prepare);
  picture();
  const auto measure = [&](const std::string& what, const std::function<void()>& edit) {
    QElapsedTimer clock;
    qint64 edited = 0, ranks = -1, drawn = -1, shown = -1;
    int previews = 0;
    QObject context;
    QObject::connect(&document(), &document::Document::previewChanged, &context, [&] {
      previews += document().preview().has_value();
      if (ranks < 0 && document().preview())
        ranks = clock.elapsed();
    });
    QObject::connect(&window().presenter(), &window::Presenter::voxelsDrawn, &context, [&] {
      if (ranks >= 0 && drawn < 0)
        drawn = clock.elapsed();
    });
    QObject::connect(&window().viewport(), &viewer::VtkView::framePainted, &context, [&] {
      if (drawn >= 0 && shown < 0)
        shown = clock.elapsed();
    });
    application().resetWatch();
    clock.start();
    edit();
    edited = clock.elapsed();
    ASSERT_TRUE(waitFor([&] { return shown >= 0; }, 120000)) << what;
    const double stretch = application().longestMs();
    const std::string stretchWhat = application().longestWhat().toStdString();
    ASSERT_TRUE(waitFor([&] { return document().upToDate(Stage::Decompose); }, 600000));
    std::cout << what << ": edit " << edited << " ms, ranks known " << ranks << " ms, drawn "
              << drawn << " ms, on the screen " << shown << " ms, the field done "
              << clock.elapsed() << " ms after " << previews << " previews; longest stretch "
              << stretch << " ms (" << stretchWhat << "), later " << application().longestMs()
              << " ms\n";
  };
  auto* growth = find<QComboBox>("growth");
  growth->setFocus();
  measure("growth reverse", [&] { QTest::keyClick(growth, Qt::Key_Down); });
  measure("growth guided", [&] { QTest::keyClick(growth, Qt::Key_Down); });
  measure("growth greedy", [&] { QTest::keyClick(growth, Qt::Key_End); });
  measure("growth automatic", [&] { QTest::keyClick(growth, Qt::Key_Home); });
  measure("platform disc:120", [&] { setPlatform("disc:120"); });
  measure("platform disc:121", [&] { setPlatform("disc:121"); });
  measure("voxel width 2 % more", [&] {
    const double width = pipeline::parameterValues(document().choices()).number("voxelMm");
    document().setParameter("voxelMm", QString::number(1.02 * width));
  });
  measure("turned by 90 degrees", [&] {
    geometry::Placement turned = document().choices().item().placement;
    turned.rotation =
        Eigen::AngleAxisd(0.5 * base::kPi, Eigen::Vector3d::UnitZ()) * turned.rotation;
    document().place(turned, "turn");
  });
}

// The longest stretches of work of the window's thread, for each action. VOLUTA_GUI_PART: a mesh.
class LongestWork : public WindowTimes {
protected:
  void after(const char* what, const std::function<void()>& action) {
    application().resetWatch();
    action();
    QTest::qWait(400);
    waitFor([&] { return !window().presenter().busy(); }, 600000);
    std::cout << std::setw(6) << std::fixed << std::setprecision(1) << application().longestWorkMs()
              << " ms of work, " << std::setw(6) << application().longestMs()
              << " ms beside frames: " << what << " (" << application().longestWork().toStdString()
              << "; " << application().longestWhat().toStdString() << ")" << std::endl;
  }
  void allPages(const std::string& of) {
    for (const char* page :
         {Page::Layers, Page::Simulate, Page::Export, Page::Compare, Page::Prepare})
      after((of + ": page " + page).c_str(), [&] { choosePage(page); });
  }
  void sweep(QWidget* slider, QPoint from, QPoint to) {
    QTest::mousePress(slider, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 20; ++i) {
      QTest::mouseMove(slider, from + (to - from) * i / 20);
      QTest::qWait(5);
    }
    QTest::mouseRelease(slider, Qt::LeftButton, {}, to);
  }
  void plan(const std::string& of) {
    after((of + ": plan").c_str(), [&] {
      window().planning().plan(Stage::Replay);
      waitFor([&] { return planned(Stage::Replay) || !window().planning().running(); }, 1800000);
    });
    allPages(of);
    choosePage(Page::Layers);
    QTest::qWait(500);
    after((of + ": Layers slider").c_str(), [&] {
      auto* layers = find<timeline::LayerRangeSlider>("layerSlider");
      const QPoint top(layers->width() - 17, 28);
      sweep(layers, top, top + QPoint(0, layers->height() / 2));
    });
    choosePage(Page::Simulate);
    QTest::qWait(500);
    after((of + ": Simulate slider").c_str(), [&] {
      auto* moves = bar().findChild<QWidget*>("scrubSlider");
      sweep(moves, {8, moves->height() / 2}, {moves->width() - 8, moves->height() / 2});
    });
    after((of + ": jog").c_str(), [&] {
      auto* box = find<QCheckBox>("jogArm");
      box->setChecked(true);
      QTest::qWait(1000);
      for (int i = 0; i < 5; ++i) {
        QTest::mouseClick(find<QToolButton>("jogMoreZ"), Qt::LeftButton);
        QTest::qWait(50);
      }
      box->setChecked(false);
    });
    choosePage(Page::Export);
    after((of + ": undo and redo").c_str(), [&] {
      document().undoStack()->undo();
      QTest::qWait(500);
      document().undoStack()->redo();
    });
  }
};

TEST_F(LongestWork, OfEveryPageAndMode) {
  const QString part = qEnvironmentVariable("VOLUTA_GUI_PART");
  if (part.isEmpty())
    GTEST_SKIP() << "VOLUTA_GUI_PART names no mesh";
  window().resize(1280, 800);
  document().setParameter("voxelMm", qEnvironmentVariable("VOLUTA_GUI_VOXEL_MM", "1"));
  after("open the mesh", [&] { openPart(part); });
  allPages("before a plan");
  chooseFlat();
  plan("flat");
  after("a copy beside it", [&] {
    document().duplicatePart();
    QTest::qWait(500);
  });
  allPages("two parts");
}

// From the process's start to the first frame; run it alone.
TEST_F(WindowTimes, Start) {
  std::ifstream file("/proc/self/stat");
  std::string text((std::istreambuf_iterator<char>(file)), {});
  std::istringstream fields(text.substr(text.rfind(')') + 2));
  std::string field;
  for (int i = 3; i <= 22; ++i)
    fields >> field;
  bool painted = false;
  const auto connection = QObject::connect(&window().viewport(), &viewer::VtkView::framePainted,
                                           &window(), [&] { painted = true; });
  waitFor([&] { return painted || window().viewport().lastFrameMs() > 0.0; });
  QObject::disconnect(connection);
  timespec now{};
  clock_gettime(CLOCK_BOOTTIME, &now);
  const double seconds = static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec) -
                         std::stod(field) / static_cast<double>(sysconf(_SC_CLK_TCK));
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  std::cout << "first frame " << 1e3 * seconds << " ms after the start, processor "
            << 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec)
            << " ms\n";
}

// VOLUTA_GUI_PART: a mesh.
TEST_F(WindowTimes, Opening) {
  const QString part = qEnvironmentVariable("VOLUTA_GUI_PART");
  if (part.isEmpty())
    GTEST_SKIP() << "VOLUTA_GUI_PART names no mesh";
  QTest::qWait(1000);
  QElapsedTimer clock;
  clock.start();
  openPart(part);
  picture();
  std::cout << "opened and drawn after " << clock.elapsed() << " ms\n";
}

} // namespace
} // namespace voluta::test
