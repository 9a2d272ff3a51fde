#include "program/common/text_files.h"

#include "program/common/program_text.h"

#include <algorithm>

namespace voluta::program {

namespace {
bool hasMark(std::string_view text) {
  return text.starts_with(kByteOrderMark) || text.starts_with("\xff\xfe") ||
         text.starts_with("\xfe\xff");
}
bool isBinary(char c) {
  const auto code = static_cast<unsigned char>(c);
  return code < 32 && c != '\t' && c != '\n' && c != '\r' && c != '\f';
}
std::size_t lineOf(std::string_view text, std::size_t at) {
  return 1 + static_cast<std::size_t>(
                 std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

// Returns the length of the longest text in quotation marks.
std::size_t longestTextOf(std::string_view line, std::string_view remark) {
  std::size_t longest = 0;
  while (true) {
    const std::size_t open = line.find('"');
    const bool remarked = !remark.empty() && line.find(remark) < open;
    if (open == std::string_view::npos || remarked)
      return longest;
    const std::size_t close = std::min(line.find('"', open + 1), line.size());
    longest = std::max(longest, close - open - 1);
    line.remove_prefix(std::min(close + 1, line.size()));
  }
}
} // namespace

bool reportNoTexts(const std::vector<plan::ProgramFile>& files,
                   std::vector<plan::ProgramDefect>& defects, IsNoText mayBe) {
  for (std::size_t f = 0; f < files.size(); ++f) {
    const std::string_view text = files[f].text;
    if (mayBe != nullptr && mayBe(text))
      continue;
    const auto odd = std::find_if(text.begin(), text.end(), isBinary);
    if (hasMark(text))
      defects.push_back(
          {f, 1, "the file begins with a byte-order mark: save it as plain text"_text});
    else if (odd != text.end())
      defects.push_back({f, lineOf(text, static_cast<std::size_t>(odd - text.begin())),
                         "unexpected control character: is this a binary file?"_text});
  }
  return !defects.empty();
}

void reportMixedLineEnds(const std::vector<plan::ProgramFile>& files,
                         std::vector<plan::ProgramDefect>& defects, IsNoText mayBe) {
  for (std::size_t f = 0; f < files.size(); ++f) {
    const std::string_view text = files[f].text;
    if (mayBe != nullptr && mayBe(text))
      continue;
    bool pairs = false, known = false;
    for (std::size_t i = text.find_first_of("\r\n"); i != std::string_view::npos;
         i = text.find_first_of("\r\n", i + 1)) {
      const bool pair = text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
      if ((known && pair != pairs) || (text[i] == '\r' && !pair)) {
        defects.push_back({f, lineOf(text, i), "mixed line ends: they differ from here on"_text});
        break;
      }
      known = true;
      pairs = pair;
      i += pair ? 1 : 0;
    }
  }
}

void reportLongLines(const std::vector<plan::ProgramFile>& files, const LineLimits& limits,
                     std::vector<plan::ProgramDefect>& defects) {
  for (std::size_t f = 0; f < files.size(); ++f) {
    bool line = limits.line == 0, text = limits.text == 0; // already reported, or no limit
    LineReader lines(files[f].text);
    for (std::string_view one; !(line && text) && lines.next(one);) {
      if (!line && one.size() > limits.line) {
        defects.push_back(
            {f, lines.number(),
             base::message(
                 "the line has {characters} characters; the controller accepts at most {most}"_text,
                 one.size(), limits.line)});
        line = true;
      }
      if (const std::size_t longestText = text ? 0 : longestTextOf(one, limits.remark);
          !text && longestText > limits.text) {
        defects.push_back(
            {f, lines.number(),
             base::message(
                 "a text has {characters} characters; the controller accepts at most {most}"_text,
                 longestText, limits.text)});
        text = true;
      }
    }
  }
}

} // namespace voluta::program
