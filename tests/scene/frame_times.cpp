// Not a test: times of frames while dragging, on a job from disk (VOLUTA_JOB) at 1280 x 800.
#include "base/stopwatch.h"
#include "pipeline/stage_options.h"
#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "project/job.h"
#include "robot/cell.h"
#include "robot/shape/arm_look.h"
#include "scene/offscreen_target.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <vector>
#include <vtkCamera.h>
#include <vtkRenderer.h>

namespace {
using namespace voluta;

constexpr int kFrames = 30;

struct Bench {
  scene::Scene scene{scene::lightTheme()};
  scene::OffscreenTarget target;
  scene::OffscreenTarget::Session session{target, scene, 1280, 800};

  // Median and worst of frames for which `change` sets the view for a share 0 ... 1.
  void run(const char* name, scene::ViewState view,
           const std::function<void(scene::ViewState&, double)>& change) {
    scene.setView(view);
    scene.standardView(scene::StandardView::Isometric);
    base::Stopwatch warm;
    session.draw();
    const double first = warm.seconds();
    std::vector<double> times;
    for (int i = 0; i < kFrames; ++i) {
      base::Stopwatch watch;
      change(view, double(i) / (kFrames - 1));
      scene.setView(view);
      session.draw();
      times.push_back(1000.0 * watch.seconds());
    }
    std::sort(times.begin(), times.end());
    std::printf("%-34s first %6.0f ms, then median %5.0f ms, worst %5.0f ms\n", name,
                1000.0 * first, times[kFrames / 2], times.back());
    std::fflush(stdout);
  }
};

template <typename F> auto timed(const char* name, F&& f) {
  base::Stopwatch watch;
  auto result = f();
  std::printf("%-34s %6.0f ms\n", name, 1000.0 * watch.seconds());
  return result;
}

} // namespace

int main() {
  const char* file = std::getenv("VOLUTA_JOB");
  if (!file) {
    std::puts("set VOLUTA_JOB to a job.voluta");
    return 2;
  }
  project::Job job = project::readJob(file, pipeline::allParameters());
  Bench bench;
  scene::ViewState view;
  view.part = false;
  view.dragging = true;
  bench.scene.setPlatform(scene::drawPlatform(job.item().platform, 100.0));
  const auto rotate = [&](scene::ViewState&, double) {
    bench.scene.renderer()->GetActiveCamera()->Azimuth(7);
  };
  if (job.item().part) {
    bench.scene.setPart(timed("drawPart", [&] { return scene::drawPart(*job.item().part); }));
    view.part = true;
    bench.run("part, turning", view, rotate);
    view.part = false;
  }
  if (job.item().decomposition()) {
    const auto d =
        timed("drawVoxels", [&] { return scene::drawVoxels(*job.item().decomposition()); });
    bench.scene.setVoxels(d);
    view.voxels = true;
    bench.run("voxels, turning", view, rotate);
    bench.run("voxels, last layer", view, [&](scene::ViewState& v, double t) {
      v.lastLayer = static_cast<int>(t * scene::layerCount(*d));
    });
    view.voxels = false;
  }
  if (job.item().layers) {
    const auto d = timed("drawLayers", [&] { return scene::drawLayers(*job.item().layers); });
    bench.scene.setLayers(d);
    view.layers = true;
    bench.run("layers, turning", view, rotate);
    bench.run("layers, last layer", view, [&](scene::ViewState& v, double t) {
      v.lastLayer = static_cast<int>(t * scene::layerCount(*d));
    });
    view.layers = false;
  }
  if (!job.toolPlan)
    return 0;
  const auto d =
      timed("drawPaths", [&] { return scene::drawPaths(*job.toolPlan, job.trajectory.get()); });
  std::printf("%zu waypoints\n", job.toolPlan->waypointCount());
  bench.scene.setPaths(d);
  view.paths = true;
  bench.run("paths, turning", view, rotate);
  bench.run("paths, last layer", view, [&](scene::ViewState& v, double t) {
    v.lastLayer = static_cast<int>(t * scene::layerCount(*d));
  });
  bench.run("paths, first layer", view, [&](scene::ViewState& v, double t) {
    v.firstLayer = static_cast<int>(t * scene::layerCount(*d));
  });
  bench.run("paths, moves", view, [&](scene::ViewState& v, double t) {
    v.lastLayer = scene::layerCount(*d) / 2;
    v.moves = static_cast<std::size_t>(
        t * static_cast<double>(scene::waypointsOfLayer(*d, v.lastLayer).size()));
  });
  bench.run("paths, section", view, [&](scene::ViewState& v, double t) {
    v.sectionOn = true;
    v.sectionOrigin = {20 * t - 10, 0, 0};
  });
  scene::ViewState still = view;
  still.dragging = false;
  bench.run("paths, not dragging", still, rotate);
  still.colourBy = scene::ColourBy::Speed;
  bench.run("paths, another colour", still, rotate);
  if (!job.trajectory)
    return 0;
  const auto process = pipeline::chosenProcess(job.choices, pipeline::parameterValues(job.choices));
  const robot::Cell cell = robot::loadCell(job.choices.cell, process, job.item().platform);
  bench.scene.setCell(scene::drawCell(cell, robot::lookOf(cell.robot())));
  view.cell = view.materialColour = true;
  view.world = scene::World::Base;
  bench.run("simulation", view, [&](scene::ViewState& v, double t) {
    const auto point =
        static_cast<std::size_t>(t * static_cast<double>(job.trajectory->pointCount() - 1));
    v.joints = Eigen::Map<const Eigen::VectorXd>(job.trajectory->at(point), job.trajectory->dof);
    v.printedWaypoints =
        static_cast<std::size_t>(t * static_cast<double>(job.toolPlan->waypointCount()));
  });
  return 0;
}
