// Materials within other files.
#pragma once

#include "base/json_node.h"
#include "process/material.h"

namespace voluta::process {

// Reads a material from a file's top level, or from a member of another file. Throws as
// readMaterialText().
Material readMaterialNode(const base::JsonNode& node);

// Returns a density [g/cm3]. Throws Error{UnusableInput} naming the key if it is none.
double readDensity(const base::JsonNode& node);

} // namespace voluta::process
