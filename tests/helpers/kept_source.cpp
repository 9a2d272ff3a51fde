#include "helpers/kept_source.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <iostream>
#include <string>
#include <string_view>

namespace voluta::test {
namespace {

std::string sourceOf(const testing::TestInfo& test) {
  return std::filesystem::path(test.file()).filename().string();
}

bool keepCases(const std::string& source) {
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  std::string filter;
  for (int i = 0; i < all.total_test_suite_count(); ++i) {
    const testing::TestSuite& suite = *all.GetTestSuite(i);
    for (int k = 0; k < suite.total_test_count(); ++k) {
      const testing::TestInfo& test = *suite.GetTestInfo(k);
      if (!sourceOf(test).ends_with("_test.cpp")) {
        std::cerr << sourceOf(test) << ": cases belong in a file named ..._test.cpp\n";
        return false;
      }
      if (sourceOf(test) == source)
        filter += std::string(suite.name()) + "." + test.name() + ":";
    }
  }
  if (filter.empty())
    std::cerr << source << " has no cases\n";
  GTEST_FLAG_SET(filter, filter);
  return !filter.empty();
}

} // namespace

bool keepCasesOfSource(int argc, char** argv) {
  const std::string_view option = "--source=";
  for (int i = 1; i < argc; ++i)
    if (const std::string_view argument = argv[i]; argument.starts_with(option))
      return keepCases(std::string(argument.substr(option.size())));
  return true;
}

} // namespace voluta::test
