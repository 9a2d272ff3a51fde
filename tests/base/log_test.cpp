#include "base/log.h"

#include "base/error.h"
#include "base/files.h"
#include "helpers/temporary_folder.h"

#include <gtest/gtest.h>
#include <string>

namespace voluta::base {
namespace {

TEST(Log, LinesAreInTheFileAtOnce) {
  const test::TemporaryFolder folder;
  const Log log(folder / "deep" / "voluta.log");
  log.write(LogLevel::Info, "opened kitten.stl");
  log.write(LogLevel::Error, "two\nlines");
  const std::string text = readFile(folder / "deep" / "voluta.log");
  EXPECT_NE(text.find("info: opened kitten.stl\n"), std::string::npos) << text;
  EXPECT_NE(text.find("error: two lines\n"), std::string::npos) << text;
}

TEST(Log, AppendsToItsFileAndKeepsAtMostThreeFiles) {
  const test::TemporaryFolder folder;
  for (int run = 0; run < 40; ++run) {
    const Log log(folder / "voluta.log", 1000);
    for (int line = 0; line < 10; ++line)
      log.write(LogLevel::Info, "a line of the log");
  }
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    ++files;
    EXPECT_LE(entry.file_size(), 1000u) << entry.path();
  }
  EXPECT_EQ(files, 3u);
}

TEST(Log, WritesNothingUnlessItHasAFile) {
  EXPECT_NO_THROW(Log().write(LogLevel::Error, "lost"));
  EXPECT_THROW(Log("/proc/no/such/folder/voluta.log"), Error);
}

} // namespace
} // namespace voluta::base
