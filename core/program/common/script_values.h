// Values of languages whose statements hold numbers, texts, lists of numbers and names: sums,
// products, variables.
#pragma once

#include "program/common/text_scanner.h"

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

enum class ScriptKind { None, Number, List, Text };

struct ScriptValue {
  ScriptKind kind = ScriptKind::None;
  double number = 0.0; // truths are 0 and 1
  std::vector<double> list;
  std::vector<double> flags; // behind the list, in languages that have them
  std::string text;
};

// By their names in small letters.
using ScriptVariables = std::map<std::string, ScriptValue, std::less<>>;

// Each function gives false where the text is no such thing, and may then stand anywhere.
class ScriptScanner : public TextScanner {
public:
  // A list stands between `open` and the bracket that closes it.
  ScriptScanner(std::string_view text, const ScriptVariables& variables, char open)
      : TextScanner{text}, variables_(variables), open_(open) {}
  virtual ~ScriptScanner() = default;

  bool value(ScriptValue& value);
  bool number(double& value);
  // Behind the opening bracket: values up to the closing one.
  bool arguments(std::vector<ScriptValue>& values);

protected:
  // What a name stands for; by default a variable.
  virtual bool named(std::string_view name, ScriptValue& value);
  // What may stand behind a list; by default nothing.
  virtual bool behindList(ScriptValue& /*list*/) { return true; }
  // A number that is no decimal one; by default there is none.
  virtual bool oddNumber(double& /*value*/) { return false; }
  // a op b where not both are numbers; by default there is no such thing.
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
