#include "program/common/program_text.h"
#include "program/dialect.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace voluta::program {
namespace {

std::string fixed(double value, int decimals, bool trim = false) {
  std::string out;
  appendFixed(out, value, decimals, trim);
  return out;
}

TEST(Text, numbersHaveNoExponentAndNoMinusZero) {
  EXPECT_EQ(fixed(0.0, 3), "0.000");
  EXPECT_EQ(fixed(-0.0004, 3), "0.000");
  EXPECT_EQ(fixed(-0.0006, 3), "-0.001");
  EXPECT_EQ(fixed(12.5, 0), "13");
  EXPECT_EQ(fixed(1e-7, 7), "0.0000001");
  EXPECT_EQ(fixed(-123456.789, 3), "-123456.789");
  EXPECT_EQ(fixed(0.5, 7, true), "0.5");
  EXPECT_EQ(fixed(20.0, 7, true), "20");
  EXPECT_EQ(fixed(0.0, 7, true), "0");
  EXPECT_EQ(fixed(100.0, 0, true), "100");
}

TEST(Text, numbersAreParsedBack) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(-1e4, 1e4);
  for (int n = 0; n < 10000; ++n) {
    const double value = uniform(random);
    const int decimals = n % 8;
    double back = 0.0;
    ASSERT_TRUE(parseNumber(fixed(value, decimals, n % 2), back));
    EXPECT_NEAR(back, value, 0.5001 * std::pow(10.0, -decimals));
    EXPECT_DOUBLE_EQ(back, roundedTo(value, decimals));
  }
}

TEST(Text, onlyNumbersAreNumbers) {
  double value = 0.0;
  for (const char* bad : {"", "+", "-", "1.2.3", "1e", "nan", "inf", "-inf", "0x10", "1 2", "++1",
                          "1e999", "--1", "+-1"})
    EXPECT_FALSE(parseNumber(bad, value)) << bad;
  EXPECT_TRUE(parseNumber("+1.5e1", value));
  EXPECT_EQ(value, 15.0);
}

TEST(Text, namesAreNamesForEveryController) {
  EXPECT_EQ(identifierOf("kitten"), "kitten");
  EXPECT_EQ(identifierOf("bunny 7k.v2"), "bunny_7k_v2");
  EXPECT_EQ(identifierOf("3d"), "p3d");
  EXPECT_EQ(identifierOf(""), "p");
  EXPECT_EQ(identifierOf(std::string(50, 'x')).size(), 31u);
}

TEST(Text, marksInQuotesAreText) {
  EXPECT_EQ(findUnquoted("a = 1 # one", "#"), 6u);
  EXPECT_EQ(findUnquoted("#", "#"), 0u);
  EXPECT_EQ(findUnquoted("say(\"#1\", \"#2\") # said", "#"), 16u);
  EXPECT_EQ(findUnquoted("say(\"a // b\") / 2 // c", "//"), 18u);
  EXPECT_EQ(findUnquoted("a # \"b\" # c", "#"), 2u);
  for (const char* without : {"", "plain", "say(\"#\")", "left open \"# 1", "\"\"\"#"})
    EXPECT_EQ(findUnquoted(without, "#"), std::string_view::npos) << without;
}

TEST(Text, linesEndInAnyWay) {
  LineReader lines("a\r\n\nb\nc");
  std::string_view line;
  std::string all;
  while (lines.next(line))
    all += std::to_string(lines.number()) + std::string(line) + ",";
  EXPECT_EQ(all, "1a,2,3b,4c,");
}

TEST(Text, defectsAreBounded) {
  std::vector<plan::ProgramDefect> list;
  Defects defects(list);
  for (int i = 0; i < 5000; ++i)
    defects.add(0, 1, "bad"_text);
  EXPECT_EQ(list.size(), kMaxDefects);
}

} // namespace
} // namespace voluta::program
