// The stages and queries that decide how long a designer waits, on the sample part.
#include "collision/cell_collision.h"
#include "collision/growing_part.h"
#include "collision/random_shapes.h"
#include "curved/curved_layers.h"
#include "curved/decompose.h"
#include "curved/platform_polygon.h"
#include "geometry/least_turn.h"
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

// Whether the bodies of the cell collide, in all IK solutions of random poses over the plate.
void bodiesOfTheCell(benchmark::State& state) {
  const process::Process process = process::loadProcess("fdm-1.0");
  const robot::Cell cell = robot::loadCell("ur5-fixed", process, curved::platformDisc(40.0));
  const collision::CellCollision collision(cell, process);
  test::RandomShapes random(23);
  std::vector<collision::CellCollision::Frames> frames;
  std::vector<robot::JointVector> solutions;
  while (frames.size() < 2000) {
    Eigen::Isometry3d work_T_tool = Eigen::Isometry3d::Identity();
    work_T_tool.linear() =
        geometry::shortestRotation(Eigen::Vector3d::UnitZ(),
                                   -(random.point(0.7) + Eigen::Vector3d::UnitZ()).normalized())
            .toRotationMatrix();
    work_T_tool.translation() = random.point(30) + Eigen::Vector3d(0, 0, 50);
    solutions.clear();
    cell.inverse(work_T_tool, cell.home(), solutions);
    for (const robot::JointVector& q : solutions)
      cell.framePoses(q, frames.emplace_back());
  }
  std::size_t next = 0;
  for (auto _ : state)
    benchmark::DoNotOptimize(collision.bodies(frames[next++ % frames.size()], {}).has_value());
}
BENCHMARK(bodiesOfTheCell);

// A block of 200,000 steps of 1 mm.
plan::ToolPlan largeBlock() {
  plan::ToolPlan plan;
  for (int i = 0; i < 200000; ++i) {
    const int ring = i / 2000, line = i % 2000 / 50, x = i % 50;
    plan.position.emplace_back(line % 2 ? 49 - x : x, 1.1 * line, 0.8 * (ring + 1));
    plan.direction.push_back(Eigen::Vector3d::UnitZ());
    plan.widthMm.push_back(1.2f);
    plan.heightMm.push_back(0.8f);
    plan.speedMmPerS.push_back(20.0f);
  }
  plan.paths.push_back({0, plan.position.size()});
  return plan;
}

void growingPartOfALargeBlock(benchmark::State& state) {
  const plan::ToolPlan plan = largeBlock();
  for (auto _ : state)
    benchmark::DoNotOptimize(collision::GrowingPart(plan, 0.45, {}).grid().cellCount());
}
BENCHMARK(growingPartOfALargeBlock)->Unit(benchmark::kMillisecond);

// Checks the head, standing on a large block, for collisions with it.
void headOnALargeBlock(benchmark::State& state) {
  const plan::ToolPlan plan = largeBlock();
  const collision::GrowingPart part(plan, 0.45, {});
  const robot::Frustum tip{{0, 0, 0.4}, {0, 0, 12.4}, 0.5, 5.6};
  const robot::Frustum body{{0, 0, 12.4}, {0, 0, 45.4}, 9.6, 9.6};
  std::size_t next = 0;
  for (auto _ : state) {
    const std::size_t w = (next += 10) % plan.position.size();
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translation() = plan.position[w];
    benchmark::DoNotOptimize(part.touches(tip, pose, 0.0, w) || part.touches(body, pose, 0.0, w));
  }
}
BENCHMARK(headOnALargeBlock);

} // namespace
