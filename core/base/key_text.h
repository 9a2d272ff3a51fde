// Cache key: canonical text of all inputs; equal keys mean equal results. Built from the options
// themselves, member by member, so that none can be forgotten.
#pragma once

#include "base/members.h"

#include <concepts>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace voluta::base {

class KeyText {
public:
  // Accepts numbers, texts, enumerations; lists and Eigen columns of these; structs of these, whose
  // members are added in order; and any type with a function keyOf(value) in its namespace that
  // returns a text.
  template <typename T> KeyText& add(const T& value) {
    if constexpr (requires {
                    { keyOf(value) } -> std::convertible_to<std::string>;
                  })
      addText(keyOf(value));
    else if constexpr (std::is_same_v<T, bool>)
      addWhole(value ? 1 : 0);
    else if constexpr (std::is_enum_v<T>)
      addWhole(static_cast<std::int64_t>(value));
    else if constexpr (std::is_integral_v<T>)
      addWhole(static_cast<std::int64_t>(value));
    else if constexpr (std::is_floating_point_v<T>)
      addNumber(static_cast<double>(value));
    else if constexpr (std::is_convertible_v<const T&, std::string_view>)
      addText(value);
    else if constexpr (requires {
                         value.coeff(0);
                         value.size();
                       })
      for (decltype(value.size()) i = 0; i < value.size(); ++i)
        addNumber(static_cast<double>(value.coeff(i)));
    else if constexpr (requires {
                         value.begin();
                         value.end();
                         value.size();
                       }) {
      addWhole(static_cast<std::int64_t>(value.size()));
      for (const auto& one : value)
        add(one);
    } else
      std::apply([&](const auto&... member) { (add(member), ...); }, members(value));
    return *this;
  }

  const std::string& text() const { return text_; }

private:
  void addNumber(double value);
  void addWhole(std::int64_t value);
  // With its length, so that different lists of texts give different keys
  void addText(std::string_view value);

  std::string text_;
};

// Returns the key as one line.
template <typename... T> std::string keyText(const T&... values) {
  KeyText key;
  (key.add(values), ...);
  return key.text() + "\n";
}

} // namespace voluta::base
