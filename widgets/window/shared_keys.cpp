#include "window/shared_keys.h"

#include "panels/text_preview.h"
#include "timeline/layer_range_slider.h"
#include "timeline/timeline_bar.h"
#include "window/unrolled/unrolled_canvas.h"

#include <QAbstractScrollArea>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QKeySequenceEdit>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTableView>
#include <QTextEdit>

namespace voluta::window {

namespace {
template <typename... Kinds> bool isAny(const QWidget& widget) {
  return (... || (qobject_cast<const Kinds*>(&widget) != nullptr));
}

bool isForTyping(const QWidget& widget) {
  const auto* combo = qobject_cast<const QComboBox*>(&widget);
  return (combo && combo->isEditable()) ||
         isAny<QLineEdit, QAbstractSpinBox, QTextEdit, QPlainTextEdit, QKeySequenceEdit>(widget);
}

bool hasPlaceToGo(const QWidget& widget) {
  return isAny<QAbstractSlider, timeline::TimelineBar, timeline::LayerRangeSlider,
               panels::TextPreview, UnrolledCanvas>(widget);
}
} // namespace

SharedKeys::SharedKeys(QWidget& window, const QWidget& picture)
    : QObject(&window), window_(window), picture_(picture) {
  QCoreApplication::instance()->installEventFilter(this);
}

bool SharedKeys::keeps(const QWidget& widget, int key) const {
  if (isForTyping(widget))
    return true;
  switch (key) {
  case Qt::Key_Space:
    return byTab_ && &widget != &picture_;
  case Qt::Key_Home:
    return hasPlaceToGo(widget) || isAny<QComboBox, QTableView>(widget) ||
           (byTab_ && &widget != &picture_);
  default:
    return hasPlaceToGo(widget) || isAny<QAbstractScrollArea, QComboBox>(widget);
  }
}

bool SharedKeys::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::MouseButtonPress)
    byTab_ = false;
  if (event->type() != QEvent::KeyPress && event->type() != QEvent::ShortcutOverride)
    return QObject::eventFilter(watched, event);
  const auto* press = static_cast<QKeyEvent*>(event);
  if (press->key() == Qt::Key_Tab || press->key() == Qt::Key_Backtab)
    byTab_ = true;
  const bool shared = press->key() == Qt::Key_Space || press->key() == Qt::Key_Home ||
                      press->key() == Qt::Key_PageUp || press->key() == Qt::Key_PageDown;
  const auto* widget = qobject_cast<const QWidget*>(watched);
  if (event->type() == QEvent::ShortcutOverride && shared && widget && widget->hasFocus() &&
      widget->window() == &window_ && keeps(*widget, press->key())) {
    event->accept(); // No command: the widget receives the key
    return true;
  }
  return QObject::eventFilter(watched, event);
}

} // namespace voluta::window
