// Values, arguments and calls of URScript: literals, variables, sums and products, and the
// functions that give a pose or a number without asking the robot (URScript manual, sections 1 and
// 5).
#pragma once

#include "program/common/text_scanner.h"

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
  std::size_t count = 0; // of list
  std::string_view text; // Text, of the line
};

struct Argument {
  std::string_view name; // empty: positional
  Value value;
};

struct Call {
  std::string_view name;
  std::array<Argument, 8> arguments;
  std::size_t count = 0;

  // The argument called `key`, or the positional one at `position`; nullptr when it isn't given.
  const Value* find(std::string_view key, std::size_t position) const;
};

using UrscriptVariables = std::map<std::string, Value, std::less<>>;

// Reads one statement from left to right; every function moves `rest` behind what it took and gives
// false where it can't.
struct UrscriptScanner : TextScanner {
  UrscriptScanner(std::string_view text, const UrscriptVariables& known)
      : TextScanner{text}, variables(known) {}

  const UrscriptVariables& variables;
  int depth = 0; // of brackets

  // A sum, a list, a pose, a text, a truth; a variable by its value.
  bool value(Value& value);
  // name(arguments) and nothing behind it.
  bool call(Call& call);

private:
  bool list(Value& value); // behind '['
  bool arguments(Call& call);
  bool argument(Argument& argument);
  bool product(Value& value);
  bool factor(Value& value);
  bool named(Value& value);
};

} // namespace voluta::program
