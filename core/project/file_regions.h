// The regions that the file of a part gives: modifiers, ranges of heights, enforcers, blockers and
// paint of slicers, with those of their settings that have a counterpart.
#pragma once

#include "base/run_context.h"
#include "geometry/formats/part_of_file.h"
#include "project/region.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::project {

// More regions than that of one file are left out, with a note.
constexpr std::size_t kMaxRegionsOfFile = 100;

// A setting of slicers and its counterpart.
struct SlicerSetting {
  std::string_view key;       // of the slicer
  std::string_view parameter; // of a region
  // Returns the parameter's value; an empty one if a valid value has no counterpart, nullopt if it
  // is invalid.
  std::optional<std::string> (*convert)(std::string_view value) = nullptr;
};

std::span<const SlicerSetting> slicerSettings();

// Returns the regions, bodies closed by a repair if need be. Adds a note for each region, with the
// number of its settings, and for all that is left out. Throws Cancelled.
std::vector<Region> regionsOfFile(const std::vector<geometry::ModifierOfFile>& modifiers,
                                  std::vector<base::Message>& notes, const base::RunContext& ctx);

} // namespace voluta::project
