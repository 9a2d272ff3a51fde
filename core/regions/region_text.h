// A region as a text, as on the command line.
#pragma once

#include "base/run_context.h"
#include "project/region.h"

#include <string>
#include <string_view>

namespace voluta::regions {

// The form of a region as a text.
inline constexpr std::string_view kRegionForm = "SHAPE[;use=USE][;name=NAME][;KEY=VALUE]...";

// Reads a text of that form; the mesh of a shape from a file is read and repaired. Its use is the
// usual one of its shape. Throws Error{Usage} for a text of another form, a shape or a use that
// does not exist; Error{UnreadableFile, UnusableInput} for the file, also if its mesh is not
// closed.
project::Region parsedRegion(const std::string& text, const base::RunContext& ctx);

} // namespace voluta::regions
