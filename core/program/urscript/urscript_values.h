// Values, arguments and calls of URScript: literals, variables, sums and products, and the
// functions that return a pose or a number without querying the robot (URScript manual, sections 1
// and 5).
#pragma once

#include "program/common/program_scanner.h"

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>

namespace voluta::program {

enum class ValueKind { None, Number, List, Pose, Boolean, Text };

struct Value {
  ValueKind kind = ValueKind::None;
  double number = 0.0; // Number; Boolean as 0 or 1
  std::array<double, 8> list{};
  std::size_t count = 0; // Of list
  std::string_view text; // Text; refers to the line
};

struct Argument {
  std::string_view name; // Empty: positional
  Value value;
};

struct Call {
  std::string_view name;
  std::array<Argument, 8> arguments;
  std::size_t count = 0;

  // Returns the argument called `key`, or the positional one at `position`; nullptr if it is not
  // given.
  const Value* find(std::string_view key, std::size_t position) const;
};

using UrscriptVariables = std::map<std::string, Value, std::less<>>;

// Reads one statement from left to right. Every function advances `rest` beyond the text it has
// read, and returns false if it cannot read it.
struct UrscriptScanner : TextScanner {
  UrscriptScanner(std::string_view text, const UrscriptVariables& known)
      : TextScanner{text}, variables(known) {}

  const UrscriptVariables& variables;
  int depth = 0; // Of brackets

  // A sum, a list, a pose, a text or a truth value; a variable by its value.
  bool value(Value& value);
  // name(arguments) followed by nothing.
  bool call(Call& call);

private:
  bool list(Value& value); // After '['
  bool arguments(Call& call);
  bool argument(Argument& argument);
  bool product(Value& value);
  bool factor(Value& value);
  bool named(Value& value);
};

} // namespace voluta::program
