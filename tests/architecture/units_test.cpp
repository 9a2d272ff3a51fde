// A source with its header is one unit: how long files are, and that no more than two units need
// one another.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

const fs::path kRoot = VOLUTA_SOURCE_DIR;

bool isSource(const fs::path& file) {
  return file.extension() == ".h" || file.extension() == ".cpp";
}

std::vector<fs::path> sourcesBelow(const std::vector<std::string>& folders) {
  std::vector<fs::path> files;
  for (const std::string& folder : folders)
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder))
      if (entry.is_regular_file() && isSource(entry.path()))
        files.push_back(entry.path());
  return files;
}

TEST(Units, NoFileHasMoreThanSixHundredLines) {
  constexpr long kMaxLines = 600;
  const std::vector<fs::path> files = sourcesBelow({"core", "widgets", "app", "tests"});
  ASSERT_GT(files.size(), 500u);
  for (const fs::path& file : files) {
    std::ifstream in(file);
    const long lines =
        std::count(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>(), '\n');
    EXPECT_LE(lines, kMaxLines) << file;
  }
}

// In the tab of an editor, the name identifies the file.
TEST(Units, EachFileHasANameOfItsOwn) {
  std::map<std::string, fs::path> files;
  for (const fs::path& file : sourcesBelow({"core", "widgets", "app", "tests"})) {
    const auto [other, isNew] = files.emplace(file.filename().string(), file);
    EXPECT_TRUE(isNew) << file << " is named like " << other->second;
  }
}

// A file of tests that no list has is never built, and nobody misses it.
TEST(Units, EachFileOfTestsIsListed) {
  static const std::regex kTests("(.+)_test");
  std::size_t count = 0;
  for (const fs::path& file : sourcesBelow({"tests"})) {
    const std::string stem = file.stem().string();
    std::smatch name;
    if (!std::regex_match(stem, name, kTests))
      continue;
    ++count;
    std::ifstream in(file.parent_path() / "CMakeLists.txt");
    const std::string list{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    // By its name, or without the ending.
    const std::regex listed("(^|[\\s(])" + name[1].str() + "(_test\\.cpp)?($|[\\s)])");
    EXPECT_TRUE(std::regex_search(list, listed)) << file;
  }
  EXPECT_GT(count, 400u);
}

// A unit by its path without the ending, and those whose headers it includes.
using Units = std::map<std::string, std::set<std::string>>;

Units unitsOf(const std::vector<std::string>& folders) {
  static const std::regex kInclude(R"(^\s*#\s*include\s*\"([^\"]+)\")");
  const auto unit = [](fs::path file) {
    return fs::relative(file.replace_extension(), kRoot).generic_string();
  };
  Units units;
  const std::vector<fs::path> files = sourcesBelow(folders);
  for (const fs::path& file : files)
    units[unit(file)];
  for (const fs::path& file : files) {
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
      std::smatch match;
      if (!std::regex_search(line, match, kInclude))
        continue;
      for (const std::string& folder : folders) {
        const std::string other = unit(kRoot / folder / match[1].str());
        if (units.count(other) && other != unit(file)) {
          units[unit(file)].insert(other);
          break;
        }
      }
    }
  }
  return units;
}

// Sets of units each of which leads to all others of its set (Tarjan 1972), of two or more.
std::vector<std::vector<std::string>> circlesOf(const Units& units) {
  std::map<std::string, int> number, lowest;
  std::vector<std::string> stack;
  std::set<std::string> onStack;
  std::vector<std::vector<std::string>> circles;
  const std::function<void(const std::string&)> visit = [&](const std::string& unit) {
    number[unit] = lowest[unit] = static_cast<int>(number.size());
    stack.push_back(unit);
    onStack.insert(unit);
    for (const std::string& next : units.at(unit)) {
      if (!number.count(next))
        visit(next);
      if (onStack.count(next))
        lowest[unit] = std::min(lowest[unit], lowest[next]);
    }
    if (lowest[unit] != number[unit])
      return;
    std::vector<std::string> circle;
    do {
      circle.push_back(stack.back());
      onStack.erase(stack.back());
      stack.pop_back();
    } while (circle.back() != unit);
    if (circle.size() > 1)
      circles.push_back(std::move(circle));
  };
  for (const auto& [unit, includes] : units)
    if (!number.count(unit))
      visit(unit);
  return circles;
}

TEST(Units, CirclesAreFound) {
  const Units units = {{"a", {"b"}}, {"b", {"c", "d"}}, {"c", {"a"}}, {"d", {"e"}}, {"e", {}}};
  const auto circles = circlesOf(units);
  ASSERT_EQ(circles.size(), 1u);
  EXPECT_EQ(circles[0].size(), 3u);
}

TEST(Units, NoMoreThanTwoNeedOneAnother) {
  const Units units = unitsOf({"core", "widgets", "app", "app/cli"});
  ASSERT_GT(units.size(), 300u);
  for (const auto& circle : circlesOf(units)) {
    std::string names;
    for (const std::string& unit : circle)
      names += " " + unit;
    EXPECT_LE(circle.size(), 2u) << names;
  }
}

} // namespace
