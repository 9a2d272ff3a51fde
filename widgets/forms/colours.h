// Colours with a meaning, chosen for the current palette. Everything else uses the palette's own
// colours, and colour is never the only cue: an icon always accompanies it.
#pragma once

#include <QColor>
#include <QPalette>

namespace voluta::forms {

// Returns whether text is lighter than its background.
bool isDark(const QPalette& palette);

// Returns whether it is that of the look with high contrast: white on black.
bool isHighContrast(const QPalette& palette);

// Interpolates from one colour to the other; `share` in [0, 1].
QColor mixed(const QColor& from, const QColor& to, double share);

QColor blockedColour(const QPalette& palette); // Red: blocked, and nothing else
QColor warningColour(const QPalette& palette); // Amber: worth knowing
QColor goodColour(const QPalette& palette);    // Green: passed
QColor mutedColour(const QPalette& palette);   // Secondary lines, line numbers
QColor matchColour(const QPalette& palette);   // Background of search matches

} // namespace voluta::forms
