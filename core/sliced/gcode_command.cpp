#include "sliced/gcode_command.h"

#include "program/common/text.h"

#include <algorithm>
#include <cctype>

namespace voluta::sliced {

GcodeCommand commandOf(std::string_view line) {
  GcodeCommand command;
  const std::size_t semicolon = line.find(';');
  if (semicolon != std::string_view::npos)
    command.remark = line.substr(semicolon + 1);
  std::string_view text = program::trimmed(line.substr(0, std::min(semicolon, line.find('*'))));
  if (text.empty() || text.front() == '%' || text.front() == '(')
    return command;
  if (text.front() == 'N' || text.front() == 'n') {
    std::string_view rest = text.substr(1);
    double number = 0.0;
    if (program::takeNumber(rest, number))
      text = program::trimmed(rest);
  }
  command.text = text;
  if (text.empty())
    return command;
  const auto letter = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  std::string_view rest = text.substr(1);
  if ((letter == 'G' || letter == 'M' || letter == 'T') &&
      program::takeDecimal(rest, command.number))
    command.letter = letter;
  return command;
}

} // namespace voluta::sliced
