#include "program/common/script_values.h"

#include "program/common/program_text.h"
#include "program/rapid/rapid_tokens.h"

#include <cmath>
#include <utility>

namespace voluta::program {

namespace {
constexpr int kMaxDepth = 20;
constexpr std::size_t kMaxValues = 64;

bool isNumber(const ScriptValue& v) {
  return v.kind == ScriptKind::Number;
}
} // namespace

bool ScriptScanner::value(ScriptValue& value) {
  if (++depth_ > kMaxDepth || !chain(value, "+-"))
    return false;
  --depth_;
  return !isNumber(value) || std::isfinite(value.number);
}

bool ScriptScanner::number(double& value) {
  ScriptValue found;
  if (!this->value(found) || !isNumber(found))
    return false;
  value = found.number;
  return true;
}

// Two levels: sums of products of factors.
bool ScriptScanner::chain(ScriptValue& value, std::string_view operators) {
  const bool sum = operators == "+-";
  const auto next = [&](ScriptValue& v) { return sum ? chain(v, "*/") : factor(v); };
  if (!next(value))
    return false;
  for (blanks(); !rest.empty() && operators.find(rest.front()) != std::string_view::npos;
       blanks()) {
    const char op = rest.front();
    rest.remove_prefix(1);
    ScriptValue other;
    if (!next(other) || !apply(op, value, other))
      return false;
  }
  return true;
}

bool ScriptScanner::apply(char op, ScriptValue& value, const ScriptValue& next) {
  if (!isNumber(value) || !isNumber(next)) {
    ScriptValue result;
    if (!operate(op, value, next, result))
      return false;
    value = std::move(result);
    return true;
  }
  switch (op) {
  case '+':
    value.number += next.number;
    break;
  case '-':
    value.number -= next.number;
    break;
  case '*':
    value.number *= next.number;
    break;
  default:
    value.number /= next.number;
  }
  return true;
}

bool ScriptScanner::operate(char, const ScriptValue&, const ScriptValue&, ScriptValue&) {
  return false;
}

bool ScriptScanner::list(ScriptValue& value, char close) {
  while (take(',')) {
    double next = 0.0;
    if (value.list.size() >= kMaxValues || !number(next))
      return false;
    value.list.push_back(next);
  }
  value.kind = ScriptKind::List;
  return take(close) && behindList(value);
}

bool ScriptScanner::arguments(std::vector<ScriptValue>& values) {
  if (take(')'))
    return true;
  do {
    ScriptValue next;
    if (values.size() >= kMaxValues || !value(next))
      return false;
    values.push_back(std::move(next));
  } while (take(','));
  return take(')');
}

bool ScriptScanner::factor(ScriptValue& value) {
  value = {};
  if (take('"')) {
    std::string_view text;
    value.kind = ScriptKind::Text;
    const bool closed = textBehindQuote(text);
    value.text = text;
    return closed;
  }
  if (open_ != '(' && take(open_)) {
    value.kind = ScriptKind::List;
    double first = 0.0;
    if (take('}'))
      return true;
    if (!number(first))
      return false;
    value.list.push_back(first);
    return list(value, '}');
  }
  if (take('(')) {
    if (!this->value(value))
      return false;
    blanks();
    if (open_ != '(' || rest.empty() || rest.front() != ',' || !isNumber(value))
      return take(')');
    value.list.assign(1, value.number);
    return list(value, ')');
  }
  if (const std::string_view word = name(); !word.empty())
    return named(word, value);
  value.kind = ScriptKind::Number;
  if (takeNumber(rest, value.number) || oddNumber(value.number))
    return true;
  // Unary sign before a name or bracket; the sign of a number is part of the number.
  const bool minus = take('-');
  if ((!minus && !take('+')) || ++depth_ > kMaxDepth || !factor(value) || !isNumber(value))
    return false;
  --depth_;
  value.number = minus ? -value.number : value.number;
  return true;
}

bool ScriptScanner::named(std::string_view name, ScriptValue& value) {
  const std::string small = inSmallLetters(name);
  if (small == "true" || small == "false") {
    value.kind = ScriptKind::Number;
    value.number = small == "true" ? 1.0 : 0.0;
    return true;
  }
  const auto known = variables_.find(small);
  if (known == variables_.end())
    return false;
  value = known->second;
  return true;
}

} // namespace voluta::program
