#include "pipeline/sample_job.h"
#include "plan/finding_kinds.h"
#include "project/loaded_part.h"

#include "helpers/shapes.h"
#include "project/job_blocks.h"

#include <limits>

namespace voluta::test {

using project::Job;
using project::Stage;

namespace {

// A box without its last triangle: something to mend.
std::shared_ptr<const project::LoadedPart> openBox() {
  auto mesh = test::box(Eigen::Vector3d(-5, -5, 0), Eigen::Vector3d(5, 5, 10));
  mesh.triangles.pop_back();
  return project::loadedFrom("box.stl", std::make_shared<geometry::TriangleMesh>(mesh),
                             {base::message("omitted: {what}"_text, "1 facet"_name)}, true, {});
}

std::shared_ptr<const curved::Decomposition> sampleDecomposition() {
  curved::Decomposition d;
  d.grid.size = {2, 1, 2};
  d.grid.pitch = 0.8;
  d.grid.origin = {-1, 2, 0};
  d.rank = {1, 2, -1, 0};
  d.field = {0.4f, 1.2f, std::numeric_limits<float>::quiet_NaN(), 0.0f};
  d.frontNormal.assign(4, Eigen::Vector3f(0, 0.6f, 0.8f));
  d.epsilonMm = 0.4;
  d.platform = {{0, 0}, {1, 0}, {0, 1}};
  d.growth = "reverse";
  d.voxels = 3;
  d.layers = 2;
  d.missedVoxels = d.shadowedVoxels = 1;
  d.seconds.grow = 0.25;
  d.loss.assign(d.rank.size(), curved::Loss::None);
  d.loss[0] = curved::Loss::Cascade;
  d.byHead.assign(d.rank.size(), 0);
  d.byHead[1] = 1;
  d.support = d.byHead;
  d.cascadeVoxels = d.headVoxels = d.supportVoxels = 1;
  return std::make_shared<curved::Decomposition>(d);
}

std::shared_ptr<const planar::PlanarDecomposition> samplePieces() {
  planar::PlanarDecomposition d;
  d.riskyBeforeMm2 = 12.0;
  d.riskyMm2 = 0.5;
  d.sectionMm2 = 100.0;
  d.blockedPieces = 1;
  d.seconds.cut = 0.5;
  for (int i = 0; i < 2; ++i) {
    planar::Piece piece;
    piece.solid = planar::tagged(
        test::box(Eigen::Vector3d(-5, -5, 5.0 * i), Eigen::Vector3d(5, 5, 5.0 * (i + 1))));
    piece.solid.tag[3] = 7;
    if (i == 1) {
      piece.base = {Eigen::Vector3d(0, 0.6, 0.8), 3.0};
      piece.baseTag = 7;
      piece.parent = 0;
    }
    d.pieces.push_back(piece);
  }
  return std::make_shared<planar::PlanarDecomposition>(d);
}

std::shared_ptr<const layers::LayerStack> sampleLayers() {
  layers::LayerStack stack;
  stack.layerCount = 2;
  for (int i = 0; i < 2; ++i) {
    layers::Patch p;
    p.surface.vertices = {{0, 0, 0.4 + i}, {1, 0, 0.4 + i}, {0, 1, 0.4 + i}};
    p.surface.triangles = {{0, 1, 2}};
    if (i == 1) { // patches of different sizes
      p.surface.vertices.emplace_back(1, 1, 1.4);
      p.surface.triangles.push_back({1, 3, 2});
      p.chart.at = {{0, 0}, {1, 0}, {0, 1}, {6, -2}};
      p.chart.periodMm = 12.5;
    }
    p.thicknessMm.assign(p.surface.vertices.size(), 0.7 + i);
    p.direction.assign(p.surface.vertices.size(), Eigen::Vector3d::UnitZ());
    p.clearDirection.assign(p.surface.vertices.size(), Eigen::Vector3d(0, 0.6, 0.8));
    p.innerRim.assign(p.surface.vertices.size(), 0);
    p.innerRim.back() = 1;
    p.layer = i;
    p.group = 3 - i;
    stack.patches.push_back(p);
  }
  return std::make_shared<layers::LayerStack>(stack);
}

void addReport(Job& job) {
  job.reached = Stage::Motion;
  job.report.item().model.file = "box.stl";
  job.report.item().model.repairs = {
      base::message("merged {count} duplicate point|merged {count} duplicate points"_plural, 3)};
  job.report.item().layers.count = 2;
  job.report.motion.maxJerk = {1.5, 2.5};
  job.report.motion.minClearanceMm = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < 3; ++i) {
    plan::Finding finding = plan::makeFinding(
        plan::FindingKind::BeyondRod,
        {{"place", base::message("layer {layer}, x {x:.1f} y {y:.1f} z {z:.1f}"_text, i,
                                 base::number(0.5), base::number(1.0 / 3.0), base::number(2.0))},
         {"radius", base::mm(50.0 + static_cast<double>(i))},
         {"along", base::mm(100.0)}});
    finding.blocking = i == 2;
    if (i == 1)
      finding.where = Eigen::Vector3d(0.1, 2, 3), finding.whenS = 0.3;
    job.report.findings.push_back(finding);
  }
  for (std::size_t i = 0; i <= project::indexOf(Stage::Motion); ++i)
    job.stages[i].key = "what went into stage " + std::to_string(i);
  job.stages[project::indexOf(Stage::Layers)].findings = 1;
  job.stages[project::indexOf(Stage::Motion)].findings = 2;
  job.stages[project::indexOf(Stage::Motion)].timings.ik = 0.125;
  job.report.timings.ik = 0.125;
}

} // namespace

Job sampleJobOfPieces() {
  Job job = sampleJob();
  job.choices.item().mode = "planar";
  job.item().result = samplePieces();
  return job;
}

Job sampleJob() {
  Job job;
  job.item().partName = "box.stl";
  job.item().loaded = openBox();
  job.item().part = std::make_shared<geometry::TriangleMesh>(
      test::box(Eigen::Vector3d(-5, -5, 0), Eigen::Vector3d(5, 5, 10)));
  job.item().scale = 0.93;
  job.choices.item().placement.rotation = Eigen::Quaterniond(0.6, 0.8, 0, 0);
  job.choices.item().placement.centreMm = {3, -4};
  job.choices.item().placement.liftMm = 0.5;
  job.item().result = sampleDecomposition();
  job.item().layers = sampleLayers();
  job.choices.formats = {"urscript"};
  job.choices.item().parameters = {{"voxelMm", "1.08"}};
  job.choices.parameters = {{"seam", "corner"}};
  job.item().platform = {{-5, -5}, {5, -5}, {5, 5}};
  plan::ToolPlan p;
  p.position = {{0, 0, 0.8}, {1, 0, 0.8}, {2, 0.5, 0.8}};
  p.direction.assign(3, Eigen::Vector3d::UnitZ());
  p.widthMm = {1.2f, 1.3f, 1.4f};
  p.heightMm = {0.8f, 0.7f, 0.6f};
  p.speedMmPerS = {20, 20, 20};
  p.paths.push_back({0, 3, plan::PathKind::Infill, 4, 2, 1, true});
  job.toolPlan = std::make_shared<plan::ToolPlan>(p);
  plan::Trajectory t;
  t.dof = 2;
  t.joints = {0, 0.1, 0.2, 0.3};
  t.timeS = {0, 1.5};
  t.move = {plan::MoveKind::Joint, plan::MoveKind::Print};
  t.waypoint = {plan::kNoWaypoint, 1};
  t.extrudedMm3 = {0, 0.9};
  job.trajectory = std::make_shared<plan::Trajectory>(t);
  addReport(job);
  return job;
}

} // namespace voluta::test
