// Parameters as text for the keys of stages.
#pragma once

#include "base/parameters.h"

#include <initializer_list>
#include <string>

namespace voluta::modes {

// "key=value" a line of the parameters of `table` as `values` have them.
std::string parameterText(const base::ParameterTable& table, const base::ParameterValues& values);
// The same of these keys, which must be known.
std::string parameterText(std::initializer_list<const char*> keys,
                          const base::ParameterValues& values);

} // namespace voluta::modes
