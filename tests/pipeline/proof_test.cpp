// The proof beside a program: its hash is the file's, its places are lines of it, and the mesh is
// of the beads.
#include "base/files.h"
#include "base/sha256.h"
#include "base/units.h"
#include "box_request.h"
#include "collision/growing_part.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/measures.h"
#include "helpers/temporary_folder.h"
#include "motion/margins.h"
#include "pipeline/outputs.h"
#include "pipeline/printed_mesh.h"
#include "pipeline/proof.h"
#include "pipeline/road.h"
#include "process/bead_model.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using namespace voluta;
using namespace voluta::pipeline;

namespace {

const base::RunContext kCtx;

nlohmann::json proofIn(const std::filesystem::path& folder, const std::string& program) {
  return nlohmann::json::parse(base::readFile(folder / (program + ".proof.json")));
}

TEST(Proof, StandsBesideEachProgramThatPassed) {
  PlanResult plan = test::boxPlan();
  ASSERT_TRUE(nothingBlocks(plan.job.report));
  const test::TemporaryFolder folder;
  writeOutputs(plan, folder.path(), kCtx);
  ASSERT_EQ(plan.checked.size(), 3u);
  for (const auto& checked : plan.checked) {
    const std::string file = checked->program.files[0].name;
    const auto proof = proofIn(folder.path(), file);
    EXPECT_EQ(proof["files"][0]["sha256"], base::sha256(base::readFile(folder / file)));
    EXPECT_EQ(proof["replay"]["passed"], true);
    EXPECT_NEAR(proof["durationS"]["planned"].get<double>(), plan.job.report.motion.durationS,
                1e-9);
    EXPECT_EQ(proof["jointLimits"].size(), 6u);
    const auto lines = std::ranges::count(checked->program.files[0].text, '\n');
    for (const auto* place : {&proof["leastClearance"], &proof["singularity"]}) {
      EXPECT_EQ((*place)["file"], file);
      EXPECT_GT((*place)["line"].get<long>(), 0);
      EXPECT_LE((*place)["line"].get<long>(), lines);
    }
    const std::string page = base::readFile(folder / (file + ".proof.html"));
    EXPECT_NE(page.find("<svg"), std::string::npos);
    EXPECT_NE(page.find(proof["files"][0]["sha256"].get<std::string>()), std::string::npos);
  }
  EXPECT_TRUE(std::filesystem::exists(folder / "box.printed.stl"));
}

TEST(Proof, NoneIsMadeWhereItIsNotWanted) {
  PlanResult plan = test::boxPlan();
  plan.proofs = false;
  const test::TemporaryFolder folder;
  writeOutputs(plan, folder.path(), kCtx);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    EXPECT_EQ(entry.path().string().find(".proof."), std::string::npos) << entry.path();
}

TEST(Proof, TheMarginIsToTheNearerLimit) {
  const PlanResult& plan = test::boxPlan();
  const plan::Trajectory& t = *plan.job.trajectory;
  const motion::MotionMargins margins = motion::marginsOf(t, *plan.cell, kCtx);
  for (int j = 0; j < t.dof; ++j) {
    const auto& limits = plan.cell->limits()[static_cast<std::size_t>(j)];
    double least = 1e9;
    for (std::size_t i = 0; i < t.pointCount(); ++i)
      least = std::min({least, t.at(i)[j] - limits.min, limits.max - t.at(i)[j]});
    EXPECT_DOUBLE_EQ(margins.joints[static_cast<std::size_t>(j)].rad, least);
  }
}

TEST(Proof, AStretchedArmIsSingular) {
  const PlanResult& plan = test::boxPlan();
  const robot::RobotModel& robot = plan.cell->robot();
  const double reach = motion::reachOf(robot);
  robot::JointVector bent = plan.cell->home(), stretched = robot::JointVector::Zero(6);
  EXPECT_GT(motion::isotropyAt(robot, bent, reach), 1e-3);
  EXPECT_LT(motion::isotropyAt(robot, stretched, reach),
            1e-6); // the UR's zero: arm out, wrist flat
}

TEST(Proof, TheFillMapSaysWhereNothingIs) {
  const PlanResult& plan = test::boxPlan();
  const plan::ToolPlan& whole = *plan.job.toolPlan;
  const double pitch = collision::growingPitch(whole, *plan.process);
  const FillMap full =
      fillMap(plan.job.printed(), collision::GrowingPart(whole, pitch, kCtx), kCtx);
  double mean = 0.0, count = 0.0;
  for (const double share : full.filled)
    if (share >= 0.0) {
      mean += share;
      count += 1.0;
    }
  EXPECT_GT(mean / count, 0.9);
  plan::ToolPlan half = whole; // lower layers only
  std::erase_if(half.paths, [](const plan::ToolPath& p) { return p.layer > 4; });
  const FillMap left = fillMap(plan.job.printed(), collision::GrowingPart(half, pitch, kCtx), kCtx);
  const auto at = [](const FillMap& map, int k) {
    return map.filled[static_cast<std::size_t>(
        map.size.x() / 2 + map.size.x() * (map.size.y() / 2 + map.size.y() * k))];
  };
  EXPECT_GT(at(left, 1), 0.8);
  EXPECT_EQ(at(left, left.size.z() - 2), 0.0);
}

TEST(PrintedMesh, OneBeadIsItsTube) {
  plan::ToolPlan plan;
  for (const double x : {0.0, 4.0, 10.0}) {
    plan.position.emplace_back(x, 0, 0.8);
    plan.direction.emplace_back(0, 0, 1);
    plan.widthMm.push_back(1.2f);
    plan.heightMm.push_back(0.8f);
    plan.speedMmPerS.push_back(20.0f);
  }
  plan.paths.push_back({0, 3, plan::PathKind::Wall, 0, 0, 0, false});
  const collision::GrowingPart growing(plan, 0.2, kCtx);
  const geometry::TriangleMesh mesh = outerBeads(plan, growing);
  // 10 mm of the bead's section; the point between is left out.
  EXPECT_NEAR(geometry::volume(mesh), 10.0 * process::beadArea(1.2f, 0.8f), 1e-6);
  EXPECT_EQ(mesh.vertices.size(), 16u);
  EXPECT_NEAR(geometry::bounds(mesh).min().z(), 0.0, 1e-6);
  EXPECT_NEAR(geometry::bounds(mesh).max().z(), 0.8, 1e-6);
}

TEST(PrintedMesh, BeadsWithinAreLeftOut) {
  const PlanResult& plan = test::boxPlan();
  const plan::ToolPlan& whole = *plan.job.toolPlan;
  const collision::GrowingPart growing(whole, collision::growingPitch(whole, *plan.process), kCtx);
  const geometry::TriangleMesh mesh = outerBeads(whole, growing);
  ASSERT_FALSE(mesh.empty());
  EXPECT_LT(geometry::volume(mesh), 0.75 * plan.job.report.toolpath.materialMm3);
  const Eigen::AlignedBox3d box = geometry::bounds(mesh);
  EXPECT_NEAR(box.sizes().x(), 20.0, 1.2);
  EXPECT_NEAR(box.sizes().z(), 8.0, 0.8);
}

} // namespace
