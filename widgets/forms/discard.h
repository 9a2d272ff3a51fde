// Removes widgets, actions and rows that others replace. The request may come from a signal of one
// of them (a tick, a click, a menu entry), and Qt still uses the sender when the signal returns, so
// they are hidden now and freed after the current event. Other deletions in widgets/ happen outside
// such signals: a widget is deleted with its parent; a box deletes itself after it is closed
// (Qt::WA_DeleteOnClose, which waits for the end of the event too) or at the end of the function
// that waits for its answer; rows and entries are removed from a list by another trigger (a key, a
// setter with its signals blocked). A list whose rows stay the same keeps them and only updates
// their contents.
#pragma once

class QAction;
class QTreeWidget;
class QWidget;

namespace voluta::forms {

// Also removes its object name and its place in the layout, so that its successor can take both.
void discard(QWidget* widget);
void discard(QAction* action);
// Removes all rows; emits nothing.
void discardRows(QTreeWidget& tree);

} // namespace voluta::forms
