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
  explicit RapidTokens(std::string_view text) : rest_(text) {}
  // After the last one: End, for ever.
  RapidToken next();

private:
  void blanks();
  bool quoted(RapidToken& token);

  std::string_view rest_;
  std::size_t line_ = 1;
};

// RAPID tells no capital letters from small ones. `small`: in small letters.
bool sameWord(std::string_view word, std::string_view small);
std::string inSmallLetters(std::string_view text);

} // namespace voluta::program
