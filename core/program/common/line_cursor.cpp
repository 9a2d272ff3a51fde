#include "program/common/line_cursor.h"

#include "program/common/program_text.h"
#include "program/rapid/rapid_tokens.h"

#include <cmath>

namespace voluta::program {

namespace {

constexpr int kMaxDepth = 16;

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}
bool isLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

// Terms of a sum, each within brackets no deeper than kMaxDepth.
struct Sum {
  LineCursor& line;
  const NumberOfName& numberOf;
  int depth = 0;

  bool sum(double& value) {
    if (!product(value))
      return false;
    for (;;) {
      double more = 0.0;
      if (line.takeMark('+')) {
        if (!product(more))
          return false;
        value += more;
      } else if (line.takeMark('-')) {
        if (!product(more))
          return false;
        value -= more;
      } else {
        return std::isfinite(value);
      }
    }
  }
  bool product(double& value) {
    if (!factor(value))
      return false;
    for (;;) {
      double more = 0.0;
      if (line.takeMark('*')) {
        if (!factor(more))
          return false;
        value *= more;
      } else if (line.takeMark('/')) {
        if (!factor(more))
          return false;
        value /= more;
      } else {
        return std::isfinite(value);
      }
    }
  }
  bool factor(double& value) {
    if (depth > kMaxDepth)
      return false;
    ++depth;
    const bool taken = part(value);
    --depth;
    return taken;
  }
  bool part(double& value) {
    if (line.takeMark('-')) {
      const bool taken = factor(value);
      value = -value;
      return taken;
    }
    if (line.takeMark('+'))
      return factor(value);
    if (line.takeMark('('))
      return sum(value) && line.takeMark(')');
    std::string name;
    return line.takeNumber(value) || (line.takeName(name) && numberOf(line, name, value));
  }
};

} // namespace

std::string_view codeOf(std::string_view line, const LineSyntax& syntax) {
  return trimmed(line.substr(0, findUnquoted(line, {&syntax.comment, 1})));
}

void LineCursor::blanks() {
  const std::size_t first = rest_.find_first_not_of(" \t\r\f");
  rest_.remove_prefix(first == std::string_view::npos ? rest_.size() : first);
}

std::string_view LineCursor::rest() {
  blanks();
  return rest_;
}

bool LineCursor::ended() {
  return rest().empty();
}

bool LineCursor::isMark(char c) {
  return !rest().empty() && rest_.front() == c;
}

bool LineCursor::takeMark(char c) {
  if (!isMark(c))
    return false;
  rest_.remove_prefix(1);
  return true;
}

std::string_view LineCursor::name() {
  blanks();
  std::size_t length = 0;
  while (length < rest_.size() && (isLetter(rest_[length]) || rest_[length] == syntax_.sign ||
                                   (length > 0 && isDigit(rest_[length]))))
    ++length;
  return rest_.substr(0, length);
}

bool LineCursor::isWord(std::string_view small) {
  return sameWord(name(), small);
}

bool LineCursor::takeWord(std::string_view small) {
  if (!isWord(small))
    return false;
  rest_.remove_prefix(small.size());
  return true;
}

bool LineCursor::takeName(std::string& small) {
  const std::string_view found = name();
  if (found.empty())
    return false;
  small = inSmallLetters(found);
  rest_.remove_prefix(found.size());
  return true;
}

bool LineCursor::takeText(std::string_view& text) {
  if (!isMark('"'))
    return false;
  const std::size_t end = rest_.find('"', 1);
  if (end == std::string_view::npos)
    return false;
  text = rest_.substr(1, end - 1);
  rest_.remove_prefix(end + 1);
  return true;
}

bool LineCursor::takeNumber(double& value) {
  blanks();
  if (rest_.empty() || !(isDigit(rest_.front()) || rest_.front() == '.'))
    return false;
  return program::takeNumber(rest_, value);
}

bool takeSum(LineCursor& line, const NumberOfName& numberOf, double& value) {
  return Sum{line, numberOf}.sum(value);
}

} // namespace voluta::program
