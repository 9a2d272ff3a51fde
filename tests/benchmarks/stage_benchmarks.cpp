// The stages and queries that decide how long a designer waits, on the sample part.
#include "collision/growing_part.h"
#include "curved/curved_layers.h"
#include "curved/decompose.h"
#include "curved/platform.h"
#include "geometry/mesh_query.h"
#include "geometry/placement.h"
#include "process/process.h"
#include "project/sample_part.h"
#include "robot/cell.h"
#include "robot/robot_model.h"
#include "toolpath/plan_toolpaths.h"
#include "voxel/solid_voxels.h"

#include <benchmark/benchmark.h>
#include <random>

namespace {
using namespace voluta;

geometry::TriangleMesh part() {
  return geometry::placeOnPlate(project::samplePart(), 1.0);
}

curved::Decomposition decomposed(const geometry::TriangleMesh& mesh) {
  const voxel::SolidVoxels solid = voxel::solidVoxels(mesh, 1.2, {});
  return curved::decompose(solid, curved::platformFit(solid, 0.0), {}, {});
}

void inverseKinematics(benchmark::State& state) {
  const robot::RobotModel ur5 = robot::loadRobot("ur5");
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angle(-3.1, 3.1);
  std::vector<Eigen::Isometry3d> poses;
  for (int i = 0; i < 1000; ++i) {
    robot::JointVector q(6);
    for (int j = 0; j < 6; ++j)
      q[j] = angle(random);
    poses.push_back(ur5.kinematics->flange(q));
  }
  std::vector<robot::JointVector> solutions;
  std::size_t next = 0;
  for (auto _ : state) {
    solutions.clear();
    ur5.kinematics->inverse(poses[next++ % poses.size()], solutions);
    benchmark::DoNotOptimize(solutions.data());
  }
}
BENCHMARK(inverseKinematics);

void closestPoint(benchmark::State& state) {
  const geometry::TriangleMesh mesh = part();
  const geometry::MeshQuery query(mesh);
  std::mt19937 random(2);
  std::uniform_real_distribution<double> place(-30, 30);
  for (auto _ : state)
    benchmark::DoNotOptimize(
        query.closest({place(random), place(random), 30 + place(random)}).distance);
}
BENCHMARK(closestPoint);

void voxelise(benchmark::State& state) {
  const geometry::TriangleMesh mesh = part();
  for (auto _ : state)
    benchmark::DoNotOptimize(voxel::solidVoxels(mesh, 0.8, {}).count);
}
BENCHMARK(voxelise)->Unit(benchmark::kMillisecond);

void decompose(benchmark::State& state) {
  const geometry::TriangleMesh mesh = part();
  for (auto _ : state)
    benchmark::DoNotOptimize(decomposed(mesh).layers);
}
BENCHMARK(decompose)->Unit(benchmark::kMillisecond);

void cutLayers(benchmark::State& state) {
  const geometry::TriangleMesh mesh = part();
  const curved::Decomposition d = decomposed(mesh);
  for (auto _ : state)
    benchmark::DoNotOptimize(curved::curvedLayers(d, mesh, {}, {}).stack.layerCount);
}
BENCHMARK(cutLayers)->Unit(benchmark::kMillisecond);

void toolpathsAndGrowingPart(benchmark::State& state) {
  const geometry::TriangleMesh mesh = part();
  const layers::LayerStack stack = curved::curvedLayers(decomposed(mesh), mesh, {}, {}).stack;
  const process::Process process = process::loadProcess("fdm-1.0");
  const robot::Cell cell = robot::loadCell("ur5-fixed", process, curved::platformDisc(80.0));
  for (auto _ : state) {
    const auto planned = toolpath::planToolpaths(stack, cell, process::Tooling(process), {}, {});
    benchmark::DoNotOptimize(collision::GrowingPart(planned.plan, 0.5, {}).grid().cellCount());
  }
}
BENCHMARK(toolpathsAndGrowingPart)->Unit(benchmark::kMillisecond);

} // namespace
