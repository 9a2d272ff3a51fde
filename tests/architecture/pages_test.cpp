// The project's pages and references to them: a comment that names a page names an existing one; a
// page that names a file, a test or another page does too.
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

const fs::path kRoot = VOLUTA_SOURCE_DIR;

std::string textOf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

bool isSource(const fs::path& file) {
  static const std::set<std::string> kEndings{".h", ".cpp", ".in", ".txt", ".cmake"};
  return kEndings.count(file.extension().string()) > 0;
}

std::vector<fs::path> sources() {
  std::vector<fs::path> files;
  for (const char* folder : {"core", "app", "widgets", "tests", "cmake"})
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder))
      if (entry.is_regular_file() && isSource(entry.path()) &&
          entry.path().filename() != "pages_test.cpp")
        files.push_back(entry.path());
  return files;
}

std::vector<fs::path> pages() {
  std::vector<fs::path> files{kRoot / "README.md", kRoot / "CONTRIBUTING.md",
                              kRoot / "CHANGELOG.md"};
  for (const auto& entry : fs::recursive_directory_iterator(kRoot / "docs"))
    if (entry.path().extension() == ".md")
      files.push_back(entry.path());
  return files;
}

std::vector<std::smatch> all(const std::string& text, const std::regex& pattern) {
  return {std::sregex_iterator(text.begin(), text.end(), pattern), std::sregex_iterator()};
}

std::set<std::string> headings(const fs::path& page) {
  std::set<std::string> found;
  const std::string text = textOf(page);
  for (const std::smatch& m : all(text, std::regex("(?:^|\n)#+ ([^\n]+)")))
    found.insert(m[1]);
  return found;
}

// "(docs/design.md, Errors)": the page, and one of its headings.
TEST(Pages, PagesCitedInCommentsExist) {
  const std::regex page(R"(([A-Za-z0-9_/.-]*[A-Za-z0-9_]\.md)(, ([A-Z][A-Za-z ]*[a-z]))?)");
  std::size_t cited = 0;
  for (const fs::path& file : sources()) {
    const std::string text = textOf(file);
    for (const char* word : {"DESIGN \u00a7", "references/", "references:"})
      EXPECT_EQ(text.find(word), std::string::npos) << file << " cites '" << word << "'";
    if (text.find(".md") == std::string::npos)
      continue;
    for (const std::smatch& m : all(text, page)) {
      const fs::path named = kRoot / m[1].str();
      EXPECT_TRUE(fs::is_regular_file(named)) << file << " cites " << m[1];
      if (m[3].matched) {
        EXPECT_TRUE(headings(named).count(m[3]))
            << file << ": " << m[1] << " has no heading '" << m[3] << "'";
      }
      ++cited;
    }
  }
  EXPECT_GT(cited, 20u);
}

TEST(Pages, LinkedFilesExist) {
  const std::regex link(R"(\]\(([^)#\s]+)[^)]*\))");
  for (const fs::path& page : pages()) {
    const std::string text = textOf(page);
    EXPECT_FALSE(text.empty()) << page;
    for (const std::smatch& m : all(text, link))
      if (const std::string to = m[1]; to.find("://") == std::string::npos) {
        EXPECT_TRUE(fs::exists(page.parent_path() / to)) << page << " links to " << to;
      }
  }
}

// `core/curved`, `core/curved/grow.cpp` or, without the ending, `core/curved/grow`.
TEST(Pages, PathsTheyNameAreThere) {
  const std::regex path("`((?:core|app|widgets|tests|resources|packaging|translations)/"
                        "[A-Za-z0-9_./-]+)");
  for (const fs::path& page : pages()) {
    const std::string text = textOf(page);
    for (const std::smatch& m : all(text, path)) {
      const std::string name = m[1];
      EXPECT_TRUE(fs::exists(kRoot / name) || fs::exists(kRoot / (name + ".h")) ||
                  fs::exists(kRoot / (name + ".cpp")))
          << page << " names " << name;
    }
  }
}

std::size_t filesIn(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(Pages, TheReadmeCountsRobotsAndCells) {
  const std::string text = textOf(kRoot / "README.md");
  std::smatch counts;
  ASSERT_TRUE(std::regex_search(text, counts, std::regex(R"((\d+) robots in (\d+) cells)")));
  EXPECT_EQ(std::stoul(counts[1]), filesIn(kRoot / "resources" / "robots"));
  EXPECT_EQ(std::stoul(counts[2]), filesIn(kRoot / "resources" / "cells"));
}

// In "Code and tests" of an algorithm: files by their stem, tests as `Suite.Name` or `Suite.*`.
TEST(Pages, AlgorithmsNameCodeAndTestsThatAreThere) {
  std::set<std::string> stems, tests, suites;
  const std::regex declared(R"(\bTEST(?:_F|_P)?\(\s*(\w+)\s*,\s*(\w+)\s*\))");
  for (const fs::path& file : sources()) {
    stems.insert(file.stem().string());
    const std::string text = textOf(file);
    if (text.find("TEST") == std::string::npos)
      continue;
    for (const std::smatch& m : all(text, declared)) {
      suites.insert(m[1]);
      tests.insert(m[1].str() + "." + m[2].str());
    }
  }
  const std::regex ticked("`([^`\n]+)`"), test(R"([A-Z]\w+\.(\*|\w+))"), stem("[a-z0-9_]+");
  for (const auto& entry : fs::directory_iterator(kRoot / "docs" / "algorithms")) {
    if (entry.path().filename() == "README.md")
      continue;
    const std::string text = textOf(entry.path());
    const std::size_t from = text.find("## Code and tests");
    ASSERT_NE(from, std::string::npos) << entry.path();
    const std::string part = text.substr(from);
    for (const std::smatch& m : all(part, ticked)) {
      const std::string name = m[1];
      if (std::regex_match(name, test)) {
        const bool isSuite = name.ends_with(".*");
        EXPECT_TRUE(isSuite ? suites.count(name.substr(0, name.size() - 2)) : tests.count(name))
            << entry.path() << " names test " << name;
      } else if (std::regex_match(name, stem) && name.find('_') != std::string::npos) {
        EXPECT_TRUE(stems.count(name)) << entry.path() << " names " << name;
      }
    }
  }
}

} // namespace
