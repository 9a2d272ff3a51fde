// Texts of parameter values in the user's language.
#pragma once

#include "base/parameters.h"

#include <QString>

namespace voluta::language {

// Returns "mm" or "mm/s" unchanged; "deg" as the degree sign, "share" as the sign of percent.
QString unitText(const std::string& unit);
// Returns the number that is shown for a value of 1.
double shownFactor(const base::ParameterSpec& spec);
// Returns a value with its unit, as shown in the form.
QString valueText(const base::ParameterSpec& spec, const base::ParameterValue& value);
// Returns help, key, range and default of a parameter as a tool tip.
QString parameterToolTip(const base::ParameterSpec& spec);

} // namespace voluta::language
