// The order in which Tab goes from field to field.
#pragma once

#include <QWidget>
#include <vector>

namespace voluta::forms {

// All that can have the keyboard in `top`, `top` included, in the order in which it is read: as the
// layouts have it, grids by rows, what a scroll area, a tab or a stack holds in its place. What is
// hidden now is among it.
std::vector<QWidget*> inReadingOrder(QWidget* top);

// Tab goes through each in turn, and from the last of one to the first of the next.
void tabInReadingOrder(const std::vector<QWidget*>& tops);

} // namespace voluta::forms
