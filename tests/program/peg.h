// Grammars as texts, for checks of programs that are independent of the readers: parsing expression
// grammars (Ford 2004). A rule is `Name <- expression`, the first one is the start; 'literal',
// [class], ., sequence, / choice, * + ? {m,n}, ! & and ( ). In classes and literals \r \n \t \\ \'
// and \] have their usual meaning.
#pragma once

#include <bitset>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::test {

class Peg {
public:
  // Throws std::runtime_error: no such grammar. `caseless`: literals match in either case.
  explicit Peg(std::string_view grammar, bool caseless = false);

  // 0: the whole text is as the grammar has it; else the line (1-based) of the furthest place that
  // any rule got to.
  std::size_t wrongLine(std::string_view text) const;

private:
  enum class Kind { Literal, Class, Rule, Sequence, Choice, Repeat, Not, And };
  struct Node {
    Kind kind = Kind::Sequence;
    std::string literal;
    std::bitset<256> set;
    std::vector<Node> parts;
    std::size_t rule = 0, minimum = 0, maximum = 0;
  };
  struct Source; // the grammar's text as it is read
  struct Walk;   // over a text

  bool caseless_;
  std::vector<Node> rules_;
  std::map<std::string, std::size_t, std::less<>> numberOf_;
};

} // namespace voluta::test
