#include "pipeline/job.h"

#include "base/error.h"
#include "base/files.h"
#include "support/shapes.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <random>
#include <unistd.h>

using namespace voluta;
using pipeline::Job;

namespace {

Job sampleJob() {
  Job job;
  job.partName = "box.stl";
  job.part = std::make_shared<geometry::TriangleMesh>(
      test::box(Eigen::Vector3d(-5, -5, 0), Eigen::Vector3d(5, 5, 10)));
  job.scale = 0.93;
  job.choices.formats = {"urscript"};
  job.choices.parameters = {{"voxelMm", "1.08"}};
  job.platform = {{-5, -5}, {5, -5}, {5, 5}};
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
  return job;
}

class JobFile : public ::testing::Test {
protected:
  void SetUp() override {
    std::string pattern = (std::filesystem::temp_directory_path() / "voluta-job.XXXXXX").string();
    ASSERT_NE(::mkdtemp(pattern.data()), nullptr);
    folder_ = pattern;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  Job readBack(const std::string& bytes) const {
    base::writeFile(folder_ / "job.voluta", bytes);
    return pipeline::readJob(folder_ / "job.voluta");
  }
  std::filesystem::path folder_;
};

TEST_F(JobFile, ComesBackAsItWas) {
  const Job job = sampleJob();
  const std::string bytes = pipeline::jobBytes(job);
  const Job back = readBack(bytes);
  EXPECT_EQ(back.partName, job.partName);
  EXPECT_EQ(back.scale, job.scale);
  EXPECT_EQ(back.choices.parameters, job.choices.parameters);
  EXPECT_EQ(back.choices.formats, job.choices.formats);
  EXPECT_EQ(back.part->vertices, job.part->vertices);
  EXPECT_EQ(back.part->triangles, job.part->triangles);
  EXPECT_EQ(back.platform, job.platform);
  EXPECT_EQ(back.toolPlan->position, job.toolPlan->position);
  EXPECT_EQ(back.toolPlan->heightMm, job.toolPlan->heightMm);
  EXPECT_EQ(back.toolPlan->paths[0].layer, 4);
  EXPECT_EQ(back.toolPlan->paths[0].kind, plan::PathKind::Infill);
  EXPECT_TRUE(back.toolPlan->paths[0].closed);
  EXPECT_EQ(back.trajectory->joints, job.trajectory->joints);
  EXPECT_EQ(back.trajectory->waypoint, job.trajectory->waypoint);
  EXPECT_EQ(pipeline::jobBytes(back), bytes);
}

TEST_F(JobFile, APlanThatStoppedEarlyIsAJobToo) {
  Job job = sampleJob();
  job.toolPlan = nullptr;
  job.trajectory = nullptr;
  const Job back = readBack(pipeline::jobBytes(job));
  EXPECT_EQ(back.toolPlan, nullptr);
  EXPECT_EQ(back.trajectory, nullptr);
}

TEST_F(JobFile, DamageIsAnErrorNeverACrashOrAWrongPlan) {
  const std::string whole = pipeline::jobBytes(sampleJob());
  std::mt19937 random(7);
  for (int trial = 0; trial < 400; ++trial) {
    std::string bytes = whole;
    if (trial % 2 == 0)
      bytes.resize(random() % whole.size());
    else
      bytes[random() % whole.size()] ^= static_cast<char>(1 << random() % 8);
    try {
      readBack(bytes);
      // A changed digit in a choice is still a job; arrays are guarded by their sums.
      EXPECT_EQ(bytes.size(), whole.size());
    } catch (const base::Error& e) {
      EXPECT_EQ(e.code(), base::ErrorCode::UnreadableFile) << e.what();
    }
  }
}

TEST_F(JobFile, IndicesOutsideTheirArraysAreRefused) {
  Job job = sampleJob();
  auto broken = *job.toolPlan;
  broken.paths[0].count = 99;
  job.toolPlan = std::make_shared<plan::ToolPlan>(broken);
  EXPECT_THROW(readBack(pipeline::jobBytes(job)), base::Error);
}

} // namespace
