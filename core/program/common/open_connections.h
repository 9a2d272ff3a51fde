// Connections to other machines that a program has open, such as the one to the extruder.
#pragma once

#include "program/common/program_text.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace voluta::program {

class OpenConnections {
public:
  // `address`: of the other machine; empty where another statement states it.
  void open(std::string_view name, std::string_view address) {
    addresses_.insert_or_assign(std::string(name), std::string(address));
  }
  void close(std::string_view name) {
    if (const auto found = addresses_.find(name); found != addresses_.end())
      addresses_.erase(found);
  }
  void closeAll() { addresses_.clear(); }

  // Returns where texts go by the connection of that name: the name with the address. nullopt: it
  // is not open.
  std::optional<std::string> destination(std::string_view name) const {
    const auto found = addresses_.find(name);
    if (found == addresses_.end())
      return std::nullopt;
    return found->second.empty() ? found->first : joined({found->first, " at ", found->second});
  }

private:
  std::map<std::string, std::string, std::less<>> addresses_; // by name
};

// Says that a text goes nowhere, because no connection of that name is open.
inline base::Message notOpen(std::string_view name) {
  return base::message("this text goes nowhere: the connection '{name}' is not open"_text,
                       name.substr(0, 40));
}

} // namespace voluta::program
