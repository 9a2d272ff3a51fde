// Widgets, actions and rows that make room for others. The request may come from a signal of one of
// them (a tick, a click, a menu entry), and Qt still uses the sender when the signal returns: all
// are taken out of sight now and freed once the event being handled is over. Other deletions in
// widgets/ have no such signal under way: a widget goes with its parent; a box deletes itself once
// it is closed (Qt::WA_DeleteOnClose, which waits for that event to end too) or ends with the
// function that waits for its answer; rows and entries go from a list that is asked by something
// else than they are (a key, a setter with its signals blocked). A list whose rows stay the same
// keeps them and only fills them anew.
#pragma once

class QAction;
class QTreeWidget;
class QWidget;

namespace voluta::forms {

// Also takes its object name and its place in the layout away: both belong to its successor.
void discard(QWidget* widget);
void discard(QAction* action);
// All rows; emits nothing.
void discardRows(QTreeWidget& tree);

} // namespace voluta::forms
