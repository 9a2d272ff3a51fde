// Which files make up a RAPID program: its list of modules (.pgf).
#pragma once

#include <string_view>

namespace voluta::program {

bool isModuleList(std::string_view text);
// A trimmed line of a list that names a module becomes the name.
bool takeModule(std::string_view& line);

} // namespace voluta::program
