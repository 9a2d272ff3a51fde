#include "program/peg.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace voluta::test {

namespace {
constexpr std::size_t kMax = static_cast<std::size_t>(-1);
bool isNameChar(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}
} // namespace

struct Peg::Source {
  std::string_view rest;
  Peg& peg;

  [[noreturn]] void fail() const {
    throw std::runtime_error("grammar: " + std::string(rest.substr(0, 40)));
  }
  void blanks() {
    while (!rest.empty() && std::isspace(static_cast<unsigned char>(rest.front())))
      rest.remove_prefix(1);
  }
  bool take(std::string_view sign) {
    blanks();
    if (!rest.starts_with(sign))
      return false;
    rest.remove_prefix(sign.size());
    return true;
  }
  std::string name() {
    blanks();
    std::size_t n = 0;
    while (n < rest.size() && isNameChar(rest[n]))
      ++n;
    const std::string found(rest.substr(0, n));
    rest.remove_prefix(n);
    return found;
  }
  bool atRule() {
    Source ahead = *this;
    return !ahead.name().empty() && ahead.take("<-");
  }
  char raw() {
    if (rest.empty())
      fail();
    const char c = rest.front();
    rest.remove_prefix(1);
    return c;
  }
  char character() {
    if (!rest.starts_with('\\'))
      return raw();
    raw();
    const char c = raw();
    return c == 'n' ? '\n' : c == 'r' ? '\r' : c == 't' ? '\t' : c;
  }
  std::size_t ruleOf(const std::string& ruleName) {
    const auto [it, isNew] = peg.numberOf_.emplace(ruleName, peg.numberOf_.size());
    return it->second;
  }

  Node choice() {
    Node node;
    node.kind = Kind::Choice;
    do
      node.parts.push_back(sequence());
    while (take("/"));
    return node;
  }
  Node sequence() {
    Node node;
    for (blanks(); !rest.empty() && rest.front() != ')' && rest.front() != '/' && !atRule();
         blanks())
      node.parts.push_back(prefixed());
    return node;
  }
  Node prefixed() {
    for (const auto& [sign, kind] : {std::pair{"!", Kind::Not}, {"&", Kind::And}})
      if (take(sign)) {
        Node node;
        node.kind = kind;
        node.parts.push_back(suffixed());
        return node;
      }
    return suffixed();
  }
  Node repeat(Node part, std::size_t minimum, std::size_t maximum) {
    Node node;
    node.kind = Kind::Repeat;
    node.minimum = minimum;
    node.maximum = maximum;
    node.parts.push_back(std::move(part));
    return node;
  }
  Node suffixed() {
    Node node = primary();
    if (rest.starts_with("*") || rest.starts_with("+") || rest.starts_with("?")) {
      const char sign = character();
      return repeat(std::move(node), sign == '+' ? 1 : 0, sign == '?' ? 1 : kMax);
    }
    if (!rest.starts_with("{"))
      return node;
    take("{");
    const std::size_t minimum = std::stoul(name());
    take(",");
    const std::size_t maximum = std::stoul(name());
    if (!take("}"))
      fail();
    return repeat(std::move(node), minimum, maximum);
  }
  Node primary() {
    Node node;
    if (take("(")) {
      node = choice();
      if (!take(")"))
        fail();
    } else if (take("'")) {
      node.kind = Kind::Literal;
      while (!rest.starts_with("'"))
        node.literal += character();
      rest.remove_prefix(1);
    } else if (take("[")) {
      node.kind = Kind::Class;
      const bool other = rest.starts_with("^");
      if (other)
        rest.remove_prefix(1);
      while (!rest.starts_with("]")) {
        const auto from = static_cast<unsigned char>(character());
        auto to = from;
        if (rest.starts_with("-") && !rest.starts_with("-]")) {
          rest.remove_prefix(1);
          to = static_cast<unsigned char>(character());
        }
        for (unsigned c = from; c <= to; ++c)
          node.set.set(c);
      }
      rest.remove_prefix(1);
      if (other)
        node.set.flip();
    } else if (take(".")) {
      node.kind = Kind::Class;
      node.set.set();
    } else {
      node.kind = Kind::Rule;
      const std::string ruleName = name();
      if (ruleName.empty())
        fail();
      node.rule = ruleOf(ruleName);
    }
    return node;
  }
};

struct Peg::Walk {
  const Peg& peg;
  std::string_view text;
  std::size_t at = 0, furthest = 0;

  bool literal(const std::string& wanted) {
    if (text.size() - at < wanted.size())
      return false;
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      const auto a = static_cast<unsigned char>(text[at + k]),
                 b = static_cast<unsigned char>(wanted[k]);
      if (peg.caseless_ ? std::tolower(a) != std::tolower(b) : a != b)
        return false;
    }
    at += wanted.size();
    return true;
  }
  bool one(const Node& node) {
    const std::size_t from = at;
    const bool matched = inner(node);
    furthest = std::max(furthest, at);
    if (!matched || node.kind == Kind::Not || node.kind == Kind::And)
      at = from;
    return matched;
  }
  bool inner(const Node& node) {
    switch (node.kind) {
    case Kind::Literal:
      return literal(node.literal);
    case Kind::Class:
      return at < text.size() && node.set[static_cast<unsigned char>(text[at])] && ++at > 0;
    case Kind::Rule:
      return one(peg.rules_[node.rule]);
    case Kind::Sequence:
      return std::all_of(node.parts.begin(), node.parts.end(),
                         [&](const Node& part) { return one(part); });
    case Kind::Choice:
      return std::any_of(node.parts.begin(), node.parts.end(),
                         [&](const Node& part) { return one(part); });
    case Kind::Repeat: {
      std::size_t count = 0;
      for (std::size_t before = at; count < node.maximum && one(node.parts[0]); before = at) {
        ++count;
        if (at == before)
          return true; // nothing, for ever
      }
      return count >= node.minimum;
    }
    case Kind::Not: {
      // A failed negative look-ahead does not count as a place reached.
      const std::size_t kept = furthest;
      const bool matched = one(node.parts[0]);
      furthest = kept;
      return !matched;
    }
    case Kind::And:
      return one(node.parts[0]);
    }
    return false;
  }
};

Peg::Peg(std::string_view grammar, bool caseless) : caseless_(caseless) {
  Source source{grammar, *this};
  std::map<std::size_t, Node> bodies;
  for (source.blanks(); !source.rest.empty(); source.blanks()) {
    const std::size_t rule = source.ruleOf(source.name());
    if (!source.take("<-"))
      source.fail();
    if (!bodies.emplace(rule, source.choice()).second)
      source.fail();
  }
  if (bodies.empty() || bodies.size() != numberOf_.size())
    throw std::runtime_error("grammar: a rule without a body");
  for (auto& [number, body] : bodies)
    rules_.push_back(std::move(body));
}

std::size_t Peg::wrongLine(std::string_view text) const {
  Walk walk{*this, text};
  if (walk.one(rules_.front()) && walk.at == text.size())
    return 0;
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(walk.furthest, text.size()));
  return 1 + static_cast<std::size_t>(std::count(text.begin(), end, '\n'));
}

} // namespace voluta::test
