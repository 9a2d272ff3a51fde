#include "jobs/job_runner.h"

#include "base/error.h"
#include "jobs/time_left.h"

#include <QProcess>
#include <QSignalSpy>
#include <QTest>
#include <QThread>
#include <QTimer>
#include <atomic>
#include <gtest/gtest.h>
#include <semaphore>
#include <sys/resource.h>
#include <thread>

namespace voluta::jobs {
namespace {

using base::Outcome;
using base::RunContext;

// -1: no value.
int valueOf(const Outcome<int>& outcome) {
  const int* value = std::get_if<int>(&outcome);
  return value ? *value : -1;
}

// The timeout for events that should come.
constexpr int kPatienceMs = 60000;

void sleepMs(int ms) {
  std::this_thread::sleep_for(std::chrono::milliseconds(ms));
}

TEST(JobRunner, DeliversOnTheThreadOfTheWindow) {
  JobRunner runner;
  QSignalSpy finished(&runner, &JobRunner::finished);
  Qt::HANDLE worker = nullptr, delivered = nullptr;
  int priority = 0, value = 0;
  runner.run(
      [&](const RunContext& ctx) {
        worker = QThread::currentThreadId();
        priority = ::getpriority(PRIO_PROCESS, 0);
        return ctx.threads();
      },
      [&](const Outcome<int>& outcome) {
        delivered = QThread::currentThreadId();
        value = valueOf(outcome);
        EXPECT_FALSE(runner.running());
      },
      3);
  EXPECT_TRUE(runner.running());
  ASSERT_TRUE(finished.wait(kPatienceMs));
  EXPECT_EQ(value, 3);
  EXPECT_NE(worker, QThread::currentThreadId());
  EXPECT_EQ(delivered, QThread::currentThreadId());
  EXPECT_GT(priority, 0) << "lower than the window";
}

TEST(JobRunner, ErrorsAreOutcomes) {
  JobRunner runner;
  QSignalSpy finished(&runner, &JobRunner::finished);
  std::string message;
  runner.run(
      [](const RunContext&) -> int { throw base::Error(base::ErrorCode::Usage, "wrong"_text); },
      [&](const Outcome<int>& outcome) { message = std::get<base::Error>(outcome).what(); });
  ASSERT_TRUE(finished.wait(kPatienceMs));
  EXPECT_EQ(message, "wrong");
}

// The work blocks in a call that cannot be cancelled until the test releases it: a cancel that
// waited for it would wait for ever.
TEST(JobRunner, CancelIsDoneAtOnceEvenIfTheWorkIsNot) {
  struct Hanging {
    std::binary_semaphore begun{0}, freeStorage{0};
    std::atomic<bool> ended{false};
  };
  JobRunner runner;
  auto work = std::make_shared<Hanging>();
  int outcomes = 0;
  bool cancelled = false;
  runner.run(
      [work](const RunContext&) {
        work->begun.release();
        work->freeStorage.acquire();
        work->ended = true;
        return 1;
      },
      [&](const Outcome<int>& outcome) {
        ++outcomes;
        cancelled = std::holds_alternative<base::Cancelled>(outcome);
      });
  work->begun.acquire();
  runner.cancel();
  EXPECT_FALSE(runner.running());
  EXPECT_TRUE(cancelled);
  EXPECT_FALSE(work->ended);
  work->freeStorage.release();
  ASSERT_TRUE(QTest::qWaitFor([&] { return work->ended.load(); }, kPatienceMs));
  QTest::qWait(50);
  EXPECT_EQ(outcomes, 1) << "the late result is dropped";
}

TEST(JobRunner, OnlyTheNewestRunDelivers) {
  JobRunner runner;
  QSignalSpy finished(&runner, &JobRunner::finished);
  std::vector<int> delivered;
  for (int i = 0; i < 20; ++i)
    runner.run(
        [i](const RunContext&) {
          sleepMs(i % 3);
          return i;
        },
        [&](const Outcome<int>& outcome) { delivered.push_back(valueOf(outcome)); });
  ASSERT_TRUE(finished.wait(kPatienceMs));
  QTest::qWait(100);
  EXPECT_EQ(delivered, std::vector<int>{19});
}

TEST(JobRunner, ACancelStopsWorkThatListens) {
  JobRunner runner;
  auto stopped = std::make_shared<std::atomic<bool>>(false);
  runner.run(
      [stopped](const RunContext& ctx) {
        const std::shared_ptr<void> onLeave(nullptr, [stopped](void*) { *stopped = true; });
        while (true) {
          ctx.checkpoint();
          sleepMs(1);
        }
        return 0;
      },
      [](const Outcome<int>&) {});
  QTest::qWait(20);
  runner.cancel();
  EXPECT_TRUE(QTest::qWaitFor([&] { return stopped->load(); }, kPatienceMs));
}

// Of all reports between two polls of the window only the latest is passed on; a timer of the
// window sets the interval.
TEST(JobRunner, ProgressIsThrottledAndEndsWithTheLatest) {
  struct Bursts {
    std::binary_semaphore reported{0}, seen{0};
  };
  JobRunner runner;
  QSignalSpy finished(&runner, &JobRunner::finished), progress(&runner, &JobRunner::progressed);
  auto bursts = std::make_shared<Bursts>();
  runner.run(
      [bursts](const RunContext& ctx) {
        for (const char* stage : {"first", "second"}) {
          const double from = std::string_view(stage) == "first" ? 0.0 : 0.5;
          for (int i = 0; i <= 500; ++i)
            ctx.report(from + i / 1000.0, base::message("{stage}"_text, std::string(stage)));
          bursts->reported.release();
          bursts->seen.acquire();
        }
        return 0;
      },
      [](const Outcome<int>&) {});
  const auto* timer = runner.findChild<QTimer*>();
  ASSERT_TRUE(timer);
  // A coarse timer may be a twentieth early.
  EXPECT_GE(timer->interval() * 0.95, 1000.0 / 20.0);
  const double fractions[] = {0.5, 1.0};
  const char* const stages[] = {"first", "second"};
  for (int i = 0; i < 2; ++i) {
    bursts->reported.acquire();
    ASSERT_TRUE(QTest::qWaitFor([&] { return progress.size() > i; }, kPatienceMs));
    EXPECT_EQ(progress.size(), i + 1);
    EXPECT_EQ(base::english(runner.progress().stage), stages[i]);
    EXPECT_EQ(runner.progress().fraction, fractions[i]);
    bursts->seen.release();
  }
  ASSERT_TRUE(finished.wait(kPatienceMs));
  EXPECT_EQ(progress.size(), 2);
}

TEST(JobRunner, PostsArriveInOrderBeforeTheResultAndNotAfterACancel) {
  JobRunner runner;
  QSignalSpy finished(&runner, &JobRunner::finished);
  std::vector<int> seen;
  runner.run(
      [&](const RunContext&, const Post& post) {
        for (int i = 0; i < 5; ++i)
          post([&seen, i] { seen.push_back(i); });
        return 5;
      },
      [&](const Outcome<int>& outcome) { seen.push_back(valueOf(outcome)); });
  ASSERT_TRUE(finished.wait(kPatienceMs));
  EXPECT_EQ(seen, (std::vector<int>{0, 1, 2, 3, 4, 5}));

  seen.clear();
  runner.run(
      [&](const RunContext&, const Post& post) {
        post([&seen] { seen.push_back(7); });
        return 0;
      },
      [](const Outcome<int>&) {});
  sleepMs(50); // posted by now, but not yet seen
  runner.cancel();
  QTest::qWait(50);
  EXPECT_TRUE(seen.empty());
}

TEST(JobRunner, MayBeDestroyedWhileItRuns) {
  auto ended = std::make_shared<std::atomic<bool>>(false);
  bool called = false;
  {
    JobRunner runner;
    runner.run(
        [ended](const RunContext&) {
          sleepMs(100);
          *ended = true;
          return 0;
        },
        [&](const Outcome<int>&) { called = true; });
  }
  ASSERT_TRUE(QTest::qWaitFor([&] { return ended->load(); }, kPatienceMs));
  QTest::qWait(50);
  EXPECT_FALSE(called);
}

TEST(JobRunner, ANewRunMayBeginInTheResultOfTheOld) {
  JobRunner runner;
  QSignalSpy finished(&runner, &JobRunner::finished);
  int second = 0;
  runner.run([](const RunContext&) { return 1; },
             [&](const Outcome<int>&) {
               runner.run([](const RunContext&) { return 2; },
                          [&](const Outcome<int>& outcome) { second = valueOf(outcome); });
             });
  ASSERT_TRUE(QTest::qWaitFor([&] { return second == 2; }, kPatienceMs));
  EXPECT_EQ(finished.size(), 1);
}

// Its run never ends: that the program exits shows that it did not wait for it.
TEST(JobRunner, ProgramExitsWithItsStatusDespiteABlockedRun) {
  for (const int status : {0, 7}) {
    QProcess leaver;
    leaver.start(QStringLiteral(HASTY_LEAVER), {QString::number(status)});
    ASSERT_TRUE(leaver.waitForStarted());
    ASSERT_TRUE(leaver.waitForFinished(kPatienceMs));
    EXPECT_EQ(leaver.exitStatus(), QProcess::NormalExit);
    EXPECT_EQ(leaver.exitCode(), status);
  }
}

TEST(TimeLeft, HidesTheFirstTwoSecondsAndThenCountsDown) {
  TimeLeft left;
  EXPECT_FALSE(left.update(0.5, 0.05));
  EXPECT_FALSE(left.update(1.9, 0.19));
  ASSERT_TRUE(left.update(2.5, 0.25));
  double before = 1e9;
  for (double t = 2.5; t < 10.0; t += 0.05) {
    const std::optional<double> now = left.update(t, t / 10.0);
    ASSERT_TRUE(now);
    EXPECT_NEAR(*now, 10.0 - t, 0.2);
    EXPECT_LE(*now, before + 1e-6);
    before = *now;
  }
}

TEST(TimeLeft, NoEstimateAfterAJumpUntilEstimatesAgreeAgain) {
  TimeLeft left;
  for (double t = 0.0; t < 10.0; t += 0.1)
    left.update(t, 0.02 * t);
  const std::optional<double> before = left.update(10.0, 0.2);
  ASSERT_TRUE(before);
  EXPECT_NEAR(*before, 40.0, 1.0);
  EXPECT_FALSE(left.update(10.1, 0.8)) << "10 s at this pace, 40 s were said";
  std::optional<double> after;
  for (double t = 10.2; t < 20.1 && !after; t += 0.1)
    after = left.update(t, 0.8 + 0.02 * (t - 10.1));
  EXPECT_TRUE(after);
}

// The second half of the work takes another share of the time than the first.
TEST(TimeLeft, EstimateIsRightWithinAFactorOfTwo) {
  constexpr double kFirstS = 10.0, kNoticedS = 2.0;
  for (const double slowdown : {0.25, 1.0, 2.0, 4.0}) {
    TimeLeft left;
    const double secondS = kFirstS * slowdown;
    bool said = false;
    for (double t = 0.0; t < kFirstS + secondS; t += 0.1) {
      const double share = t < kFirstS ? t / kFirstS : 1.0 + (t - kFirstS) / secondS;
      const std::optional<double> now = left.update(t, 0.5 * share);
      const double rest = kFirstS + secondS - t;
      if (t < kFirstS + kNoticedS || !now || rest < 1.0)
        continue;
      said = true;
      EXPECT_LE(*now, 2.0 * rest) << slowdown << " at " << t;
      EXPECT_GE(*now, 0.5 * rest) << slowdown << " at " << t;
    }
    EXPECT_EQ(said, slowdown >= 1.0) << slowdown;
  }
}

// Half of the work was kept from the run before and came at once; the other half takes 16 s.
TEST(TimeLeft, InitialJumpDoesNotCountForThePace) {
  TimeLeft left;
  left.update(0.05, 0.0);
  left.update(0.11, 0.5);
  std::optional<double> now;
  for (double t = 0.15; t < 2.05; t += 0.05)
    now = left.update(t, 0.5 + t / 32.0);
  ASSERT_TRUE(now);
  EXPECT_NEAR(*now, 14.0, 1.5);
}

TEST(TimeLeft, EstimateEndsOnceARunStallsLongerThanItWasToTake) {
  TimeLeft left;
  for (double t = 0.0; t < 9.0; t += 0.05)
    left.update(t, t / 10.0);
  EXPECT_TRUE(left.update(9.0, 0.9));
  EXPECT_TRUE(left.update(9.5, 0.9));
  EXPECT_FALSE(left.update(12.0, 0.9));
  EXPECT_FALSE(left.update(12.05, 0.91)) << "going on again, at a pace that nobody knows yet";
}

TEST(TimeLeft, NoEstimateForWorkThatHasHardlyBegun) {
  TimeLeft left;
  EXPECT_FALSE(left.update(5.0, 0.0));
  EXPECT_FALSE(left.update(6.0, 0.001));
}

} // namespace
} // namespace voluta::jobs
