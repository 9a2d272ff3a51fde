// Frames per second while the mouse rotates large drawings in a viewport of 1280 x 800:
// xvfb-run -a -s "-screen 0 1600x1000x24 +extension GLX" bin/drag_rates [FOLDER]
// Into the folder it writes each picture at rest and while dragging. VOLUTA_DRAG=voxels: those
// alone; also paths, layers.
#include "base/stopwatch.h"
#include "helpers/large_prints.h"
#include "viewer/viewport.h"

#include <QApplication>
#include <QTest>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

namespace {
using namespace voluta;

constexpr int kFrames = 24;

double processSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

class Bench {
public:
  explicit Bench(std::string folder) : folder_(std::move(folder)) {
    viewport.resize(1280, 800);
    viewport.show();
    QTest::qWait(300);
    QObject::connect(&viewport, &viewer::VtkView::framePainted, &viewport,
                     [this](double) { ++painted_; });
  }

  void run(const char* name, const scene::ViewState& view) {
    viewport.setView(view);
    viewport.frameAll();
    QTest::qWait(500);
    keep(name, "rest");
    const QPoint start(500, 400);
    QTest::mousePress(&viewport, Qt::LeftButton, {}, start);
    step(start + QPoint(-20, 0)); // the first frame uploads
    std::vector<double> times;
    const double worked = processSeconds();
    base::Stopwatch all;
    for (int i = 1; i <= kFrames; ++i) {
      base::Stopwatch watch;
      step(start + QPoint(6 * i, i % 10));
      times.push_back(1e3 * watch.seconds());
    }
    const double seconds = all.seconds(), cpu = processSeconds() - worked;
    keep(name, "dragged");
    QTest::mouseRelease(&viewport, Qt::LeftButton, {}, start);
    std::sort(times.begin(), times.end());
    std::printf(
        "%-44s %5.1f frames/s; median %4.0f ms, worst %4.0f ms, processor %4.0f ms a frame\n", name,
        kFrames / seconds, times[kFrames / 2], times.back(), 1e3 * cpu / kFrames);
    std::fflush(stdout);
    QTest::qWait(500);
  }

  viewer::Viewport viewport{scene::lightTheme()};

private:
  void step(const QPoint& to) {
    const int before = painted_;
    QTest::mouseMove(&viewport, to);
    while (painted_ == before)
      QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 5);
  }
  void keep(const std::string& name, const char* state) {
    if (folder_.empty())
      return;
    std::string file = folder_ + "/" + name + ", " + state + ".png";
    viewport.grabFrame().save(QString::fromStdString(file));
  }

  std::string folder_;
  int painted_ = 0;
};

template <typename F> auto timed(const char* name, F&& f) {
  base::Stopwatch watch;
  auto result = f();
  std::printf("%-44s %5.0f ms\n", name, 1e3 * watch.seconds());
  return result;
}

} // namespace

int main(int argc, char** argv) {
  viewer::VtkView::setDefaultFormat();
  const QApplication app(argc, argv);
  Bench bench(argc > 1 ? argv[1] : "");
  scene::Scene& scene = bench.viewport.scene();
  scene::ViewState view;
  view.part = false;
  bench.run("nothing", view);
  view.paths = true;
  const char* only = std::getenv("VOLUTA_DRAG");
  const auto isWanted = [&](const char* what) { return !only || std::string(only) == what; };
  for (const double spacing : {0.6, 1.2}) {
    if (!isWanted("paths"))
      break;
    const bool solid = spacing < 0.8;
    const plan::ToolPlan plan = test::wavedTower(solid ? 144 : 270, spacing);
    const std::string kind = solid ? "solid print" : "print with sparse infill";
    std::printf("%s: %zu segments\n", kind.c_str(), plan.waypointCount() - plan.paths.size());
    const auto drawing = timed("drawPaths", [&] { return scene::drawPaths(plan); });
    scene.setPaths(drawing);
    view.lastLayer = scene::kAllLayers;
    bench.run((kind + ", all layers").c_str(), view);
    view.lastLayer = scene::layerCount(*drawing) / 2;
    bench.run((kind + ", half of the layers").c_str(), view);
  }
  view.paths = false;
  view.voxels = true;
  const curved::Decomposition ball = test::lumpyBall(230);
  std::printf("voxels: %zu in %d layers\n", ball.voxels, ball.layers);
  const auto voxels =
      timed("drawVoxels", [&] { return scene::drawVoxels(ball, {.layerHeightMm = 1.0}); });
  scene.setPaths(nullptr);
  scene.setVoxels(voxels);
  view.lastLayer = scene::kAllLayers;
  if (isWanted("voxels")) {
    bench.run("voxels, all layers", view);
    view.lastLayer = scene::layerCount(*voxels) / 2;
    bench.run("voxels, half of the layers", view);
    view.firstLayer = scene::layerCount(*voxels) / 4;
    bench.run("voxels, some layers", view);
  }
  if (!isWanted("layers"))
    return 0;
  view.voxels = false;
  view.layers = true;
  view.firstLayer = 0;
  view.lastLayer = scene::kAllLayers;
  const layers::LayerStack stack = test::shellsOf(ball, 0.8);
  const auto slabs = timed("drawLayers", [&] { return scene::drawLayers(stack); });
  scene.setVoxels(nullptr);
  scene.setLayers(slabs);
  bench.run("layers, all", view);
  view.lastLayer = scene::layerCount(*slabs) / 2;
  bench.run("layers, half of them", view);
  return 0;
}
