// A value with limits in a process's or a material's file: {"default", "min", "max"}.
#pragma once

#include "base/json_node.h"

namespace voluta::process {

struct ChosenRange {
  double usual = 0.0, minimum = 0.0, maximum = 0.0; // 0 < minimum <= usual <= maximum
};

// Throws Error{UnusableInput} naming the key.
inline ChosenRange readRange(const base::JsonNode& node) {
  node.allowOnly({"default", "min", "max"});
  ChosenRange range;
  range.minimum = node.at("min").positive();
  range.usual = node.at("default").positive();
  range.maximum = node.at("max").positive();
  if (range.usual < range.minimum)
    node.at("default").fail(base::message("is {usual}, below 'min', which is {least}"_text,
                                          base::number(range.usual), base::number(range.minimum)));
  if (range.usual > range.maximum)
    node.at("default").fail(base::message("is {usual}, above 'max', which is {most}"_text,
                                          base::number(range.usual), base::number(range.maximum)));
  return range;
}

} // namespace voluta::process
