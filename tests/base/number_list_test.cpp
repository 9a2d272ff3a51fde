#include "base/number_list.h"

#include <gtest/gtest.h>

using voluta::base::readNumbers;

TEST(NumberList, ReadsJustAsManyNumbersAsAreAskedFor) {
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
