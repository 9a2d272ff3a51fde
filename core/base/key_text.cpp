#include "base/key_text.h"

#include <fmt/format.h>

namespace voluta::base {

void KeyText::addNumber(double value) {
  text_ += fmt::format(" {}", value);
}

void KeyText::addWhole(std::int64_t value) {
  text_ += fmt::format(" {}", value);
}

void KeyText::addText(std::string_view value) {
  text_ += fmt::format(" {}:{}", value.size(), value);
}

} // namespace voluta::base
