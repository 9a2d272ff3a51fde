// Line icons in the palette's own colour, from resources/icons (compiled in).
#pragma once

#include <QColor>
#include <QIcon>
#include <QString>

class QPalette;

namespace voluta::window {

// Name without folder and ending, e.g. "open". Precondition: it exists (a missing one is a mistake
// in the program and gives an empty icon, which a test finds).
QIcon icon(const QString& name, const QPalette& palette);

} // namespace voluta::window
