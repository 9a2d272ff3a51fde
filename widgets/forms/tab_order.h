// The order in which Tab moves between fields.
#pragma once

#include <QWidget>
#include <vector>

namespace voluta::forms {

// Returns all widgets in `top`, including `top`, that can have the keyboard focus, in reading
// order: as arranged by the layouts, grids by rows, the contents of a scroll area, a tab or a stack
// at its place. Includes hidden widgets.
std::vector<QWidget*> inReadingOrder(QWidget* top);

// Makes Tab go through each of `tops` in turn, and from the last widget of one to the first of the
// next.
void tabInReadingOrder(const std::vector<QWidget*>& tops);

} // namespace voluta::forms
