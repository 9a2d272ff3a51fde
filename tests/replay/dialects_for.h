// The formats that can be written for an arm: all except those with joints of another maker's.
#pragma once

#include "program/dialect.h"

#include <string>
#include <string_view>
#include <vector>

namespace voluta::test {

inline std::vector<program::Dialect> dialectsFor(std::string_view controller) {
  std::vector<program::Dialect> all = program::dialects();
  std::erase_if(all, [&](const program::Dialect& d) {
    return d.needsJoints && !d.controller.empty() && d.controller != controller;
  });
  return all;
}

inline std::vector<std::string> idsFor(std::string_view controller) {
  std::vector<std::string> ids;
  for (const program::Dialect& dialect : dialectsFor(controller))
    ids.emplace_back(dialect.id);
  return ids;
}

} // namespace voluta::test
