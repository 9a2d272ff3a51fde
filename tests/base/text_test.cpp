// Sentences as data: places, values, plural forms, English and another language by the same rules.
#include "base/error.h"
#include "base/text.h"
#include "base/valid_utf8.h"

#include <gtest/gtest.h>

using namespace voluta;

namespace {

using base::english;
using base::message;

TEST(Text, PlaceholdersAreFilledInOrderOfFirstUse) {
  EXPECT_EQ(english(message("{there} of {wanted} vertices, {there} in all"_text, 3, 4)),
            "3 of 4 vertices, 3 in all");
  EXPECT_EQ(base::placeNames("{b} {a:.2f} {b} {c#}"),
            (std::vector<std::string_view>{"b", "a", "c"}));
  EXPECT_TRUE(base::placeNames("give {\"point\": [x, y]} or {}").empty())
      << "other braces are text";
}

TEST(Text, NumbersFollowTheFormatOfTheirPlaceholder) {
  EXPECT_EQ(
      english(message("{area:.3g} of {whole:.4g#}, {share:.2f}, {angle}"_text, base::mm2(12.3456),
                      base::mm2(1234.567), base::percent(4.0), base::degrees(45.0))),
      "12.3 mm2 of 1235, 4.00 %, 45 degrees");
  EXPECT_EQ(english(message("at {place:.1f}"_text, base::Point{1.0, -2.25, 0.04})),
            "at (1.0, -2.2, 0.0)");
  EXPECT_EQ(english(message("x {x:.1f} y {y:.1f} at {place:.0f}"_text, base::number(-0.04),
                            base::number(-0.06), base::Point{-0.4, -0.6, -0.0})),
            "x 0.0 y -0.1 at (0, -1, 0)")
      << "what is rounded to nothing has no sign";
}

TEST(Text, TheFirstWholeNumberDecidesAboutTheForm) {
  const auto textOf = [](int n) {
    return english(message("{name}: {n} piece is not laid|{name}: {n} pieces are not laid"_plural,
                           "x"_name, n));
  };
  EXPECT_EQ(textOf(1), "x: 1 piece is not laid");
  EXPECT_EQ(textOf(0), "x: 0 pieces are not laid");
  EXPECT_EQ(textOf(2), "x: 2 pieces are not laid");
}

TEST(Text, MessagesCanBeNestedInMessages) {
  const base::Message inner = message("{n} voxel|{n} voxels"_plural, 2);
  EXPECT_EQ(english(message("a column of {voxels} from {foot}"_text, inner, "the plate"_text)),
            "a column of 2 voxels from the plate");
  EXPECT_EQ(english(message("failed: {all}"_text, std::vector<base::Message>{inner, inner})),
            "failed: 2 voxels, 2 voxels");
}

// German-like: another order of words, its own forms, comma and dot the other way round.
class Other : public base::Language {
public:
  std::string sentence(base::Text text, std::optional<long long> count) const override {
    if (text == "{n} of {all} piece, {area:.1f}|{n} of {all} pieces, {area:.1f}"_plural)
      return count == 1 ? "{area:.1f}: von {all} eins" : "{area:.1f}: von {all} {n}";
    return Language::sentence(text, count);
  }
  std::string whole(long long number) const override {
    std::string text = std::to_string(number);
    for (std::size_t i = text.size(); i > 3; i -= 3)
      text.insert(i - 3, ".");
    return text;
  }
  std::string number(double number, char format, int digits) const override {
    std::string text = Language::number(number, format, digits);
    for (char& c : text)
      c = c == '.' ? ',' : c;
    return text;
  }
  std::string withUnit(const std::string& number, base::Unit unit) const override {
    return unit == base::Unit::Mm2 ? number + " mm²" : Language::withUnit(number, unit);
  }
};

TEST(Text, TranslationsFormatTheSameValues) {
  const auto textOf = [](int n) {
    return inWords(message("{n} of {all} piece, {area:.1f}|{n} of {all} pieces, {area:.1f}"_plural,
                           n, 12345, base::mm2(1.25)),
                   Other());
  };
  EXPECT_EQ(textOf(1), "1,2 mm²: von 12.345 eins");
  EXPECT_EQ(textOf(20), "1,2 mm²: von 12.345 20");
}

TEST(Text, AnErrorIsOneLineAndAllOfItIsData) {
  const base::Error error(base::ErrorCode::Usage,
                          message("'{text}' is no number"_text, "a\nb"_name),
                          base::lineOf("file.stl", 12000), "give a number"_text);
  EXPECT_STREQ(error.what(), "file.stl, line 12000: 'a b' is no number (give a number)");
  EXPECT_EQ(inWords(error.whole(), Other()),
            "file.stl, line 12000: 'a\nb' is no number (give a number)");
  // NUL and escape characters of a damaged file cut no line off and colour no terminal.
  EXPECT_STREQ(base::Error(base::ErrorCode::Usage,
                           message("'{text}' is no number"_text, std::string("G1\0X\x1b[3\x7f", 8)))
                   .what(),
               "'G1?X?[3?' is no number");
  EXPECT_STREQ(base::Error(base::ErrorCode::Usage, "wrong"_text).what(), "wrong");
  EXPECT_STREQ(base::Error(base::ErrorCode::Usage, "wrong"_text, {}, "mend it"_text).what(),
               "wrong (mend it)");
}

// Quoted from a file of any bytes.
TEST(Text, BytesThatAreNoCharactersAreReplaced) {
  const auto quoted = [](const std::string& bytes) {
    const base::Message quote = message("'{text}'"_text, bytes);
    EXPECT_EQ(inWords(quote, Other()), base::english(quote));
    std::string sentence = base::english(quote);
    return sentence.substr(1, sentence.size() - 2);
  };
  EXPECT_EQ(quoted("perché 20 °C, 部件 😀"), "perché 20 °C, 部件 😀");
  EXPECT_EQ(quoted("a\x80\xFF\xC3"), "a???");
  EXPECT_EQ(quoted("\xC3\x28"), "?(");
  EXPECT_EQ(quoted("\xE2\x82"), "??");
  EXPECT_EQ(quoted("\xC0\xAF"), "??");
  EXPECT_EQ(quoted("\xC2\x9B"
                   "31m"),
            "??31m")
      << "a control character of terminals";
}

TEST(Text, IsCutBetweenCharacters) {
  EXPECT_EQ(base::validText("Gehäuse", 4), "Geh");
  EXPECT_EQ(base::validText("Gehäuse", 5), "Gehä");
  EXPECT_EQ(base::validText("Geh\xE4use"), "Geh?use");
  EXPECT_EQ(base::validText("\xE0\x80\x80\xED\xA0\x80"), "??????") << "no characters";
}

// The compiler refuses a sentence made at run time and a placeholder without a value.
template <typename T> constexpr bool kSays = std::is_constructible_v<base::Message, T>;
static_assert(!kSays<std::string> && !kSays<const char*> && !kSays<std::string_view>);
static_assert(!std::is_constructible_v<base::Text, const char*>);
static_assert(!std::is_constructible_v<base::Value, const char*>);
static_assert(!std::is_constructible_v<base::Value, double>);
static_assert(base::countPlaces("{a} {b:.2f} {a} {c#} {} {1}") == 3);

} // namespace
