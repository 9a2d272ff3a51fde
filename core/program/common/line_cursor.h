// Scanner of a line for languages with one statement per line (KRL, SPEL+). Case-insensitive; a
// comment extends to the end of the line.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace voluta::program {

struct LineSyntax {
  char comment = ';';
  char sign = '$'; // allowed in names like a letter
};

// Returns `line` without its comment, trimmed. A comment mark within quotes does not count.
std::string_view codeOf(std::string_view line, const LineSyntax& syntax);

// Each take...() returns true and advances if the next word is of that kind; otherwise it changes
// nothing. The text must outlive the cursor.
class LineCursor {
public:
  LineCursor(std::string_view code, const LineSyntax& syntax) : rest_(code), syntax_(syntax) {}

  bool ended();
  bool isMark(char c);
  bool takeMark(char c);
  bool isWord(std::string_view small); // a name, given in lower case
  bool takeWord(std::string_view small);
  bool takeName(std::string& small);     // starts with a letter, underscore or `sign`
  bool takeText(std::string_view& text); // in double quotes
  bool takeNumber(double& value);        // without a preceding sign
  std::string_view rest();

private:
  std::string_view name();
  void blanks();

  std::string_view rest_;
  LineSyntax syntax_;
};

// Evaluates an operand that begins with a name; the cursor is after the name.
using NumberOfName = std::function<bool(LineCursor&, const std::string& name, double& value)>;

// Takes a sum of products of numbers, names and brackets. Returns false if there is none or its
// value is not finite.
bool takeSum(LineCursor& line, const NumberOfName& numberOf, double& value);

} // namespace voluta::program
