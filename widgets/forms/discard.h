// Widgets, actions and rows that make room for others. The request may come from a signal of one of
// them (a tick, a click, a menu entry), and Qt still uses the sender when the signal returns: all
// are taken out of sight now and freed once the event being handled is over. Nothing in widgets/
// deletes a widget in another way; a list whose rows stay the same keeps them and only fills them
// anew.
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
