// Findings are told in English by core; how they read in the language of the window.
#pragma once

#include <QString>
#include <string>

namespace voluta::panels {

// A reason or a remedy as it is shown: translated where its sentence is known, numbers as the
// language writes them, areas and volumes with their sign.
QString findingText(const std::string& english);

} // namespace voluta::panels
