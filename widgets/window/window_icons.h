// Line icons in the palette's colour, from resources/icons (compiled in).
#pragma once

#include <QColor>
#include <QIcon>
#include <QString>

class QPalette;

namespace voluta::window {

// Returns an icon by its name without folder and extension, e.g. "open". Precondition: it exists (a
// missing one is a bug and gives an empty icon, which a test finds).
QIcon icon(const QString& name, const QPalette& palette);

} // namespace voluta::window
