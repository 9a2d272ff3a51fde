// Values for a parameter of a test.
#pragma once

#include "base/parameters.h"

#include <string>
#include <variant>

namespace voluta::test {

// Returns another value than the default, as text.
inline std::string otherText(const base::ParameterSpec& spec) {
  switch (spec.type) {
  case base::ParameterType::Number:
    return base::formatParameter(
        std::get<double>(spec.defaultValue) == spec.maximum ? spec.minimum : spec.maximum);
  case base::ParameterType::Integer: {
    const auto limit = static_cast<long long>(spec.maximum);
    return base::formatParameter(std::get<long long>(spec.defaultValue) == limit
                                     ? static_cast<long long>(spec.minimum)
                                     : limit);
  }
  case base::ParameterType::Boolean:
    return std::get<bool>(spec.defaultValue) ? "false" : "true";
  case base::ParameterType::Choice:
    for (const auto& choice : spec.choices)
      if (choice.id != std::get<std::string>(spec.defaultValue))
        return choice.id;
    break;
  case base::ParameterType::Text:
    return spec.file.patterns == "*.json" ? "[]" : "1,2,3"; // no name of a file
  }
  return {};
}

} // namespace voluta::test
