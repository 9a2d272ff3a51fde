// What a source file may include (DESIGN section 2).
#include "base/files.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <regex>

namespace voluta {
namespace {

std::vector<std::filesystem::path> sources(const std::string& folder) {
  std::vector<std::filesystem::path> files;
  // Symbolic links are followed: a checkout may be put together from several places.
  for (const auto& entry : std::filesystem::recursive_directory_iterator(
           std::filesystem::path(VOLUTA_SOURCE_DIR) / folder,
           std::filesystem::directory_options::follow_directory_symlink)) {
    const auto extension = entry.path().extension();
    if (extension == ".h" || extension == ".cpp")
      files.push_back(entry.path());
  }
  return files;
}

std::vector<std::string> offenders(const std::string& folder, const std::regex& forbidden) {
  std::vector<std::string> found;
  for (const auto& file : sources(folder))
    if (std::regex_search(base::readFile(file), forbidden))
      found.push_back(file.string());
  return found;
}

TEST(House, CoreIncludesNeitherQtNorVtk) {
  ASSERT_GT(sources("core").size(), 30u);
  EXPECT_TRUE(offenders("core", std::regex(R"(#\s*include\s*[<"](Q[A-Z]|Qt|vtk))")).empty());
}

TEST(House, ReplayIncludesNoPlanner) {
  ASSERT_GT(sources("core/replay").size(), 10u);
  EXPECT_TRUE(offenders("core/replay",
                        std::regex(R"(#\s*include\s*[<"]()"
                                   R"((collision|toolpath|motion|layers|curved|planar|substrate|)"
                                   R"(support|placement|pipeline)/|fcl|ompl))"))
                  .empty());
}

TEST(House, TheScanSeesWhatItLooksFor) {
  EXPECT_TRUE(std::regex_search(std::string("#include <QString>"),
                                std::regex(R"(#\s*include\s*[<"](Q[A-Z]|Qt|vtk))")));
}

} // namespace
} // namespace voluta
