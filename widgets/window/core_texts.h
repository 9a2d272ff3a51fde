// Names that core's tables give in English, in the language of the window.
#pragma once

#include <QString>
#include <string>
#include <string_view>

namespace voluta::window {

// Labels of modes, growth schemes and dialects. What is not in the list comes back as it is.
QString coreLabel(std::string_view english);
// "fit:0", "disc:80", "rect:100x80" in words.
QString platformText(const std::string& platform);

} // namespace voluta::window
