#include "project/choices.h"

#include "base/error.h"
#include "base/number_list.h"

#include <fmt/format.h>

namespace voluta::project {

Choices onlyItem(const Choices& choices, std::size_t item) {
  Choices one = choices;
  one.items = {choices.item(item)};
  return one;
}

double parsedScale(const std::string& scale) {
  if (scale == "fit")
    return 0.0;
  double value = 0.0;
  if (!base::readNumbers(scale, ',', {&value}) || value < 1e-4 || value > 1e4)
    throw base::Error(base::ErrorCode::Usage, base::message("invalid scale '{scale}'"_text, scale),
                      {}, "give a number from 0.0001 to 10000, or fit"_text);
  return value;
}

} // namespace voluta::project
