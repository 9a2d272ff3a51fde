#include "program/text_files.h"

#include <algorithm>
#include <string_view>

namespace voluta::program {

namespace {
bool hasMark(std::string_view text) {
  return text.starts_with("\xef\xbb\xbf") || text.starts_with("\xff\xfe") ||
         text.starts_with("\xfe\xff");
}
bool isNoText(char c) {
  const auto code = static_cast<unsigned char>(c);
  return code < 32 && c != '\t' && c != '\n' && c != '\r' && c != '\f';
}
std::size_t lineOf(std::string_view text, std::size_t at) {
  return 1 + static_cast<std::size_t>(
                 std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}
} // namespace

bool tellNoTexts(const std::vector<plan::ProgramFile>& files,
                 std::vector<plan::ProgramDefect>& defects) {
  for (std::size_t f = 0; f < files.size(); ++f) {
    const std::string_view text = files[f].text;
    const auto odd = std::find_if(text.begin(), text.end(), isNoText);
    if (hasMark(text))
      defects.push_back(
          {f, 1, "the file begins with a byte-order mark: save it as plain text"_text});
    else if (odd != text.end())
      defects.push_back({f, lineOf(text, static_cast<std::size_t>(odd - text.begin())),
                         "a character that no program holds: is this a binary file?"_text});
  }
  return !defects.empty();
}

void tellMixedLineEnds(const std::vector<plan::ProgramFile>& files,
                       std::vector<plan::ProgramDefect>& defects) {
  for (std::size_t f = 0; f < files.size(); ++f) {
    const std::string_view text = files[f].text;
    bool pairs = false, known = false;
    for (std::size_t i = text.find_first_of("\r\n"); i != std::string_view::npos;
         i = text.find_first_of("\r\n", i + 1)) {
      const bool pair = text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
      if ((known && pair != pairs) || (text[i] == '\r' && !pair)) {
        defects.push_back({f, lineOf(text, i), "lines end in two ways, from here on another"_text});
        break;
      }
      known = true;
      pairs = pair;
      i += pair ? 1 : 0;
    }
  }
}

} // namespace voluta::program
