// Settings that texts name. A text has a setting as it is typed, in backquotes: `brimWidthMm`,
// `orient=none`, `--scale fit`. The language decides how it is shown (Language::sentence): the
// command line, reports and logs show it as typed, the window shows its label.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::base {

// Returns the settings named by a sentence, in order, without backquotes.
std::vector<std::string> settingsIn(std::string_view sentence);
// Returns the sentence with each setting as `written` returns it. If that is empty, parentheses
// that contain only the setting are left out too.
std::string withSettings(std::string_view sentence,
                         const std::function<std::string(std::string_view)>& written);
// Returns the sentence with its settings as typed.
std::string withSettingsAsTyped(std::string_view sentence);

} // namespace voluta::base
