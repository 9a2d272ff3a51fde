#include "base/number_list.h"

#include "base/error.h"

#include <gtest/gtest.h>

using voluta::base::readNumbers;

TEST(NumberList, ReadsExactlyTheRequestedCountOfNumbers) {
  double a = 0.0, b = 0.0, c = 0.0;
  EXPECT_TRUE(readNumbers("5x200", 'x', {&a, &b}));
  EXPECT_EQ(a, 5.0);
  EXPECT_EQ(b, 200.0);
  EXPECT_TRUE(readNumbers(" 1 , -2.5,3e1 ", ',', {&a, &b, &c}));
  EXPECT_EQ(b, -2.5);
  EXPECT_EQ(c, 30.0);
  EXPECT_TRUE(readNumbers("7", ',', {&a}));
  for (const char* text :
       {"", "5", "5x", "x5", "5x200x1", "5 x 2 0", "5y200", "nanx1", "1xinf", "5xx200", "5x200,"})
    EXPECT_FALSE(readNumbers(text, 'x', {&a, &b})) << text;
}

TEST(NumberList, ReadsRowsOfATableWithAnySeparator) {
  using Rows = std::vector<std::vector<double>>;
  using voluta::base::readRows;
  EXPECT_EQ(readRows("1,2,3\n\n# what\n4; 5 ;6\r\n-7\t8e1 .5 # last", "t"),
            (Rows{{1, 2, 3}, {4, 5, 6}, {-7, 80, 0.5}}));
  EXPECT_EQ(readRows("", "t"), Rows{});
  for (const char* text : {"1,2\n3", "1,x", "1,nan", "1,2\n3,1e999", "1 2,3.4.5"})
    EXPECT_THROW(readRows(text, "t"), voluta::base::Error) << text;
  try {
    readRows("1,2\n\n3,z", "points.csv");
    FAIL();
  } catch (const voluta::base::Error& e) {
    EXPECT_EQ(std::string(e.what()), "points.csv, line 3: 'z' is not a number");
  }
}
