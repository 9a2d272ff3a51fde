#include "modes/parameter_text.h"

#include <fmt/format.h>

namespace voluta::modes {

namespace {

// Defaults are those of the values: a mode may have its own.
std::string parameterLine(std::string_view key, const base::ParameterValues& values) {
  const base::ParameterSpec& spec = *values.table().find(key);
  const auto changed = values.changes().find(key);
  return fmt::format("{}={}\n", spec.key,
                     base::formatParameter(changed == values.changes().end() ? spec.defaultValue
                                                                             : changed->second));
}

} // namespace

std::string parameterText(const base::ParameterTable& table, const base::ParameterValues& values) {
  std::string text;
  for (const base::ParameterSpec& spec : table.specs())
    text += parameterLine(spec.key, values);
  return text;
}

std::string parameterText(std::initializer_list<const char*> keys,
                          const base::ParameterValues& values) {
  std::string text;
  for (const char* key : keys)
    text += parameterLine(key, values);
  return text;
}

} // namespace voluta::modes
