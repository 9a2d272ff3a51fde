// The parameters that change the tool-paths of a file before they are placed: amounts, turns from
// layer to layer, another ground, another frame.
#pragma once

#include "base/parameters.h"
#include "sliced/path_shape.h"

#include <string>

namespace voluta::pipeline {

base::ParameterTable pathShapeParameters();

// Cache key; empty if nothing changes. Does not throw.
std::string pathShapeKey(const base::ParameterValues& values);

// Throws Error{Usage} for an invalid frame or radius.
sliced::PathShape pathShape(const base::ParameterValues& values);

} // namespace voluta::pipeline
