#include "geometry/formats/plain_text.h"

#include "base/error.h"
#include "geometry/formats/text_scanner.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <optional>

namespace voluta::geometry {

using base::Error;
using base::ErrorCode;

namespace {

enum class Encoding { Bytes, Utf16Little, Utf16Big, Utf32 };

constexpr base::Text kWithPoints = "export it with decimal points"_text;
constexpr std::string_view kUtf8Mark = "\xef\xbb\xbf";

// Detected by the byte-order mark, or by the zero bytes of the first two letters.
Encoding encodingOf(std::string_view bytes) {
  const auto at = [&](std::size_t i) {
    return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0xffu;
  };
  if (at(0) == 0xff && at(1) == 0xfe)
    return at(2) == 0 && at(3) == 0 ? Encoding::Utf32 : Encoding::Utf16Little;
  if (at(0) == 0xfe && at(1) == 0xff)
    return Encoding::Utf16Big;
  const auto letter = [&](std::size_t i) { return std::isprint(static_cast<int>(at(i))) != 0; };
  if (letter(0) && at(1) == 0 && letter(2) && at(3) == 0)
    return Encoding::Utf16Little;
  if (at(0) == 0 && letter(1) && at(2) == 0 && letter(3))
    return Encoding::Utf16Big;
  return Encoding::Bytes;
}

void appendUtf8(std::uint32_t point, std::string& text) {
  if (point < 0x80) {
    text += static_cast<char>(point);
    return;
  }
  const int further = point < 0x800 ? 1 : point < 0x10000 ? 2 : 3;
  constexpr std::uint32_t kFirst[] = {0, 0xc0, 0xe0, 0xf0};
  text += static_cast<char>(kFirst[further] | point >> (6 * further));
  for (int i = further - 1; i >= 0; --i)
    text += static_cast<char>(0x80 | (point >> (6 * i) & 0x3f));
}

// Returns nullopt for an odd number of bytes or half a surrogate pair.
std::optional<std::string> utf8Of(std::string_view bytes, bool isBig) {
  if (bytes.size() % 2 != 0)
    return std::nullopt;
  const auto unit = [&](std::size_t i) {
    const auto a = static_cast<unsigned char>(bytes[i]),
               b = static_cast<unsigned char>(bytes[i + 1]);
    return static_cast<std::uint32_t>(isBig ? a << 8 | b : b << 8 | a);
  };
  std::string text;
  text.reserve(bytes.size() / 2);
  for (std::size_t i = 0; i < bytes.size(); i += 2) {
    std::uint32_t point = unit(i);
    if (point >= 0xd800 && point < 0xe000) {
      i += 2;
      if (point >= 0xdc00 || i >= bytes.size() || unit(i) < 0xdc00 || unit(i) >= 0xe000)
        return std::nullopt;
      point = 0x10000 + ((point - 0xd800) << 10) + (unit(i) - 0xdc00);
    }
    if (point != 0xfeff)
      appendUtf8(point, text);
  }
  return text;
}

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

// Returns the position of the comma in numbers such as "1,5" or "-0,25e3"; npos if the word is not
// such a number.
std::size_t decimalComma(std::string_view word) {
  const std::size_t comma = word.find(',');
  if (comma == std::string_view::npos || comma + 1 >= word.size() || !isDigit(word[comma + 1]))
    return std::string_view::npos;
  std::string dotted(word);
  dotted[comma] = '.';
  return numberOf(dotted) ? comma : std::string_view::npos;
}

// "1,500" may be fifteen hundred, "0,500" and "1,5" may not.
bool mayBeThousands(std::string_view word, std::size_t comma) {
  const std::string_view before = word.substr(word.starts_with('-') || word.starts_with('+'));
  const std::size_t digits = before.find(',');
  return digits >= 1 && digits <= 3 && before.front() != '0' && word.size() == comma + 4 &&
         std::all_of(word.begin() + static_cast<std::ptrdiff_t>(comma) + 1, word.end(), isDigit);
}

// Returns whether a line with this first word has coordinates; commas in names and comments do not
// matter.
bool isOfNumbers(std::string_view first) {
  return first == "v" || first == "vn" || first == "vt" || first == "vertex" || first == "VERTEX" ||
         numberOf(first) || decimalComma(first) != std::string_view::npos;
}

// Replaces decimal commas by points.
class CommaReading {
public:
  CommaReading(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  // Returns nullopt if there are no decimal commas.
  std::optional<std::string> run() {
    std::vector<std::string_view> words;
    LineScanner scanner(text_);
    while (scanner.nextLine(words))
      takeLine(words, scanner.line());
    if (commas_.empty())
      return std::nullopt;
    if (!isCertain_)
      throw Error(
          ErrorCode::UnreadableFile,
          base::message("ambiguous number '{number}': decimal comma or thousands separator"_text,
                        example_),
          name_, kWithPoints);
    std::string dotted(text_);
    for (const std::size_t at : commas_)
      dotted[at] = '.';
    return dotted;
  }

private:
  void takeLine(const std::vector<std::string_view>& words, int line) {
    if (words.empty() || !isOfNumbers(words.front()))
      return;
    bool hasComma = false, hasPoint = false;
    for (const std::string_view word : words) {
      if (word.find(',') == std::string_view::npos) {
        hasPoint = hasPoint || (word.find('.') != std::string_view::npos && numberOf(word));
        continue;
      }
      const std::size_t comma = decimalComma(word);
      if (comma == std::string_view::npos)
        continue;
      hasComma = true;
      example_ = word;
      isCertain_ = isCertain_ || !mayBeThousands(word, comma);
      commas_.push_back(static_cast<std::size_t>(word.data() - text_.data()) + comma);
    }
    if (hasComma && hasPoint)
      throw Error(
          ErrorCode::UnreadableFile,
          base::message("numbers with decimal commas, such as '{number}', mixed with numbers with "
                        "decimal points"_text,
                        example_),
          base::lineOf(name_, line), kWithPoints);
  }

  std::string_view text_;
  const std::string& name_;
  std::vector<std::size_t> commas_; // positions
  std::string example_;
  bool isCertain_ = false;
};

} // namespace

PlainText plainText(std::string_view bytes, const std::string& name) {
  PlainText plain{bytes, std::nullopt, {}};
  const Encoding encoding = encodingOf(bytes);
  if (encoding == Encoding::Utf32)
    throw Error(ErrorCode::UnreadableFile, "is UTF-32, which cannot be read"_text, name,
                "save it as UTF-8"_text);
  if (encoding != Encoding::Bytes) {
    std::optional<std::string> text = utf8Of(bytes, encoding == Encoding::Utf16Big);
    if (!text)
      throw Error(ErrorCode::UnreadableFile, "is damaged or truncated UTF-16"_text, name,
                  "save it as UTF-8"_text);
    plain.converted = std::move(text);
  } else if (bytes.starts_with(kUtf8Mark)) {
    plain.original.remove_prefix(kUtf8Mark.size());
  }
  const std::string_view text = plain.text();
  if (text.find('\0') != std::string_view::npos || text.find(',') == std::string_view::npos)
    return plain;
  if (std::optional<std::string> dotted = CommaReading(text, name).run()) {
    plain.converted = std::move(dotted);
    plain.notes.emplace_back("decimal commas read as decimal points"_text);
  }
  return plain;
}

} // namespace voluta::geometry
