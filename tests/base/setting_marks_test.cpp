#include "base/setting_marks.h"
#include "base/text.h"

#include <gtest/gtest.h>

using namespace voluta;

TEST(SettingMarks, AreReplacedOrLeftOutWithTheirParentheses) {
  const char* sentence = "set `brimWidthMm` (`orient=none`), or give units (`--units`)";
  EXPECT_EQ(base::settingsIn(sentence),
            (std::vector<std::string>{"brimWidthMm", "orient=none", "--units"}));
  EXPECT_EQ(base::withSettingsAsTyped(sentence),
            "set brimWidthMm (orient=none), or give units (--units)");
  EXPECT_EQ(base::withSettings(sentence,
                               [](std::string_view setting) {
                                 return std::string(setting.starts_with("--") ? "" : "X");
                               }),
            "set X (X), or give units");
  EXPECT_EQ(base::withSettings("`a`b", [](std::string_view) { return std::string(); }), "b");
  EXPECT_EQ(base::withSettingsAsTyped("one ` alone"), "one ` alone");
}

TEST(SettingMarks, EnglishShowsThemAsTyped) {
  EXPECT_EQ(base::english("give `orient=none`"_text), "give orient=none");
  EXPECT_EQ(base::english(base::message("`walls={n}`: {what}"_text, 3, "`kept`"_name)),
            "walls=3: `kept`");
  EXPECT_EQ(base::english(base::message("`walls={n}` wall|`walls={n}` walls"_plural, 1)),
            "walls=1 wall");
}
