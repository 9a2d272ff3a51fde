// Sets of files come whole or not at all, whenever the process that writes them is killed.
#include "error_code.h"

#include "base/staged_folder.h"

#include "base/error.h"
#include "base/files.h"
#include "helpers/all_seeds.h"
#include "helpers/temporary_folder.h"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <filesystem>
#include <functional>
#include <gtest/gtest.h>
#include <map>
#include <random>
#include <set>
#include <string>
#include <sys/ptrace.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace fs = std::filesystem;
using namespace voluta::base;
using voluta::test::codeOf;

namespace {

class StagedFolders : public ::testing::Test {
protected:
  std::size_t entries(const fs::path& where) const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(where), fs::directory_iterator{}));
  }
  const voluta::test::TemporaryFolder folder_;
};

TEST_F(StagedFolders, AppearOnlyOnCommit) {
  const fs::path target = folder_ / "deep" / "out";
  {
    StagedFolder staged(target);
    writeFile(staged.path() / "a", "1");
    EXPECT_FALSE(fs::exists(target));
  }
  EXPECT_FALSE(fs::exists(target));
  EXPECT_EQ(entries(folder_.path()), 0u) << "folders made for staging stay behind";
  {
    StagedFolder staged(target);
    writeFile(staged.path() / "a", "2");
    staged.commit();
  }
  EXPECT_EQ(readFile(target / "a"), "2");
  EXPECT_EQ(entries(target.parent_path()), 1u);
}

TEST_F(StagedFolders, KeepStrangersAndReplaceTheirOwn) {
  const fs::path target = folder_ / "out";
  fs::create_directory(target);
  writeFile(target / "notes", "mine");
  writeFile(target / "a", "old");
  {
    StagedFolder staged(target);
    writeFile(staged.path() / "a", "new");
  }
  EXPECT_EQ(readFile(target / "a"), "old");
  StagedFolder staged(target);
  writeFile(staged.path() / "a", "new");
  staged.commit();
  EXPECT_EQ(readFile(target / "a"), "new");
  EXPECT_EQ(readFile(target / "notes"), "mine");
}

TEST_F(StagedFolders, ReplaceNoFolder) {
  const fs::path target = folder_ / "out";
  fs::create_directories(target / "part.script" / "photos");
  writeFile(target / "part.script" / "photos" / "a.jpg", "mine");
  writeFile(target / "a", "old");
  StagedFolder staged(target);
  writeFile(staged.path() / "a", "new");
  writeFile(staged.path() / "part.script", "new");
  EXPECT_EQ(codeOf([&] { staged.commit(); }), ErrorCode::CannotWrite);
  EXPECT_EQ(readFile(target / "a"), "old");
  EXPECT_EQ(readFile(target / "part.script" / "photos" / "a.jpg"), "mine");
}

TEST_F(StagedFolders, KeepFilesInTheirFolders) {
  const fs::path target = folder_ / "out";
  fs::create_directories(target / "machine1");
  writeFile(target / "machine1" / "notes", "mine");
  writeFile(target / "machine1" / "a", "old");
  StagedFolder staged(target);
  fs::create_directories(staged.path() / "machine1");
  writeFile(staged.path() / "machine1" / "a", "new");
  writeFile(staged.path() / "machine1" / "b", "new");
  EXPECT_EQ(staged.replaced(), std::vector{target / "machine1" / "a"});
  staged.commit();
  EXPECT_EQ(readFile(target / "machine1" / "notes"), "mine");
  EXPECT_EQ(readFile(target / "machine1" / "a"), "new");
  EXPECT_EQ(readFile(target / "machine1" / "b"), "new");
}

// In a folder with the sticky bit a file of another user cannot be replaced: "m" is such a one, and
// its turn comes between the others.
TEST_F(StagedFolders, ACommitThatFailsLeavesTheTargetAsItWas) {
  constexpr uid_t kNobody = 65534;
  if (::geteuid() != 0)
    GTEST_SKIP() << "only root can be two users";
  const fs::path target = folder_ / "out";
  fs::create_directory(target);
  for (const char* name : {"a", "m", "z"})
    writeFile(target / name, "old");
  for (const fs::path& file : {target / "a", target / "z"})
    ASSERT_EQ(::chown(file.c_str(), kNobody, kNobody), 0);
  ASSERT_EQ(::chmod(folder_.path().c_str(), 0777), 0);
  ASSERT_EQ(::chmod(target.c_str(), 01777), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    if (::setuid(kNobody) != 0)
      ::_exit(1);
    try {
      StagedFolder staged(target);
      for (const char* name : {"a", "b", "m", "z"})
        writeFile(staged.path() / name, "new");
      staged.commit();
    } catch (const Error& error) {
      ::_exit(error.code() == ErrorCode::CannotWrite ? 7 : 2);
    }
    ::_exit(0);
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(WEXITSTATUS(status), 7);
  for (const char* name : {"a", "m", "z"})
    EXPECT_EQ(readFile(target / name), "old") << name;
  EXPECT_EQ(entries(target), 3u);
  EXPECT_EQ(entries(folder_.path()), 1u) << "staged files stay behind";
}

// A process that is cancelled ends while its threads still write.
TEST_F(StagedFolders, DiscardedWhileAThreadWritesNothingIsLeft) {
  for (int trial = 0; trial < 20; ++trial) {
    StagedFolder staged(folder_ / "out");
    std::atomic<bool> began = false;
    std::thread writer([&] {
      try {
        for (int file = 0;; ++file) {
          fs::create_directory(staged.path() / "pieces");
          writeFile(staged.path() / "pieces" / std::to_string(file), "1");
          began = true;
        }
      } catch (const std::exception&) { // The folder does not exist any more
      }
    });
    while (!began)
      std::this_thread::yield();
    staged.discard();
    writer.join();
    ASSERT_EQ(entries(folder_.path()), 0u);
  }
}

TEST_F(StagedFolders, RefuseAFile) {
  writeFile(folder_ / "file", "x");
  EXPECT_EQ(codeOf([&] { StagedFolder staged(""); }), ErrorCode::CannotWrite);
  EXPECT_EQ(codeOf([&] { StagedFolder staged(folder_ / "file"); }), ErrorCode::CannotWrite);
  EXPECT_EQ(codeOf([&] { StagedFolder staged(folder_ / "file" / "under"); }),
            ErrorCode::CannotWrite);
}

// ---- a process that is killed

// Of a set, files and a folder; the second has fewer parts and another one.
void exportSet(const fs::path& target, const std::string& content, int parts) {
  StagedFolder staged(target);
  for (int part = 0; part < parts; ++part)
    writeFile(staged.path() / ("part_" + std::to_string(part) + ".mod"), content);
  fs::create_directory(staged.path() / "pieces");
  writeFile(staged.path() / "pieces" / "0.stl", content);
  writeFile(staged.path() / "report.json", content);
  staged.commit();
}

using Contents = std::map<std::string, std::string>;
Contents contentsOf(const fs::path& folder) {
  Contents contents;
  if (fs::exists(folder))
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (entry.is_regular_file())
        contents[fs::relative(entry.path(), folder).string()] = readFile(entry.path());
  return contents;
}

// Runs `work` in a child that is killed before the system call number `killAt` (0: never) of it.
// How many there were; -1: a child cannot be watched here.
long systemCalls(const std::function<void()>& work, long killAt) {
  const pid_t child = ::fork();
  if (child == 0) {
    if (::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0)
      ::_exit(9);
    ::raise(SIGSTOP);
    work();
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  if (!WIFSTOPPED(status))
    return -1;
  ::ptrace(PTRACE_SETOPTIONS, child, nullptr, PTRACE_O_TRACESYSGOOD | PTRACE_O_EXITKILL);
  long calls = 0;
  for (bool entry = true;; entry = !entry) {
    ::ptrace(PTRACE_SYSCALL, child, nullptr, nullptr);
    ::waitpid(child, &status, 0);
    if (!WIFSTOPPED(status))
      return calls;
    if (entry && ++calls == killAt) {
      ::kill(child, SIGKILL);
      ::waitpid(child, &status, 0);
      return calls;
    }
  }
}

// The set that is there, whole and with the strangers; 0: neither.
int setOf(const Contents& there, const Contents& old, const Contents& fresh) {
  return there == old ? 1 : there == fresh ? 2 : 0;
}

TEST_F(StagedFolders, KilledAtAnyMomentTheyLeaveOneWholeSet) {
  const auto make = [](const fs::path& target) {
    fs::create_directory(target);
    writeFile(target / "notes.txt", "mine");
    fs::create_directory(target / "photos");
    writeFile(target / "photos" / "a.jpg", "mine");
    exportSet(target, "old", 5);
  };
  const auto exportNew = [](const fs::path& target) { exportSet(target, "new", 7); };
  const fs::path whole = folder_ / "whole";
  make(whole);
  const Contents old = contentsOf(whole);
  const long calls = systemCalls([&] { exportNew(whole); }, 0);
  if (calls < 0)
    GTEST_SKIP() << "no process may be watched here";
  const Contents fresh = contentsOf(whole);
  ASSERT_NE(fresh, old);
  ASSERT_GT(calls, 100);

  std::mt19937 random(50);
  std::set<long> moments;
  // Half of them anywhere, half in the last third, where the set is moved.
  const std::size_t count = test::ofSeeds(16u, 50u);
  while (moments.size() < count / 2)
    moments.insert(1 + static_cast<long>(random() % static_cast<unsigned>(calls)));
  while (moments.size() < count)
    moments.insert(calls - static_cast<long>(random() % static_cast<unsigned>(calls / 3)));
  int oldSets = 0, newSets = 0, broken = 0;
  for (const long moment : moments) {
    const std::string name = std::to_string(moment);
    const fs::path target = folder_ / name / "out";
    fs::create_directory(folder_ / name);
    make(target);
    systemCalls([&] { exportNew(target); }, moment);
    Contents there = contentsOf(target);
    // Before the next process, an incomplete set is marked by a note.
    const bool noted = there.erase(std::string(kUnfinishedNote)) > 0;
    if (setOf(there, old, fresh) == 0) {
      ++broken;
      EXPECT_TRUE(noted) << "system call " << moment;
    }
    finishStaged(target);
    const int set = setOf(contentsOf(target), old, fresh);
    EXPECT_NE(set, 0) << "system call " << moment << " of " << calls;
    (set == 1 ? oldSets : newSets) += 1;
    EXPECT_EQ(entries(folder_ / name), 1u) << "something is left of call " << moment;
    exportNew(target);
    EXPECT_EQ(contentsOf(target), fresh) << "system call " << moment;
  }
  EXPECT_GT(oldSets, 0);
  EXPECT_GT(newSets, 0);
  EXPECT_GT(broken, 0) << "no moment was hard";
}

TEST_F(StagedFolders, KilledWhileAFolderIsMadeThereIsNoneOrAWholeOne) {
  const auto exportNew = [](const fs::path& target) { exportSet(target, "new", 4); };
  const long calls = systemCalls([&] { exportNew(folder_ / "whole"); }, 0);
  if (calls < 0)
    GTEST_SKIP() << "no process may be watched here";
  const Contents fresh = contentsOf(folder_ / "whole");
  int whole = 0;
  for (int k = 0; k < 50; ++k) {
    const long moment = 1 + k * (calls - 1) / 49;
    const fs::path above = folder_ / std::to_string(k), target = above / "out";
    fs::create_directory(above);
    systemCalls([&] { exportNew(target); }, moment);
    // Nobody has to come first.
    EXPECT_EQ(setOf(contentsOf(target), {}, fresh), fs::exists(target) ? 2 : 1) << moment;
    whole += fs::exists(target) ? 1 : 0;
    finishStaged(target);
    EXPECT_EQ(entries(above), fs::exists(target) ? 1u : 0u) << moment;
  }
  EXPECT_GT(whole, 0);
  EXPECT_LT(whole, 50);
}

TEST_F(StagedFolders, OneThatIsBeingFilledIsLeftAlone) {
  const fs::path target = folder_ / "out";
  exportSet(target, "old", 2);
  StagedFolder staged(target);
  writeFile(staged.path() / "a", "1");
  EXPECT_FALSE(finishStaged(target));
  EXPECT_TRUE(fs::exists(staged.path() / "a"));
  StagedFolder other(target);
  EXPECT_TRUE(fs::exists(staged.path() / "a"));
  staged.commit();
  EXPECT_EQ(readFile(target / "a"), "1");
}

TEST_F(StagedFolders, FoldersOfOthersWithSuchNamesStay) {
  fs::create_directory(folder_ / ".out.backup");
  writeFile(folder_ / ".out.backup" / "a", "mine");
  exportSet(folder_ / "out", "new", 1);
  exportSet(folder_ / "out", "newer", 1);
  EXPECT_EQ(readFile(folder_ / ".out.backup" / "a"), "mine");
}

} // namespace
