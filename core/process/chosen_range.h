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
    node.at("default").fail(base::message("is {usual}, below 'min', which is {least}"_text,
                                          base::number(range.usual), base::number(range.least)));
  if (range.usual > range.most)
    node.at("default").fail(base::message("is {usual}, above 'max', which is {most}"_text,
                                          base::number(range.usual), base::number(range.most)));
  return range;
}

} // namespace voluta::process
