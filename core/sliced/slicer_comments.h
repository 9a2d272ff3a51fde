// Comments in which slicers state what the following moves are.
#pragma once

#include "plan/tool_plan.h"
#include "sliced/sliced_file.h"

#include <optional>
#include <string_view>

namespace voluta::sliced {

// What a feature's name stands for.
struct Feature {
  std::string_view name; // As slicers write it, in any case
  plan::PathKind kind;
  bool ofPart = true;
  bool outermost = false;
  bool custom = false; // The printer's own code, not of the part
};

// Returns the feature of that name, in any case; nullptr if no slicer writes it.
const Feature* findFeature(std::string_view name);

// What one comment changes.
struct CommentFacts {
  bool layerChange = false;
  const Feature* feature = nullptr;
  std::optional<double> heightMm; // Of the beads that follow
};

// Interprets the text after ';'.
CommentFacts factsOf(std::string_view comment);

// Reads the comments of a whole file that hold for all of it. They may be at its end.
SlicedHeader headerOf(std::string_view text);

} // namespace voluta::sliced
