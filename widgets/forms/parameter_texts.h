// How values of parameters are shown, in the user's language.
#pragma once

#include "base/parameters.h"

#include <QString>

namespace voluta::forms {

// "mm", "mm/s"; "deg" becomes the degree sign.
QString unitText(const std::string& unit);
// A value with its unit, as the form shows it.
QString valueText(const base::ParameterSpec& spec, const base::ParameterValue& value);
// Help, key, range and default of a parameter, as a tool tip.
QString parameterToolTip(const base::ParameterSpec& spec);

} // namespace voluta::forms
