// Values in languages whose statements contain numbers, texts, lists of numbers and names: sums,
// products, variables.
#pragma once

#include "program/common/program_scanner.h"

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

enum class ScriptKind { None, Number, List, Text };

struct ScriptValue {
  ScriptKind kind = ScriptKind::None;
  double number = 0.0; // booleans are 0 and 1
  std::vector<double> list;
  std::vector<double> flags; // after the list, in languages that have them
  std::string text;
};

// By their names in lower case.
using ScriptVariables = std::map<std::string, ScriptValue, std::less<>>;

// Each function returns false if the text does not match; the position is then undefined.
class ScriptScanner : public TextScanner {
public:
  // A list is enclosed by `open` and its closing bracket.
  ScriptScanner(std::string_view text, const ScriptVariables& variables, char open)
      : TextScanner{text}, variables_(variables), open_(open) {}
  virtual ~ScriptScanner() = default;

  bool value(ScriptValue& value);
  bool number(double& value);
  // Takes values up to the closing bracket; the opening one is already taken.
  bool arguments(std::vector<ScriptValue>& values);

protected:
  // Evaluates a name; by default a variable.
  virtual bool named(std::string_view name, ScriptValue& value);
  // Takes the text that may follow a list; by default none.
  virtual bool behindList(ScriptValue& /*list*/) { return true; }
  // Takes a number that is not decimal; by default there is none.
  virtual bool oddNumber(double& /*value*/) { return false; }
  // Evaluates a op b if they are not both numbers; by default not allowed.
  virtual bool operate(char op, const ScriptValue& a, const ScriptValue& b, ScriptValue& result);

  const ScriptVariables& variables_;

private:
  bool list(ScriptValue& value, char close);
  bool factor(ScriptValue& value);
  bool chain(ScriptValue& value, std::string_view operators);
  bool apply(char op, ScriptValue& value, const ScriptValue& next);

  char open_;
  int depth_ = 0; // of brackets
};

} // namespace voluta::program
