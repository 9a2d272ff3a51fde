// What stands next in a line, for languages with one statement a line (KRL, SPEL+). Letters of
// either case mean the same; a comment goes to the line's end.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

namespace voluta::program {

struct LineSyntax {
  char comment = ';';
  char sign = '$'; // may stand in names, as letters do
};

// `line` without its comment, trimmed. A comment's mark within quotes is none.
std::string_view codeOf(std::string_view line, const LineSyntax& syntax);

// Each take...() gives true and goes on where the next word is of that kind, else it leaves
// everything as it is. The text must live as long.
class LineCursor {
public:
  LineCursor(std::string_view code, const LineSyntax& syntax) : rest_(code), syntax_(syntax) {}

  bool ended();
  bool isMark(char c);
  bool takeMark(char c);
  bool isWord(std::string_view small); // a name, given in small letters
  bool takeWord(std::string_view small);
  bool takeName(std::string& small);     // a letter, underscore or sign first
  bool takeText(std::string_view& text); // in double quotes
  bool takeNumber(double& value);        // without a sign before it
  std::string_view rest();

private:
  std::string_view name();
  void blanks();

  std::string_view rest_;
  LineSyntax syntax_;
};

// The value of what begins with a name that is no number; the cursor stands behind the name.
using NumberOfName = std::function<bool(LineCursor&, const std::string& name, double& value)>;

// A sum of products of numbers, names and brackets. false: it is none, or not finite.
bool takeSum(LineCursor& line, const NumberOfName& numberOf, double& value);

} // namespace voluta::program
