// The commands and settings that the manual and the README show exist.
#include "base/files.h"
#include "pipeline/command_line_fixture.h"
#include "pipeline/stage_options.h"

#include <filesystem>
#include <map>
#include <regex>

namespace voluta::test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> pagesOfUsers() {
  const fs::path root = VOLUTA_SOURCE_DIR;
  std::vector<fs::path> pages{root / "README.md"};
  for (const auto& entry : fs::directory_iterator(root / "docs/manual"))
    pages.push_back(entry.path());
  return pages;
}

std::vector<std::string> found(const std::string& text, const char* pattern, std::size_t group) {
  const std::regex regex(pattern);
  std::vector<std::string> all;
  for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end; ++it)
    all.push_back((*it)[group]);
  return all;
}

TEST(Manual, NamesKnownSettings) {
  const base::ParameterTable table = pipeline::allParameters();
  std::size_t named = 0;
  for (const fs::path& page : pagesOfUsers())
    for (const std::string& key :
         found(base::readFile(page.string()), "--set \"?([A-Za-z.]+)=", 1)) {
      EXPECT_TRUE(table.find(key) || key.starts_with("output.")) << page << ": " << key;
      ++named;
    }
  EXPECT_GT(named, 20u);
}

class ManualCommands : public CommandLine {};

TEST_F(ManualCommands, HaveTheirOptions) {
  std::map<std::string, std::string> help; // by the words before the options
  std::size_t commands = 0;
  for (const fs::path& page : pagesOfUsers())
    for (const std::string& line :
         found(base::readFile(page.string()), "\n[^\n`|#]*voluta-cli ([^\n#>]*)", 1)) {
      std::vector<std::string> words{found(line, "^[a-z-]+", 0).at(0)};
      if (const auto second = found(line, "^(material|process|cell|robot) ([a-z]+)", 2);
          !second.empty())
        words.push_back(second.front());
      std::string& text = help[words.front() + " " + words.back()];
      if (text.empty()) {
        words.emplace_back("--help");
        const Ended ended = run(words);
        ASSERT_EQ(ended.code, 0) << page << ": " << line;
        text = ended.out;
      }
      // What follows -- are options of another command.
      const std::string own = line.substr(0, line.find(" -- "));
      for (const std::string& option : found(own, " (--?[a-z][a-z-]*)", 1))
        EXPECT_NE(text.find(option), std::string::npos) << page << ": " << line << ": " << option;
      ++commands;
    }
  EXPECT_GT(commands, 25u);
}

} // namespace
} // namespace voluta::test
