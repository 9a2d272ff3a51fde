// A value with limits in a process's or a material's file: {"default", "min", "max"}.
#pragma once

#include "base/json_node.h"

namespace voluta::process {

struct ChosenRange {
  double usual = 0.0, least = 0.0, most = 0.0; // 0 < least <= usual <= most
};

// Throws Error{UnusableInput} naming the key.
inline ChosenRange readRange(const base::JsonNode& node) {
  node.allowOnly({"default", "min", "max"});
  ChosenRange range;
  range.least = node.at("min").positive();
  range.usual = node.at("default").positive();
  range.most = node.at("max").positive();
  if (range.usual < range.least)
    node.at("default").fail("is below 'min'"_text);
  if (range.usual > range.most)
    node.at("default").fail("is above 'max'"_text);
  return range;
}

} // namespace voluta::process
