// Values for a parameter of a test.
#pragma once

#include "base/parameters.h"

#include <map>
#include <string>
#include <variant>

namespace voluta::test {

// Values of texts that have a form; one that may name a file needs a row, whose value is also the
// content of a file.
inline std::string otherWords(const std::string& key) {
  static const std::map<std::string, std::string> kTexts{
      {"pieceMaterials", "red PLA"},
      {"cutPlanes", R"([{"point": [0, 0, 4], "normal": [0, 0, 1]}])"},
      {"layerPlanes", R"([{"point": [0, 0, 0.4], "normal": [0, 0, 1]}])"},
      {"pieceRoot", "0,0,0"},
      {"rodProfile", "-20,3 20,3"},
      {"layerCentre", "0,0,-9"},
      {"endSurface", "flat:9"},
      {"accept", "uncovered=0.05"},
      {"layerEvents", "2 output 3 on"},
      {"fibreCurves", "0,0 10,0"},
      {"fibreField", "0,0,0,1,0,0"}};
  const auto row = kTexts.find(key);
  return row == kTexts.end() ? "1,2,3" : row->second;
}

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
    return otherWords(spec.key);
  }
  return {};
}

} // namespace voluta::test
