// Programs run to their end, or to the end of their input.
#include "base/child_process.h"

#include <chrono>
#include <gtest/gtest.h>

namespace voluta::base {
namespace {

using End = ChildResult::End;
using std::chrono::milliseconds;

ChildResult shell(const std::string& command, const ChildLimits& limits = {}) {
  return runChild("/bin/sh", {"-c", command}, limits);
}

TEST(ChildProcess, GivesItsOutputAndItsCode) {
  const ChildResult said = shell("printf 'a b'; exit 3");
  EXPECT_EQ(said.end, End::Exited);
  EXPECT_EQ(said.code, 3);
  EXPECT_EQ(said.output, "a b");
  const ChildResult large = shell("head -c 300000 /dev/zero");
  EXPECT_EQ(large.output.size(), 300000u);
  EXPECT_EQ(shell("cat").end, End::Exited); // its input is at its end
}

TEST(ChildProcess, EndsBadlyWithoutTakingItsCallerAlong) {
  EXPECT_EQ(shell("kill -SEGV $$").end, End::Crashed);
  EXPECT_EQ(runChild("/nowhere/program", {}, {}).end, End::NotStarted);
}

TEST(ChildProcess, IsKilledAtItsLimits) {
  const auto begun = std::chrono::steady_clock::now();
  EXPECT_EQ(shell("sleep 60", {.time = milliseconds(200)}).end, End::TimedOut);
  // Silent, its output closed, and still there.
  EXPECT_EQ(shell("exec >&-; sleep 60", {.time = milliseconds(200)}).end, End::TimedOut);
  EXPECT_EQ(shell("cat /dev/zero", {.time = milliseconds(20000), .bytes = 1000}).end,
            End::TooMuchOutput);
  EXPECT_LT(std::chrono::steady_clock::now() - begun, std::chrono::seconds(40));
}

TEST(ChildProcess, IsKilledOnceItIsCancelled) {
  int asked = 0;
  const auto afterTwo = [&asked] { return ++asked > 2; };
  EXPECT_EQ(shell("sleep 60", {.cancelled = afterTwo}).end, End::Cancelled);
  EXPECT_EQ(asked, 3);
  asked = 0; // Silent, its output closed
  EXPECT_EQ(shell("exec >&-; sleep 60", {.cancelled = afterTwo}).end, End::Cancelled);
  EXPECT_EQ(shell("printf a", {.cancelled = [] { return false; }}).output, "a");
}

} // namespace
} // namespace voluta::base
