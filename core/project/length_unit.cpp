#include "project/length_unit.h"

#include "base/error.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vector>

namespace voluta::project {

std::span<const LengthUnit> lengthUnits() {
  static constexpr std::array<LengthUnit, 5> kUnits{
      {{"um", 1e-3}, {"mm", 1.0}, {"cm", 10.0}, {"in", 25.4}, {"m", 1000.0}}};
  return kUnits;
}

const LengthUnit& lengthUnit(const std::string& word) {
  const auto row = std::ranges::find(lengthUnits(), word, &LengthUnit::word);
  if (row != lengthUnits().end())
    return *row;
  std::vector<std::string_view> words;
  for (const LengthUnit& unit : lengthUnits())
    words.push_back(unit.word);
  throw base::Error(
      base::ErrorCode::Usage, base::message("'{units}' is not a unit of length"_text, word), {},
      base::message("give one of {known}"_text, fmt::format("{}", fmt::join(words, ", "))));
}

} // namespace voluta::project
