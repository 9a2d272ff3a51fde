// Small line icons, sharp at any scale, in the colours of the application's palette.
#pragma once

#include <QIcon>
#include <QPalette>
#include <QPixmap>
#include <QRectF>

class QPainter;
class QWidget;

namespace voluta::forms {

enum class Icon {
  Blocked,   // Red octagon with a bar
  Warning,   // Amber triangle with an exclamation mark
  Note,      // Grey disc with an i: worth knowing
  Good,      // Green disc with a tick
  Pending,   // Grey ring
  EyeOpen,   // Shown
  EyeClosed, // Hidden
  Reset,     // Arrow turning back
  Foreign    // Globe: for another maker's controller
};

// Draws the icon into the square in the centre of `where`.
void paintIcon(QPainter& painter, const QRectF& where, Icon which, const QPalette& palette);

// Drawn with QGuiApplication::palette() each time it is shown, so it follows light and dark.
QIcon icon(Icon which);

// Returns an icon as high as a line of the widget's text, to be placed beside it.
QPixmap iconBeside(const QWidget& text, Icon which);

} // namespace voluta::forms
