// A milled part's program is verified from its job file.
#include "pipeline/mill_job.h"

#include "base/error.h"
#include "helpers/shapes.h"

#include <gtest/gtest.h>

namespace voluta::pipeline {
namespace {

MillOrder order() {
  MillOrder order;
  order.name = "block";
  order.rule.data = *milling::cuttingDataFor("soft-plastic");
  order.rule.skinMm = 1.25;
  order.layDown = false;
  return order;
}

TEST(MillJob, AProgramIsVerifiedFromTheFile) {
  const MilledPart milled =
      millPart(test::box({-1.0 / 3.0, 0, 0}, {10, 8, 40.0 / 7.0}), order(), {});
  ASSERT_TRUE(milled.verdict.passed);
  const std::string text = writeMillJob(milled.part, order());
  EXPECT_TRUE(isMillJob(text));
  const MillJob job = readMillJob(text, "mill.json");
  EXPECT_EQ(job.part.vertices, milled.part.vertices);
  EXPECT_EQ(job.part.triangles, milled.part.triangles);
  EXPECT_TRUE(verifyMilling(milled.program, job, {}).passed);
  std::string changed = milled.program;
  const std::size_t at = changed.rfind("G1 ");
  changed.erase(at, changed.find('\n', at) + 1 - at);
  EXPECT_FALSE(verifyMilling(changed, job, {}).passed);
}

TEST(MillJob, DamagedFilesAreRefused) {
  const std::string text = writeMillJob(test::box({0, 0, 0}, {1, 1, 1}), order());
  EXPECT_FALSE(isMillJob("{\"format\":\"voluta job\"}"));
  for (const auto& [from, to] :
       std::vector<std::pair<std::string, std::string>>{{"\"teeth\":1", "\"teeth\":\"x\""},
                                                        {"soft-plastic", "butter"},
                                                        {"\"pitchMm\":0.1", "\"pitchMm\":-1"},
                                                        {"[0,", "[99,"},
                                                        {"milling 1", "milling 9"}}) {
    std::string damaged = text;
    const std::size_t at = damaged.rfind(from);
    ASSERT_NE(at, std::string::npos) << from;
    damaged.replace(at, from.size(), to);
    try {
      readMillJob(damaged, "mill.json");
      ADD_FAILURE() << from;
    } catch (const base::Error& e) {
      EXPECT_NE(std::string(e.what()).find("mill.json"), std::string::npos) << e.what();
    }
  }
}

} // namespace
} // namespace voluta::pipeline
