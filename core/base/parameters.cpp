#include "base/parameters.h"

#include "base/error.h"
#include "base/nearest_name.h"

#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace voluta::base {

namespace {
ParameterSpec makeSpec(std::string key, ParameterType type, std::string unit, ParameterValue value,
                       std::string group, std::string label, std::string help, bool simple) {
  ParameterSpec spec;
  spec.key = std::move(key);
  spec.type = type;
  spec.unit = std::move(unit);
  spec.defaultValue = std::move(value);
  spec.group = std::move(group);
  spec.label = std::move(label);
  spec.help = std::move(help);
  spec.simple = simple;
  return spec;
}

std::string rangeOf(const ParameterSpec& spec) {
  return fmt::format("{:g} to {:g}{}{}", spec.minimum, spec.maximum, spec.unit.empty() ? "" : " ",
                     spec.unit);
}

template <typename T> bool parseWhole(std::string_view text, T& value) {
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  return status == std::errc{} && end == text.data() + text.size();
}
} // namespace

ParameterSpec numberParameter(std::string key, std::string unit, double defaultValue,
                              double minimum, double maximum, std::string group, std::string label,
                              std::string help, bool simple) {
  ParameterSpec spec =
      makeSpec(std::move(key), ParameterType::Number, std::move(unit), defaultValue,
               std::move(group), std::move(label), std::move(help), simple);
  spec.minimum = minimum;
  spec.maximum = maximum;
  return spec;
}

ParameterSpec integerParameter(std::string key, long long defaultValue, long long minimum,
                               long long maximum, std::string group, std::string label,
                               std::string help, bool simple) {
  ParameterSpec spec = makeSpec(std::move(key), ParameterType::Integer, "", defaultValue,
                                std::move(group), std::move(label), std::move(help), simple);
  spec.minimum = static_cast<double>(minimum);
  spec.maximum = static_cast<double>(maximum);
  return spec;
}

ParameterSpec booleanParameter(std::string key, bool defaultValue, std::string group,
                               std::string label, std::string help, bool simple) {
  return makeSpec(std::move(key), ParameterType::Boolean, "", defaultValue, std::move(group),
                  std::move(label), std::move(help), simple);
}

ParameterSpec textParameter(std::string key, std::string group, std::string label, std::string help,
                            bool simple) {
  return makeSpec(std::move(key), ParameterType::Text, "", std::string(), std::move(group),
                  std::move(label), std::move(help), simple);
}

ParameterSpec choiceParameter(std::string key, std::string defaultValue,
                              std::vector<std::string> choices, std::string group,
                              std::string label, std::string help, bool simple) {
  ParameterSpec spec = makeSpec(std::move(key), ParameterType::Choice, "", std::move(defaultValue),
                                std::move(group), std::move(label), std::move(help), simple);
  spec.choices = std::move(choices);
  return spec;
}

ParameterTable::ParameterTable(std::vector<ParameterSpec> specs) {
  ParameterTable all;
  for (ParameterSpec& spec : specs) {
    require(all.find(spec.key) == nullptr, "parameter key declared twice: " + spec.key);
    all.specs_.push_back(std::move(spec));
  }
  specs_ = std::move(all.specs_);
}

const ParameterSpec* ParameterTable::find(std::string_view key) const {
  for (const ParameterSpec& spec : specs_)
    if (spec.key == key)
      return &spec;
  return nullptr;
}

void ParameterTable::append(const ParameterTable& other) {
  for (const ParameterSpec& spec : other.specs_) {
    require(find(spec.key) == nullptr, "parameter key declared twice: " + spec.key);
    specs_.push_back(spec);
  }
}

ParameterValue parseParameter(const ParameterSpec& spec, std::string_view text) {
  const auto wrong = [&](const std::string& why, const std::string& remedy) {
    return Error(ErrorCode::Usage, fmt::format("'{}' {}", text, why), spec.key, remedy);
  };
  switch (spec.type) {
  case ParameterType::Number: {
    double value = 0.0;
    if (!parseWhole(text, value) || !std::isfinite(value))
      throw wrong("is not a number", "give " + rangeOf(spec));
    if (value < spec.minimum || value > spec.maximum)
      throw wrong("is out of range", "give " + rangeOf(spec));
    return value;
  }
  case ParameterType::Integer: {
    long long value = 0;
    if (!parseWhole(text, value))
      throw wrong("is not a whole number", "give " + rangeOf(spec));
    if (static_cast<double>(value) < spec.minimum || static_cast<double>(value) > spec.maximum)
      throw wrong("is out of range", "give " + rangeOf(spec));
    return value;
  }
  case ParameterType::Boolean:
    if (text == "true" || text == "on" || text == "1" || text == "yes")
      return true;
    if (text == "false" || text == "off" || text == "0" || text == "no")
      return false;
    throw wrong("is neither true nor false", "give true or false");
  case ParameterType::Choice:
    for (const std::string& choice : spec.choices)
      if (choice == text)
        return std::string(text);
    throw wrong("is not one of " + fmt::format("{}", fmt::join(spec.choices, ", ")),
                "did you mean " + nearestName(text, spec.choices) + "?");
  case ParameterType::Text:
    return std::string(text);
  }
  failPrecondition("parameter type");
}

std::string formatParameter(const ParameterValue& value) {
  return std::visit(
      [](const auto& v) -> std::string {
        using T = std::decay_t<decltype(v)>;
        if constexpr (std::is_same_v<T, bool>)
          return v ? "true" : "false";
        else if constexpr (std::is_same_v<T, std::string>)
          return v;
        else
          return fmt::format("{}", v);
      },
      value);
}

void ParameterValues::set(std::string_view key, std::string_view text) {
  const ParameterSpec* spec = table_.find(key);
  if (!spec) {
    std::vector<std::string> keys;
    for (const ParameterSpec& known : table_.specs())
      keys.push_back(known.key);
    throw Error(ErrorCode::Usage, fmt::format("unknown parameter '{}'", key), {},
                "did you mean " + nearestName(key, keys) + "?");
  }
  changed_[spec->key] = parseParameter(*spec, text);
}

void ParameterValues::setAssignment(std::string_view assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string_view::npos || equals == 0)
    throw Error(ErrorCode::Usage, fmt::format("'{}' is not key=value", assignment));
  set(assignment.substr(0, equals), assignment.substr(equals + 1));
}

bool ParameterValues::changed(std::string_view key) const {
  return changed_.find(key) != changed_.end();
}

const ParameterValue& ParameterValues::value(std::string_view key) const {
  if (const auto found = changed_.find(key); found != changed_.end())
    return found->second;
  const ParameterSpec* spec = table_.find(key);
  require(spec != nullptr, "no such parameter: " + std::string(key));
  return spec->defaultValue;
}

double ParameterValues::number(std::string_view key) const {
  const ParameterValue& v = value(key);
  if (const auto* whole = std::get_if<long long>(&v))
    return static_cast<double>(*whole);
  require(std::holds_alternative<double>(v), "not a number: " + std::string(key));
  return std::get<double>(v);
}

long long ParameterValues::integer(std::string_view key) const {
  const ParameterValue& v = value(key);
  require(std::holds_alternative<long long>(v), "not an integer: " + std::string(key));
  return std::get<long long>(v);
}

bool ParameterValues::boolean(std::string_view key) const {
  const ParameterValue& v = value(key);
  require(std::holds_alternative<bool>(v), "not a boolean: " + std::string(key));
  return std::get<bool>(v);
}

std::string ParameterValues::text(std::string_view key) const {
  const ParameterValue& v = value(key);
  require(std::holds_alternative<std::string>(v), "not a text: " + std::string(key));
  return std::get<std::string>(v);
}

} // namespace voluta::base
