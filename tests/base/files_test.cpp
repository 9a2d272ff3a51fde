#include "error_code.h"

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
using voluta::test::codeOf;

namespace {

class Files : public ::testing::Test {
protected:
  std::size_t entries(const fs::path& where) const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(where), fs::directory_iterator{}));
  }
  const voluta::test::TemporaryFolder folder_;
};

TEST_F(Files, WritesWholeAndReadsBack) {
  const fs::path file = folder_ / "a.txt";
  writeFile(file, "first");
  writeFile(file, std::string(100000, 'x'));
  EXPECT_EQ(readFile(file), std::string(100000, 'x'));
  EXPECT_EQ(entries(folder_.path()), 1u) << "a temporary was left";
}

TEST_F(Files, PartsAreOneFile) {
  const std::string_view parts[]{"head\n", {}, "body", std::string_view("\0end", 4)};
  writeFile(folder_ / "a", parts);
  EXPECT_EQ(readFile(folder_ / "a"), std::string("head\nbody\0end", 13));
  EXPECT_EQ(codeOf([&] { writeFile(folder_ / "no" / "such", parts); }), ErrorCode::CannotWrite);
}

TEST_F(Files, ReadErrorsNameTheCase) {
  EXPECT_EQ(codeOf([&] { readFile(folder_ / "none"); }), ErrorCode::UnreadableFile);
  EXPECT_EQ(codeOf([&] { readFile(folder_.path()); }), ErrorCode::UnreadableFile);
}

TEST_F(Files, FailedWriteKeepsExistingContents) {
  const fs::path file = folder_ / "taken";
  fs::create_directory(file);
  writeFile(file / "inside", "kept");
  EXPECT_EQ(codeOf([&] { writeFile(file, "new"); }), ErrorCode::CannotWrite);
  EXPECT_EQ(readFile(file / "inside"), "kept");
  EXPECT_EQ(entries(folder_.path()), 1u);
  EXPECT_EQ(codeOf([&] { writeFile(folder_ / "no" / "such", "x"); }), ErrorCode::CannotWrite);
}

TEST_F(Files, MissingDataFolderIsAnError) {
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

TEST_F(Files, DevicesAreNotRead) {
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
