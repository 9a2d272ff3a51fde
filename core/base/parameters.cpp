#include "base/parameters.h"

#include "base/error.h"
#include "base/nearest_name.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <utility>

namespace voluta::base {

namespace {
constexpr RenamedKey kRenamedKeys[] = {
    {"directionConeDeg", "tiltToleranceDeg"},
    {"infillTurn", "infillRotation"},
    {"nozzleTurn", "nozzleRotation"},
    {"turnSmoothing", "rotationSmoothing"},
    {"underlay", "rimSupports"},
};

// Rules of the published growth schemes: the sources' own are used.
constexpr std::string_view kDroppedKeys[] = {"growthBoundary", "growthIsp", "growthQueue",
                                             "growthSacrifice"};

ParameterSpec makeSpec(std::string key, ParameterType type, std::string unit, ParameterValue value,
                       Text group, Text label, Text help, bool simple) {
  ParameterSpec spec;
  spec.key = std::move(key);
  spec.type = type;
  spec.unit = std::move(unit);
  spec.defaultValue = std::move(value);
  spec.group = group;
  spec.label = label;
  spec.help = help;
  spec.simple = simple;
  return spec;
}

Message giveRange(const ParameterSpec& spec) {
  return spec.unit.empty()
             ? message("give {least} to {most}"_text, number(spec.minimum), number(spec.maximum))
             : message("give {least} to {most} {unit}"_text, number(spec.minimum),
                       number(spec.maximum), spec.unit);
}

std::vector<std::string> idsOf(const std::vector<Choice>& choices) {
  std::vector<std::string> ids;
  for (const Choice& choice : choices)
    ids.push_back(choice.id);
  return ids;
}

template <typename T> bool parseWhole(std::string_view text, T& value) {
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  return status == std::errc{} && end == text.data() + text.size();
}
} // namespace

ParameterSpec numberParameter(std::string key, std::string unit, double defaultValue,
                              double minimum, double maximum, Text group, Text label, Text help,
                              bool simple) {
  ParameterSpec spec = makeSpec(std::move(key), ParameterType::Number, std::move(unit),
                                defaultValue, group, label, help, simple);
  spec.minimum = minimum;
  spec.maximum = maximum;
  return spec;
}

ParameterSpec integerParameter(std::string key, long long defaultValue, long long minimum,
                               long long maximum, Text group, Text label, Text help, bool simple) {
  ParameterSpec spec = makeSpec(std::move(key), ParameterType::Integer, "", defaultValue, group,
                                label, help, simple);
  spec.minimum = static_cast<double>(minimum);
  spec.maximum = static_cast<double>(maximum);
  return spec;
}

ParameterSpec booleanParameter(std::string key, bool defaultValue, Text group, Text label,
                               Text help, bool simple) {
  return makeSpec(std::move(key), ParameterType::Boolean, "", defaultValue, group, label, help,
                  simple);
}

ParameterSpec textParameter(std::string key, Text group, Text label, Text help, bool simple) {
  return makeSpec(std::move(key), ParameterType::Text, "", std::string(), group, label, help,
                  simple);
}

ParameterSpec choiceParameter(std::string key, std::string defaultValue,
                              std::vector<Choice> choices, Text group, Text label, Text help,
                              bool simple) {
  ParameterSpec spec = makeSpec(std::move(key), ParameterType::Choice, "", std::move(defaultValue),
                                group, label, help, simple);
  spec.choices = std::move(choices);
  return spec;
}

ParameterSpec ofItem(ParameterSpec spec) {
  spec.scope = ParameterScope::Item;
  return spec;
}

ParameterSpec ofRegion(ParameterSpec spec) {
  spec.scope = ParameterScope::Region;
  return spec;
}

ParameterSpec withFile(ParameterSpec spec, ParameterFile file) {
  require(spec.type == ParameterType::Text, "withFile: a text parameter");
  spec.file = std::move(file);
  return spec;
}

std::span<const RenamedKey> renamedKeys() {
  return kRenamedKeys;
}

std::string_view currentKey(std::string_view key) {
  const auto* renamed = std::ranges::find(kRenamedKeys, key, &RenamedKey::oldKey);
  return renamed == std::end(kRenamedKeys) ? key : renamed->key;
}

Message renamedNote(std::string_view oldKey) {
  const std::string_view key = currentKey(oldKey);
  require(key != oldKey, "renamedNote: a renamed key");
  return message("parameter {oldKey} was renamed to {key}"_text, oldKey, key);
}

std::span<const std::string_view> droppedKeys() {
  return kDroppedKeys;
}

Message droppedNote(std::string_view key) {
  return message("parameter {key} no longer exists: its value has no effect"_text, key);
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

void ParameterTable::appendOfItems(const ParameterTable& other) {
  const std::size_t first = specs_.size();
  append(other);
  for (std::size_t i = first; i < specs_.size(); ++i)
    if (specs_[i].scope == ParameterScope::Job)
      specs_[i].scope = ParameterScope::Item;
}

ParameterValue parseParameter(const ParameterSpec& spec, std::string_view text) {
  const auto wrong = [&](Message why, Message remedy) {
    return Error(ErrorCode::Usage, std::move(why), spec.key, std::move(remedy));
  };
  const auto outOfRange = [&] {
    return wrong(message("'{value}' is out of range"_text, text), giveRange(spec));
  };
  switch (spec.type) {
  case ParameterType::Number: {
    double value = 0.0;
    if (!parseWhole(text, value) || !std::isfinite(value))
      throw wrong(message("'{value}' is not a number"_text, text), giveRange(spec));
    if (value < spec.minimum || value > spec.maximum)
      throw outOfRange();
    return value;
  }
  case ParameterType::Integer: {
    long long value = 0;
    if (!parseWhole(text, value))
      throw wrong(message("'{value}' is not a whole number"_text, text), giveRange(spec));
    if (static_cast<double>(value) < spec.minimum || static_cast<double>(value) > spec.maximum)
      throw outOfRange();
    return value;
  }
  case ParameterType::Boolean:
    if (text == "true" || text == "on" || text == "1" || text == "yes")
      return true;
    if (text == "false" || text == "off" || text == "0" || text == "no")
      return false;
    throw wrong(message("'{value}' is neither true nor false"_text, text),
                "give true or false"_text);
  case ParameterType::Choice: {
    const std::vector<std::string> ids = idsOf(spec.choices);
    if (std::find(ids.begin(), ids.end(), text) != ids.end())
      return std::string(text);
    throw wrong(message("'{value}' is not one of {choices}"_text, text,
                        fmt::format("{}", fmt::join(ids, ", "))),
                didYouMean(text, ids));
  }
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
  const ParameterSpec* spec = table_.find(currentKey(key));
  if (!spec) {
    std::vector<std::string> keys;
    for (const ParameterSpec& known : table_.specs())
      keys.push_back(known.key);
    throw Error(ErrorCode::Usage, message("unknown parameter '{key}'"_text, key), {},
                didYouMean(key, keys));
  }
  changed_[spec->key] = parseParameter(*spec, text);
}

void ParameterValues::setAssignment(std::string_view assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string_view::npos || equals == 0)
    throw Error(ErrorCode::Usage, message("'{text}' is not key=value"_text, assignment));
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
