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

TEST(ShownNumber, AValueBeyondItsLimitReadsBeyondIt) {
  using base::roundedBeyond;
  EXPECT_DOUBLE_EQ(roundedBeyond(96.9996, 97.0, 2), 96.99);
  EXPECT_DOUBLE_EQ(roundedBeyond(97.0, 97.0, 2), 97.0);
  EXPECT_DOUBLE_EQ(roundedBeyond(97.004, 97.0, 2), 97.01);
  EXPECT_DOUBLE_EQ(roundedBeyond(0.9699996, 0.97, 4), 0.9699);
  EXPECT_DOUBLE_EQ(roundedBeyond(0.50001, 0.5, 1), 0.6);
  EXPECT_DOUBLE_EQ(roundedBeyond(94.2049, 97.0, 2), 94.2);
  EXPECT_DOUBLE_EQ(roundedBeyond(0.06, 0.05, 1), 0.1);
  EXPECT_DOUBLE_EQ(roundedBeyond(0.0, 0.0, 2), 0.0);
  for (int i = 0; i < 1000; ++i) {
    const double value = 0.9 + 1e-4 * i + 3e-5;
    for (int decimals = 1; decimals < 6; ++decimals)
      EXPECT_EQ(roundedBeyond(value, 0.97, decimals) < 0.97, value < 0.97) << value;
  }
}

} // namespace
