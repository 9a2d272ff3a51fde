#include "base/shown_number.h"
#include "base/text.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <string>

using namespace voluta;
using namespace voluta::literals;

namespace {

std::string shown(double value) {
  return base::english(base::message("{area:.3g}"_text, base::mm2(value)));
}

TEST(ShownNumber, KeepsItsDigitsAndHasNoPowerOfTen) {
  EXPECT_EQ(shown(3484.2), "3480 mm2");
  EXPECT_EQ(shown(-3484.2), "-3480 mm2");
  EXPECT_EQ(shown(1234567.0), "1230000 mm2");
  EXPECT_EQ(shown(999.6), "1000 mm2");
  EXPECT_EQ(shown(12.0), "12 mm2");
  EXPECT_EQ(shown(100.0), "100 mm2");
  EXPECT_EQ(shown(0.1204), "0.12 mm2");
  EXPECT_EQ(shown(0.0000123), "0.0000123 mm2");
  EXPECT_EQ(shown(0.99996), "1 mm2");
  EXPECT_EQ(shown(0.0), "0 mm2");
  EXPECT_EQ(shown(-1e-12), "0 mm2");
}

TEST(ShownNumber, OfNoEndIsShownAsItIs) {
  EXPECT_EQ(shown(std::numeric_limits<double>::infinity()), "inf mm2");
  EXPECT_TRUE(std::isnan(base::shownNumber(std::nan(""), 3).value));
}

TEST(ShownNumber, OfNoFormatHasSixDigits) {
  EXPECT_EQ(base::english(base::message("{n}"_text, base::number(12345678.0))), "12345700");
  EXPECT_EQ(base::english(base::message("{n}"_text, base::number(0.05))), "0.05");
}

} // namespace
