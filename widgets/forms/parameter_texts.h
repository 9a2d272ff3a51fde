// The texts of the parameter tables in the user's language. They live in core without Qt; the
// source file of this header lists them for lupdate in the context "Parameters".
#pragma once

#include "base/parameters.h"

#include <QString>
#include <vector>

namespace voluta::forms {

// Translated through the context "Parameters", with a capital first letter.
QString parameterText(const std::string& text);
// "mm", "mm/s"; "deg" becomes the degree sign.
QString unitText(const std::string& unit);
// A value with its unit, as the form shows it.
QString valueText(const base::ParameterSpec& spec, const base::ParameterValue& value);
// Help, key, range and default of a parameter, as a tool tip.
QString parameterToolTip(const base::ParameterSpec& spec);
// The texts listed for translation; a test holds it to the tables.
std::vector<const char*> listedParameterTexts();

} // namespace voluta::forms
