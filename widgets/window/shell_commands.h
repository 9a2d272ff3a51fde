// The commands that belong to no page: view, time-line, window, help.
#pragma once

#include "window/window_commands.h"

#include <functional>
#include <vector>

class QUndoStack;

namespace voluta::timeline {
class TimelineBar;
}

namespace voluta::window {

class Picture;
class PictureArea;
class UnrolledDock;

// Returns the menus of the window in their order, with their submenus.
const std::vector<CommandMenu>& commandMenus();

std::vector<Command> undoCommands(QUndoStack& edits);
// `showView`: called when the visible content of the view changes.
std::vector<Command> viewCommands(PictureArea& area, Picture& picture, UnrolledDock& unrolled,
                                  const std::function<void()>& showView);
std::vector<Command> timelineCommands(timeline::TimelineBar& bar);
std::vector<Command> languageCommands();
// Asks for a file and saves the viewport as it is. `name`: proposed file name without extension.
// `failed` is called with the file if it cannot be written.
void savePicture(PictureArea& area, const QString& name,
                 const std::function<void(const QString&)>& failed);
void showAbout(QWidget& window);

} // namespace voluta::window
