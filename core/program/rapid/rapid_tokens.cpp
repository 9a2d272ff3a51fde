#include "program/rapid/rapid_tokens.h"

#include "program/common/program_text.h"

#include <algorithm>

namespace voluta::program {

namespace {
bool isLetter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}
bool isDigit(char c) {
  return c >= '0' && c <= '9';
}
char toSmall(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}
} // namespace

RapidToken RapidTokens::next() {
  blanks();
  RapidToken token;
  token.line = line_;
  token.begin = rest_.data();
  if (rest_.empty())
    return token;
  const std::string_view before = rest_;
  if (isLetter(rest_.front())) {
    token.kind = RapidTokenKind::Name;
    while (!rest_.empty() && (isLetter(rest_.front()) || isDigit(rest_.front())))
      rest_.remove_prefix(1);
    token.text = before.substr(0, before.size() - rest_.size());
  } else if (rest_.front() == '"' && quoted(token)) {
    token.kind = RapidTokenKind::Text;
  } else if (takeNumber(rest_, token.number)) {
    token.kind = RapidTokenKind::Number;
  } else {
    token.kind = RapidTokenKind::Mark;
    token.text = rest_.substr(0, 1);
    rest_.remove_prefix(1);
  }
  return token;
}

void RapidTokens::blanks() {
  bool comment = false;
  while (!rest_.empty()) {
    const char c = rest_.front();
    if (c == '\n') {
      ++line_;
      comment = false;
    } else if (c == '!') {
      comment = true;
    } else if (!comment && c != ' ' && c != '\t' && c != '\r') {
      return;
    }
    rest_.remove_prefix(1);
  }
}

bool RapidTokens::quoted(RapidToken& token) {
  const std::size_t end = rest_.find_first_of("\"\n", 1);
  if (end == std::string_view::npos || rest_[end] == '\n')
    return false;
  token.text = rest_.substr(1, end - 1);
  rest_.remove_prefix(end + 1);
  return true;
}

bool RapidCursor::isMark(char c) const {
  return token_.kind == RapidTokenKind::Mark && token_.text.front() == c;
}

bool RapidCursor::isWord(std::string_view word) const {
  return token_.kind == RapidTokenKind::Name && sameWord(token_.text, word);
}

bool RapidCursor::takeMark(char c) {
  if (!isMark(c))
    return false;
  advance();
  return true;
}

bool RapidCursor::takeWord(std::string_view word) {
  if (!isWord(word))
    return false;
  advance();
  return true;
}

bool RapidCursor::takeName(std::string& name) {
  if (token_.kind != RapidTokenKind::Name)
    return false;
  name = inSmallLetters(token_.text);
  advance();
  return true;
}

bool RapidCursor::takeText(std::string& text) {
  if (token_.kind != RapidTokenKind::Text)
    return false;
  text = token_.text;
  advance();
  return true;
}

bool RapidCursor::takeNumberToken(double& value) {
  if (token_.kind != RapidTokenKind::Number)
    return false;
  value = token_.number;
  advance();
  return true;
}

bool RapidCursor::takeAttributes() {
  if (!takeMark('('))
    return true;
  std::string name;
  do {
    if (!takeName(name))
      return false;
  } while (takeMark(','));
  return takeMark(')');
}

bool sameWord(std::string_view word, std::string_view small) {
  return word.size() == small.size() && std::equal(word.begin(), word.end(), small.begin(),
                                                   [](char a, char b) { return toSmall(a) == b; });
}

std::string inSmallLetters(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), toSmall);
  return result;
}

} // namespace voluta::program
