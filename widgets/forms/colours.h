// Colours with a meaning, chosen for the palette in use. Everything else is drawn in the palette's
// own colours, and no meaning is told by colour alone: an icon always goes with it.
#pragma once

#include <QColor>
#include <QPalette>

namespace voluta::forms {

// Is text lighter than what it stands on?
bool isDark(const QPalette& palette);

// `share` of the way from one to the other.
QColor mixed(const QColor& from, const QColor& to, double share);

QColor blockedColour(const QPalette& palette); // red: blocked, and nothing else
QColor warningColour(const QPalette& palette); // amber: worth knowing
QColor goodColour(const QPalette& palette);    // green: passed
QColor mutedColour(const QPalette& palette);   // second lines, line numbers
QColor matchColour(const QPalette& palette);   // behind text that a search found

} // namespace voluta::forms
