#include "layers/layer_stack.h"
#include "modes/mode_stages.h"
#include "pipeline/checked_program.h"
#include "pipeline/stage_cache.h"

#include "base/error.h"
#include "pipeline/box_request.h"
#include "pipeline/stages.h"

#include <gtest/gtest.h>
#include <thread>

using namespace voluta;
using modes::LayersStage;
using pipeline::CheckedProgram;
using pipeline::StageCache;
using pipeline::ToolpathStage;

namespace {

TEST(Stage, NamesMapBackToTheirStages) {
  for (std::size_t i = 0; i < project::kStageCount; ++i) {
    const auto stage = static_cast<project::Stage>(i);
    EXPECT_EQ(project::stageOf(std::string(project::stageName(stage))), stage);
  }
  EXPECT_THROW(project::stageOf("motin"), base::Error);
}

TEST(StageCache, KeepsTheLastFewOfAStage) {
  StageCache cache(2);
  const auto a = std::make_shared<const LayersStage>(), b = std::make_shared<const LayersStage>(),
             c = std::make_shared<const LayersStage>();
  cache.keep<LayersStage>("a", a);
  cache.keep<LayersStage>("b", b);
  EXPECT_EQ(cache.find<LayersStage>("a"), a); // found: now younger than b
  cache.keep<LayersStage>("c", c);
  EXPECT_EQ(cache.find<LayersStage>("a"), a);
  EXPECT_EQ(cache.find<LayersStage>("b"), nullptr);
  EXPECT_EQ(cache.find<LayersStage>("c"), c);
  EXPECT_EQ(cache.find<ToolpathStage>("a"), nullptr) << "a key is of one stage";
  cache.clear();
  EXPECT_EQ(cache.find<LayersStage>("c"), nullptr);
}

TEST(StageCache, KeepsProgramsOneByOneForEachFormat) {
  StageCache cache(1);
  const auto csv = std::make_shared<const CheckedProgram>(),
             gcode = std::make_shared<const CheckedProgram>();
  cache.keep<CheckedProgram>("k", csv, "csv");
  cache.keep<CheckedProgram>("k", gcode, "gcode-extended");
  EXPECT_EQ(cache.find<CheckedProgram>("k", "csv"), csv);
  EXPECT_EQ(cache.find<CheckedProgram>("k", "gcode-extended"), gcode);
}

TEST(StageCache, AKeyKeptTwiceHasTheLatestValueOnce) {
  StageCache cache(2);
  const auto old = std::make_shared<const LayersStage>(),
             latest = std::make_shared<const LayersStage>();
  cache.keep<LayersStage>("other", old);
  cache.keep<LayersStage>("k", old);
  cache.keep<LayersStage>("k", latest);
  EXPECT_EQ(cache.find<LayersStage>("k"), latest);
  EXPECT_EQ(cache.find<LayersStage>("other"), old);
}

TEST(StageCache, ResultsFoundInTheCacheBehindBecomeItsOwn) {
  StageCache behind(1);
  const auto a = std::make_shared<const LayersStage>(), b = std::make_shared<const LayersStage>();
  behind.keep<LayersStage>("a", a);
  StageCache cache(1, &behind);
  EXPECT_EQ(cache.find<LayersStage>("a"), a);
  behind.keep<LayersStage>("b", b);
  EXPECT_EQ(behind.find<LayersStage>("a"), nullptr);
  EXPECT_EQ(cache.find<LayersStage>("a"), a) << "asked for, and so its own";
  cache.keep<LayersStage>("c", b);
  EXPECT_EQ(behind.find<LayersStage>("c"), b);
}

// A reopened project is planned with the cell's plate, like its first plan.
TEST(StageCache, JobFromDiskUsesTheSamePlateOfItsCell) {
  pipeline::PlanRequest request = test::boxRequest();
  request.choices.item().automatic = true;
  request.until = project::Stage::Layers;
  const pipeline::PlanResult first = pipeline::planPart(request, {});
  ASSERT_TRUE(first.job.choices.item().platform.isOfCell());
  const pipeline::PlanResult reopened = pipeline::resultOf(first.job);
  ASSERT_FALSE(reopened.item().placed->platform.empty());
  EXPECT_EQ(reopened.item().placed->platform, first.item().placed->platform);
  StageCache cache;
  pipeline::seedCache(cache, first.job);
  request.choices = first.job.choices;
  request.choices.item().parameters["voxelMm"] = "1";
  EXPECT_TRUE(pipeline::nothingBlocks(pipeline::planPart(request, {}, &cache).job.report));
}

TEST(StageCache, SeveralThreadsMayUseIt) {
  StageCache cache(3);
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&cache, t] {
      for (int i = 0; i < 2000; ++i) {
        const std::string key = std::to_string((i + t) % 7);
        auto layers = std::make_shared<LayersStage>();
        layers->report.count = (i + t) % 7;
        cache.keep<LayersStage>(key, layers);
        if (const auto found = cache.find<LayersStage>(key)) {
          EXPECT_EQ(std::to_string(found->report.count), key);
        }
      }
    });
  for (std::thread& thread : threads)
    thread.join();
}

} // namespace
