#include "plan/tool_plan.h"
#include "scene/colouring.h"
#include "scene/theme.h"

#include "base/error.h"

#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace {
using namespace voluta::scene;

double distance(const Colour& a, const Colour& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

double luminance(const Colour& c) {
  const auto linear = [](double v) { return std::pow(v, 2.2); };
  return 0.2126 * linear(c[0]) + 0.7152 * linear(c[1]) + 0.0722 * linear(c[2]);
}

TEST(Colouring, TableHasOneRowAQuantityInOrder) {
  const auto& table = colourByTable();
  ASSERT_EQ(table.size(), static_cast<std::size_t>(kColourByCount));
  std::set<std::string_view> ids;
  for (std::size_t i = 0; i < table.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(table[i].colourBy), i);
    EXPECT_EQ(colourByOf(table[i].id), table[i].colourBy);
    ids.insert(table[i].id);
  }
  EXPECT_EQ(ids.size(), table.size());
}

TEST(Colouring, UnknownNameIsAnsweredWithTheNearest) {
  try {
    colourByOf("spede");
    FAIL();
  } catch (const voluta::base::Error& e) {
    EXPECT_EQ(e.code(), voluta::base::ErrorCode::Usage);
    EXPECT_NE(std::string(e.what()).find("speed"), std::string::npos) << e.what();
  }
}

TEST(Colouring, SequentialMapGetsSteadilyLighter) {
  double before = -1.0;
  for (int i = 0; i <= 50; ++i) {
    const double now = luminance(sequentialColour(i / 50.0));
    EXPECT_GT(now, before) << i;
    before = now;
  }
}

TEST(Colouring, DivergingMapIsLightestInTheMiddleAndLimitsContrast) {
  for (int i = 0; i < 25; ++i) {
    EXPECT_LT(luminance(divergingColour(i / 50.0)), luminance(divergingColour((i + 1) / 50.0)));
    EXPECT_LT(luminance(divergingColour(1.0 - i / 50.0)),
              luminance(divergingColour(1.0 - (i + 1) / 50.0)));
  }
  // By lightness alone, independent of the hues.
  EXPECT_GT(luminance(tooThinColour()), 5.0 * luminance(divergingColour(0.0)));
  EXPECT_GT(luminance(tooThickColour()), 5.0 * luminance(divergingColour(1.0)));
}

TEST(Colouring, ReasonsAndStepsAreDistinct) {
  for (const Theme& theme : {lightTheme(), darkTheme()}) {
    const Colour all[] = {theme.blocked, theme.unreached, theme.cascade, theme.current,
                          supportColour()};
    for (std::size_t i = 0; i < std::size(all); ++i) {
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_GT(distance(all[i], all[j]), 0.35) << i << " and " << j;
      for (int s = 0; s <= 50; ++s)
        EXPECT_GT(distance(all[i], sequentialColour(s / 50.0)), 0.2) << i << " at " << s / 50.0;
    }
  }
}

TEST(Colouring, EveryKindOfBeadHasItsOwnColour) {
  for (int i = 0; i < static_cast<int>(voluta::plan::kPathKinds); ++i)
    for (int k = 0; k < i; ++k)
      EXPECT_GT(distance(categoricalColour(i), categoricalColour(k)), 0.25) << i << " and " << k;
}

TEST(Colouring, RedIsReservedForBlockedParts) {
  for (const Theme& theme : {lightTheme(), darkTheme()}) {
    for (int i = 0; i <= 100; ++i)
      EXPECT_GT(distance(sequentialColour(i / 100.0), theme.blocked), 0.45) << i;
    for (int i = 0; i <= 100; ++i)
      EXPECT_GT(distance(divergingColour(i / 100.0), theme.blocked), 0.42) << i;
    for (int i = 0; i < 10; ++i)
      EXPECT_GT(distance(categoricalColour(i), theme.blocked), 0.45) << i;
    for (const Colour& c :
         {theme.part, theme.platform, theme.robotLight, theme.robotDark, theme.head, theme.material,
          theme.marker, theme.axisX, theme.unreached, theme.cascade, theme.current, theme.ghost,
          theme.front, supportColour(), tooThinColour(), tooThickColour()})
      EXPECT_GT(distance(c, theme.blocked), 0.3);
  }
}

} // namespace
