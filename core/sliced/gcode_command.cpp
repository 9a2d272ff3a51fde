#include "sliced/gcode_command.h"

#include "program/common/program_text.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace voluta::sliced {

namespace {
char upper(char c) {
  return static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
}

// Whether a G or M behind this command is a command of its own, not its word or text.
bool endsAtTheNext(char letter, double number) {
  constexpr std::array kG{0.0,  1.0,  2.0,  3.0,  4.0,  17.0, 20.0, 21.0,
                          40.0, 49.0, 90.0, 91.0, 92.0, 93.0, 94.0};
  constexpr std::array kM{3.0,  4.0,   5.0,   6.0,   7.0,   8.0,   9.0,   82.0,  83.0,
                          84.0, 104.0, 106.0, 107.0, 109.0, 140.0, 190.0, 220.0, 221.0};
  return letter == 'T' || (letter == 'G' && std::ranges::find(kG, number) != kG.end()) ||
         (letter == 'M' && std::ranges::find(kM, number) != kM.end());
}

// Returns where the next command begins; npos if there is none. T is a word of M commands.
std::size_t nextCommand(std::string_view text, std::size_t from, char letter) {
  bool isRemark = false;
  for (std::size_t i = text.find_first_of("GgMmTt", from); i < text.size(); ++i) {
    const char c = upper(text[i]);
    if (c == '(' || c == ')')
      isRemark = c == '(';
    if (isRemark || (c != 'G' && c != 'M' && (c != 'T' || letter == 'M')))
      continue;
    std::string_view behind = program::trimmed(text.substr(i + 1));
    double number = 0.0;
    if (program::takeDecimal(behind, number))
      return i;
  }
  return std::string_view::npos;
}

// Returns where the remark that begins at `from` ends, behind its `)`; npos: it is not closed.
std::size_t endOfRemark(std::string_view line, std::size_t from) {
  const std::size_t end = line.find(')', from);
  return end == std::string_view::npos ? end : end + 1;
}

// Returns the place of the first of the characters outside of remarks in parentheses.
std::size_t findOutside(std::string_view line, std::string_view characters) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '(')
      if (const std::size_t end = endOfRemark(line, i); end != std::string_view::npos)
        i = end - 1;
    if (characters.find(line[i]) != std::string_view::npos)
      return i;
  }
  return std::string_view::npos;
}

// Returns the text behind the remarks that it begins with; nothing if one is not closed.
std::string_view behindRemarks(std::string_view text) {
  while ((text = program::trimmed(text)).starts_with('(')) {
    const std::size_t end = endOfRemark(text, 0);
    text = end == std::string_view::npos ? std::string_view() : text.substr(end);
  }
  return text;
}
} // namespace

GcodeCommand commandOf(std::string_view line) {
  GcodeCommand command;
  const std::size_t semicolon = findOutside(line, ";");
  if (semicolon != std::string_view::npos)
    command.remark = line.substr(semicolon + 1);
  std::string_view text =
      behindRemarks(line.substr(0, std::min(semicolon, findOutside(line, "*"))));
  if (text.empty() || text.front() == '%')
    return command;
  if (text.front() == 'N' || text.front() == 'n') {
    std::string_view rest = text.substr(1);
    double number = 0.0;
    if (program::takeNumber(rest, number))
      text = behindRemarks(rest);
  }
  command.text = text;
  if (text.empty())
    return command;
  const char letter = upper(text.front());
  std::string_view rest = text.substr(1);
  if ((letter == 'G' || letter == 'M' || letter == 'T') &&
      program::takeDecimal(rest, command.number))
    command.letter = letter;
  if (!endsAtTheNext(command.letter, command.number))
    return command;
  const std::size_t next = nextCommand(text, text.size() - rest.size(), command.letter);
  if (next < text.size()) {
    command.text = program::trimmed(text.substr(0, next));
    command.next = text.substr(next);
  }
  return command;
}

} // namespace voluta::sliced
