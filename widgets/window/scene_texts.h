// Texts that widgets/scene gives in English, in the language of the window.
#pragma once

#include <QString>
#include <string_view>

namespace voluta::window {

// Numbers and anything that is not in the list come back as they are.
QString sceneText(std::string_view english);

} // namespace voluta::window
