// Small icons drawn with lines, sharp at any scale, in the colours of the application's palette.
#pragma once

#include <QIcon>
#include <QPalette>
#include <QPixmap>
#include <QRectF>

class QPainter;
class QWidget;

namespace voluta::forms {

enum class Icon {
  Blocked,   // red octagon with a bar
  Warning,   // amber triangle with an exclamation mark
  Good,      // green disc with a tick
  Pending,   // grey ring
  EyeOpen,   // shown
  EyeClosed, // hidden
  Reset,     // arrow turning back
  Foreign    // globe: for another maker's controller
};

// Draws the icon into the square in the middle of `where`.
void paintIcon(QPainter& painter, const QRectF& where, Icon which, const QPalette& palette);

// Drawn anew with QGuiApplication::palette() each time it is shown, so it follows light and dark.
QIcon icon(Icon which);

// As high as a line of the widget's text, beside which it stands.
QPixmap iconBeside(const QWidget& text, Icon which);

} // namespace voluta::forms
