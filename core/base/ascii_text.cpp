#include "base/ascii_text.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>

namespace voluta::base {

namespace {

constexpr std::uint32_t kLatinFrom = 0xC0, kCyrillicFrom = 0x410;
// From U+00C0 to U+017F.
constexpr auto kLatin = std::to_array<std::string_view>(
    {"A", "A", "A",  "A",  "Ae", "A", "Ae", "C", "E", "E", "E", "E", "I",  "I", "I",  "I",
     "D", "N", "O",  "O",  "O",  "O", "Oe", "x", "O", "U", "U", "U", "Ue", "Y", "Th", "ss",
     "a", "a", "a",  "a",  "ae", "a", "ae", "c", "e", "e", "e", "e", "i",  "i", "i",  "i",
     "d", "n", "o",  "o",  "o",  "o", "oe", "/", "o", "u", "u", "u", "ue", "y", "th", "y",
     "A", "a", "A",  "a",  "A",  "a", "C",  "c", "C", "c", "C", "c", "C",  "c", "D",  "d",
     "D", "d", "E",  "e",  "E",  "e", "E",  "e", "E", "e", "E", "e", "G",  "g", "G",  "g",
     "G", "g", "G",  "g",  "H",  "h", "H",  "h", "I", "i", "I", "i", "I",  "i", "I",  "i",
     "I", "i", "Ij", "ij", "J",  "j", "K",  "k", "k", "L", "l", "L", "l",  "L", "l",  "L",
     "l", "L", "l",  "N",  "n",  "N", "n",  "N", "n", "n", "N", "n", "O",  "o", "O",  "o",
     "O", "o", "Oe", "oe", "R",  "r", "R",  "r", "R", "r", "S", "s", "S",  "s", "S",  "s",
     "S", "s", "T",  "t",  "T",  "t", "T",  "t", "U", "u", "U", "u", "U",  "u", "U",  "u",
     "U", "u", "U",  "u",  "W",  "w", "Y",  "y", "Y", "Z", "z", "Z", "z",  "Z", "z",  "s"});
static_assert(kLatin.size() == 0x180 - kLatinFrom);
// From U+0410 to U+044F.
constexpr auto kCyrillic = std::to_array<std::string_view>(
    {"A", "B", "V", "G", "D", "E",  "Zh", "Z",  "I",  "Y",    "K", "L", "M", "N", "O",  "P",
     "R", "S", "T", "U", "F", "Kh", "Ts", "Ch", "Sh", "Shch", "",  "Y", "",  "E", "Yu", "Ya",
     "a", "b", "v", "g", "d", "e",  "zh", "z",  "i",  "y",    "k", "l", "m", "n", "o",  "p",
     "r", "s", "t", "u", "f", "kh", "ts", "ch", "sh", "shch", "",  "y", "",  "e", "yu", "ya"});
static_assert(kCyrillic.size() == 0x450 - kCyrillicFrom);

struct Sign {
  std::uint32_t code;
  std::string_view ascii;
};
constexpr Sign kSigns[] = {
    {0xA0, " "},     {0xB0, " deg"}, {0xB1, "+-"},    {0xB2, "2"},   {0xB3, "3"},
    {0xB5, "u"},     {0xB7, "."},    {0x401, "E"},    {0x451, "e"},  {0x2010, "-"},
    {0x2011, "-"},   {0x2012, "-"},  {0x2013, "-"},   {0x2014, "-"}, {0x2018, "'"},
    {0x2019, "'"},   {0x201A, "'"},  {0x201C, "'"},   {0x201D, "'"}, {0x201E, "'"},
    {0x2026, "..."}, {0x202F, " "},  {0x20AC, "EUR"}, {0x2212, "-"}, {0x1E9E, "SS"}};

// Takes a character from the beginning of a text that is not empty; 0: there is no valid one.
std::uint32_t takeCharacter(std::string_view& text) {
  const auto byte = [&](std::size_t i) {
    return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i]));
  };
  const std::uint32_t first = byte(0);
  const std::size_t size = first < 0x80 ? 1 : first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  std::uint32_t code = size == 1 ? first : first & (0xFFU >> (size + 1));
  for (std::size_t i = 1; i < size; ++i) {
    if (i >= text.size() || (byte(i) & 0xC0U) != 0x80) {
      text.remove_prefix(i);
      return 0;
    }
    code = (code << 6U) | (byte(i) & 0x3FU);
  }
  text.remove_prefix(size);
  return first >= 0x80 && first < 0xC0 ? 0 : code;
}

std::string_view asciiOf(std::uint32_t code) {
  if (code >= kLatinFrom && code - kLatinFrom < kLatin.size())
    return kLatin.at(code - kLatinFrom);
  if (code >= kCyrillicFrom && code - kCyrillicFrom < kCyrillic.size())
    return kCyrillic.at(code - kCyrillicFrom);
  const auto* const sign = std::ranges::find(kSigns, code, &Sign::code);
  return sign == std::end(kSigns) ? "_" : sign->ascii;
}

} // namespace

std::string asciiText(std::string_view text) {
  std::string ascii;
  while (!text.empty()) {
    const std::uint32_t code = takeCharacter(text);
    if (code >= ' ' && code <= '~')
      ascii += static_cast<char>(code);
    else
      ascii += asciiOf(code);
  }
  return ascii;
}

} // namespace voluta::base
