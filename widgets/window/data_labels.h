// Labels of cells, processes and materials, as their files state them.
#pragma once

#include "forms/choice_combo.h"

#include <QString>
#include <string>
#include <vector>

namespace voluta::window {

// A choice is an id, a file or a text. Returns its id if it cannot be read.
QString cellLabel(const std::string& choice);
QString processLabel(const std::string& choice);
QString materialLabel(const std::string& id);

// The entries of a list: where several have one label, their ids stand behind it.
std::vector<forms::ChoiceItem> labelledItems(const std::vector<std::string>& ids,
                                             QString (*labelOf)(const std::string&));

} // namespace voluta::window
