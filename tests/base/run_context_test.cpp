#include "base/error.h"
#include "base/outcome.h"
#include "base/parallel.h"
#include "base/run_context.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <gtest/gtest.h>
#include <mutex>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

using namespace voluta::base;

namespace {

TEST(RunContext, NestedSpansReportTheWhole) {
  std::vector<double> seen;
  const RunContext ctx(CancelToken{}, 1,
                       [&](double f, const voluta::base::Message&) { seen.push_back(f); });
  const RunContext half = ctx.sub(0.5, 1.0);
  half.report(0.0, "a"_text);
  half.sub(0.5, 1.0).report(0.5, "b"_text);
  half.report(2.0, "c"_text);
  ASSERT_EQ(seen.size(), 3u);
  EXPECT_DOUBLE_EQ(seen[0], 0.5);
  EXPECT_DOUBLE_EQ(seen[1], 0.875);
  EXPECT_DOUBLE_EQ(seen[2], 1.0);
}

TEST(RunContext, QuietContextReportsNoProgress) {
  const CancelToken token;
  int reported = 0;
  const RunContext ctx(token, 3, [&](double, const voluta::base::Message&) { ++reported; });
  const RunContext quiet = ctx.sub(0.2, 0.4).quiet();
  quiet.report(0.5, "a"_text);
  quiet.sub(0.0, 0.5).report(0.5, "b"_text);
  EXPECT_EQ(reported, 0);
  EXPECT_EQ(quiet.threads(), 3);
  token.cancel();
  EXPECT_TRUE(quiet.cancelled());
  EXPECT_THROW(quiet.report(1.0, "c"_text), Cancelled);
}

TEST(RunContext, CancelIsStickyAndShared) {
  const CancelToken token;
  const RunContext ctx(token, 2);
  const RunContext inner = ctx.sub(0, 1);
  EXPECT_NO_THROW(inner.checkpoint());
  token.cancel();
  EXPECT_THROW(inner.checkpoint(), Cancelled);
  EXPECT_THROW(ctx.report(0.1, "x"_text), Cancelled);
  EXPECT_THROW(parallelChunks(ctx, 10, 1, [](std::size_t, std::size_t) {}), Cancelled);
}

TEST(Parallel, ChunksCoverTheRangeOnceForAnyThreads) {
  for (const int threads : {1, 2, 3}) {
    const RunContext ctx(CancelToken{}, threads);
    std::vector<int> hits(1001, 0);
    parallelChunks(ctx, hits.size(), 64, [&](std::size_t b, std::size_t e) {
      for (std::size_t i = b; i < e; ++i)
        ++hits[i];
    });
    EXPECT_EQ(std::accumulate(hits.begin(), hits.end(), 0), 1001);
    EXPECT_EQ(*std::max_element(hits.begin(), hits.end()), 1);
  }
}

TEST(Parallel, WaitingThreadReportsProgress) {
  for (const int threads : {1, 2, 3}) {
    const std::thread::id caller = std::this_thread::get_id();
    std::vector<double> reported;
    const RunContext ctx(CancelToken{}, threads, [&](double f, const voluta::base::Message&) {
      EXPECT_EQ(std::this_thread::get_id(), caller);
      reported.push_back(f);
    });
    std::vector<int> times(200, 0);
    parallelWithProgress(ctx, times.size(), 0.6, "a"_text, [&](std::size_t i) { ++times[i]; });
    EXPECT_EQ(times, std::vector<int>(200, 1));
    ASSERT_FALSE(reported.empty());
    EXPECT_EQ(reported.front(), 0.0);
    EXPECT_TRUE(std::ranges::is_sorted(reported));
    EXPECT_LE(reported.back(), 0.6);
    if (threads == 1) {
      EXPECT_EQ(reported.size(), 201u);
    }
    EXPECT_THROW(parallelWithProgress(ctx, 9, 1.0, "b"_text,
                                      [](std::size_t i) {
                                        if (i == 4)
                                          throw std::runtime_error("five");
                                      }),
                 std::runtime_error);
  }
}

TEST(Parallel, SumsAreTheSameForAnyThreads) {
  const auto sum = [](int threads) {
    return parallelSum<double>(RunContext(CancelToken{}, threads), 100000, 777, 0.0,
                               [](std::size_t b, std::size_t e) {
                                 double s = 0;
                                 for (std::size_t i = b; i < e; ++i)
                                   s += std::sin(static_cast<double>(i)) * 1e-3;
                                 return s;
                               });
  };
  EXPECT_EQ(sum(1), sum(2));
  EXPECT_EQ(sum(1), sum(4));
}

TEST(Parallel, TheFirstFailureLeaves) {
  const RunContext ctx(CancelToken{}, 2);
  try {
    parallelChunks(ctx, 100, 1, [](std::size_t b, std::size_t) {
      if (b == 30 || b == 70)
        throw Error(ErrorCode::SolverFailure, message("{number}"_text, b));
    });
    FAIL() << "nothing was thrown";
  } catch (const Error& e) {
    EXPECT_EQ(voluta::base::english(e.message()), "30");
  }
}

// A chunk that holds a lock and hands out work of its own gets no other chunk to do meanwhile,
// which would want the lock.
TEST(Parallel, WorkWithinWorkWaitsForItsOwnOnly) {
  const RunContext ctx(CancelToken{}, 2);
  std::vector<std::mutex> locks(4);
  std::atomic<int> done = 0;
  parallelChunks(ctx, 400, 1, [&](std::size_t b, std::size_t) {
    const std::lock_guard held(locks[b % locks.size()]);
    parallelChunks(ctx.quiet(), 20, 1, [&](std::size_t, std::size_t) { ++done; });
  });
  EXPECT_EQ(done, 400 * 20);
}

TEST(Parallel, TwoThreadsMayShareTheWorkersOfARun) {
  const RunContext ctx(CancelToken{}, 2);
  std::atomic<int> done = 0;
  const auto work = [&] {
    for (int k = 0; k < 200; ++k)
      parallelChunks(ctx, 10, 1, [&](std::size_t, std::size_t) { ++done; });
  };
  std::thread other(work);
  work();
  other.join();
  EXPECT_EQ(done, 2 * 200 * 10);
}

TEST(Outcome, EveryEndBecomesAValue) {
  EXPECT_EQ(std::get<int>(outcomeOf([] { return 3; })), 3);
  EXPECT_TRUE(std::holds_alternative<Cancelled>(outcomeOf([]() -> int { throw Cancelled{}; })));
  EXPECT_EQ(std::get<Error>(outcomeOf([]() -> int {
              throw Error(ErrorCode::Usage, "what"_text, "where"_name, "help"_text);
            })).what(),
            std::string("where: what (help)"));
  EXPECT_EQ(std::get<Error>(outcomeOf([]() -> int { throw std::runtime_error("odd"); })).code(),
            ErrorCode::Internal);
}

} // namespace
