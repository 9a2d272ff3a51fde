#include "base/files.h"

#include "base/error.h"
#include "helpers/temporary_folder.h"

#include <filesystem>
#include <gtest/gtest.h>

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

TEST_F(Files, StagedFolderRefusesAFile) {
  writeFile(folder_ / "file", "x");
  EXPECT_EQ(codeOf([&] { StagedFolder staged(folder_ / "file"); }), ErrorCode::CannotWrite);
  EXPECT_EQ(codeOf([&] { StagedFolder staged(folder_ / "file" / "under"); }),
            ErrorCode::CannotWrite);
}

} // namespace
