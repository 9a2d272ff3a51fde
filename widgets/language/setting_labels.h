// Settings that texts of core name (base/setting_marks.h), as the forms show them.
#pragma once

#include <QString>
#include <string>
#include <string_view>

namespace voluta::language {

// Returns the label of a setting, and its value if there is one, in quotation marks:
// `brimWidthMm` is “Brim width”, `orient=none` “Turn the part: None”. Empty for a setting that
// has no form, and only for these. Settings that no table has are returned unchanged.
QString settingText(std::string_view setting);
// Returns the sentence with the settings that it names in backquotes as settingText().
std::string withSettingTexts(const std::string& sentence);

} // namespace voluta::language
