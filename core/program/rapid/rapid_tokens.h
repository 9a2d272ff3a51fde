// The tokens of RAPID: names, numbers, strings and single marks; comments and blanks are skipped.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace voluta::program {

enum class RapidTokenKind { End, Name, Number, Text, Mark };

struct RapidToken {
  RapidTokenKind kind = RapidTokenKind::End;
  std::string_view text; // Of Text: without its quotes; of Number: empty
  double number = 0.0;
  std::size_t line = 1;        // Where it begins, from 1
  const char* begin = nullptr; // In the text
};

// The text must outlive its tokens.
class RapidTokens {
public:
  explicit RapidTokens(std::string_view text, std::size_t firstLine = 1)
      : rest_(text), line_(firstLine) {}
  // Returns End after the last token, on every call.
  RapidToken next();

private:
  void blanks();
  bool quoted(RapidToken& token);

  std::string_view rest_;
  std::size_t line_;
};

// Position in a text, as a base class of parsers: each take...() returns true and advances if the
// next token is of that kind; otherwise it returns false and changes nothing.
class RapidCursor {
protected:
  void advance() { token_ = tokens_.next(); }
  bool isMark(char c) const;
  bool isWord(std::string_view word) const;
  bool takeMark(char c);
  bool takeWord(std::string_view word);
  bool takeName(std::string& name); // In lower case
  bool takeText(std::string& text);
  bool takeNumberToken(double& value);
  // Takes optional attributes such as (NOSTEPIN, VIEWONLY). Returns false if other text follows a
  // module's name.
  bool takeAttributes();
  bool takeAssign() { return takeMark(':') && takeMark('='); }

  RapidTokens tokens_{std::string_view()};
  RapidToken token_;
};

// RAPID is case-insensitive. `small`: in lower case.
bool sameWord(std::string_view word, std::string_view small);
std::string inSmallLetters(std::string_view text);

} // namespace voluta::program
