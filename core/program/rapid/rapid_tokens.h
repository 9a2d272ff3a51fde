// The words of RAPID: names, numbers, strings and single marks; comments and blanks fall out.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace voluta::program {

enum class RapidTokenKind { End, Name, Number, Text, Mark };

struct RapidToken {
  RapidTokenKind kind = RapidTokenKind::End;
  std::string_view text; // of Text: without its quotes; of Number: empty
  double number = 0.0;
  std::size_t line = 1;        // where it begins, from 1
  const char* begin = nullptr; // in the text
};

// The text must live as long as its tokens.
class RapidTokens {
public:
  explicit RapidTokens(std::string_view text, std::size_t firstLine = 1)
      : rest_(text), line_(firstLine) {}
  // After the last one: End, for ever.
  RapidToken next();

private:
  void blanks();
  bool quoted(RapidToken& token);

  std::string_view rest_;
  std::size_t line_;
};

// What stands next in a text, for parsers that derive from it: each take...() gives true and goes
// on where the next word is of that kind, else it leaves everything as it is.
class RapidCursor {
protected:
  void advance() { token_ = tokens_.next(); }
  bool isMark(char c) const;
  bool isWord(std::string_view word) const;
  bool takeMark(char c);
  bool takeWord(std::string_view word);
  bool takeName(std::string& name); // in small letters
  bool takeText(std::string& text);
  bool takeNumberToken(double& value);
  // (NOSTEPIN, VIEWONLY) and the like, or nothing. false: not what stands behind a module's name.
  bool takeAttributes();
  bool takeAssign() { return takeMark(':') && takeMark('='); }

  RapidTokens tokens_{std::string_view()};
  RapidToken token_;
};

// RAPID tells no capital letters from small ones. `small`: in small letters.
bool sameWord(std::string_view word, std::string_view small);
std::string inSmallLetters(std::string_view text);

} // namespace voluta::program
