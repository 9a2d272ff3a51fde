// The rows of the table of commands that are no page's: view, time-line, window, help.
#pragma once

#include "window/commands.h"

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

// The menus of the window in their order, and what is inside them.
const std::vector<CommandMenu>& commandMenus();

std::vector<Command> undoCommands(QUndoStack& edits);
// `showView`: called when more or less is to be seen.
std::vector<Command> viewCommands(PictureArea& area, Picture& picture, UnrolledDock& unrolled,
                                  const std::function<void()>& showView);
std::vector<Command> timelineCommands(timeline::TimelineBar& bar);
std::vector<Command> languageCommands();
// Asks for a file and saves the viewport as it is; `name`: proposed, without ending. `failed` is
// called with the file where it cannot be written.
void savePicture(PictureArea& area, const QString& name,
                 const std::function<void(const QString&)>& failed);
void showAbout(QWidget& window);

} // namespace voluta::window
