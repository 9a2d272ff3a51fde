// The commands of the menus and the settings of the pages as entries of the palette.
#pragma once

#include "window/palette/command_palette.h"

namespace voluta::window {

class CommandTable;
class PageStack;

// All actions in the menus; `table` must outlive the entries.
std::vector<PaletteEntry> commandEntries(const CommandTable& table);

// All fields with a label on the pages, except those that have no effect on the job; using one
// shows its page and moves the focus to it. `pages` must outlive the entries.
std::vector<PaletteEntry> settingEntries(PageStack& pages);

} // namespace voluta::window
