#include "base/files.h"

#include "base/error.h"
#include "helpers/temporary_folder.h"

#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace fs = std::filesystem;
using namespace voluta::base;

namespace {

class Files : public ::testing::Test {
protected:
  std::size_t entries(const fs::path& where) const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(where), fs::directory_iterator{}));
  }
  const voluta::test::TemporaryFolder folder_;
};

ErrorCode codeOf(const std::function<void()>& f) {
  try {
    f();
  } catch (const Error& e) {
    return e.code();
  }
  ADD_FAILURE() << "no Error was thrown";
  return ErrorCode::Internal;
}

TEST_F(Files, WritesWholeAndReadsBack) {
  const fs::path file = folder_ / "a.txt";
  writeFile(file, "first");
  writeFile(file, std::string(100000, 'x'));
  EXPECT_EQ(readFile(file), std::string(100000, 'x'));
  EXPECT_EQ(entries(folder_.path()), 1u) << "a temporary was left";
}

TEST_F(Files, ReadErrorsNameTheCase) {
  EXPECT_EQ(codeOf([&] { readFile(folder_ / "none"); }), ErrorCode::UnreadableFile);
  EXPECT_EQ(codeOf([&] { readFile(folder_.path()); }), ErrorCode::UnreadableFile);
}

TEST_F(Files, AWriteThatFailsLeavesWhatWasThere) {
  const fs::path file = folder_ / "taken";
  fs::create_directory(file);
  writeFile(file / "inside", "kept");
  EXPECT_EQ(codeOf([&] { writeFile(file, "new"); }), ErrorCode::CannotWrite);
  EXPECT_EQ(readFile(file / "inside"), "kept");
  EXPECT_EQ(entries(folder_.path()), 1u);
  EXPECT_EQ(codeOf([&] { writeFile(folder_ / "no" / "such", "x"); }), ErrorCode::CannotWrite);
}

TEST_F(Files, StagedFolderAppearsOnlyOnCommit) {
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

TEST_F(Files, StagedFolderKeepsStrangersAndReplacesItsOwn) {
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

// In a folder with the sticky bit a file of another user cannot be replaced: "m" is such a one, and
// its turn comes between the others.
TEST_F(Files, ACommitThatFailsLeavesTheTargetAsItWas) {
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

TEST_F(Files, StagedFolderRefusesAFile) {
  writeFile(folder_ / "file", "x");
  EXPECT_EQ(codeOf([&] { StagedFolder staged(folder_ / "file"); }), ErrorCode::CannotWrite);
  EXPECT_EQ(codeOf([&] { StagedFolder staged(folder_ / "file" / "under"); }),
            ErrorCode::CannotWrite);
}

TEST_F(Files, AMissingDataFolderIsToldWhereverItWasSaidToBe) {
  const char* before = std::getenv("VOLUTA_RESOURCES");
  const std::string kept = before ? before : "";
  ::setenv("VOLUTA_RESOURCES", folder_.path().c_str(), 1);
  EXPECT_EQ(resourceFolder(), folder_.path());
  ::setenv("VOLUTA_RESOURCES", (folder_ / "none").c_str(), 1);
  EXPECT_EQ(codeOf([] { resourceFolder(); }), ErrorCode::UnreadableFile);
  if (before)
    ::setenv("VOLUTA_RESOURCES", kept.c_str(), 1);
  else
    ::unsetenv("VOLUTA_RESOURCES");
}

TEST_F(Files, WhatMayNeverEndIsNotRead) {
  for (const char* path : {"/dev/zero", "/dev/null"})
    try {
      readFile(path);
      ADD_FAILURE() << path;
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), ErrorCode::UnreadableFile);
      EXPECT_NE(std::string(e.what()).find("device"), std::string::npos);
    }
}

} // namespace
