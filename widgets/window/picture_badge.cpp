#include "window/picture_badge.h"

#include "forms/colours.h"

#include <QEvent>
#include <QPainter>

namespace voluta::window {

namespace {
constexpr int kMargin = 10, kPadding = 12, kDot = 8, kGap = 8;
}

PictureBadge::PictureBadge(QWidget* parent) : QWidget(parent) {
  setObjectName("pictureBadge");
  hide();
  parent->installEventFilter(this);
}

void PictureBadge::setText(const QString& text, const QString& help) {
  setToolTip(help);
  if (text == text_)
    return;
  text_ = text;
  setAccessibleName(text);
  keepToItsPlace();
  setVisible(!text.isEmpty());
  update();
}

QSize PictureBadge::sizeHint() const {
  return {fontMetrics().horizontalAdvance(text_) + kDot + kGap + 2 * kPadding,
          fontMetrics().height() + 10};
}

void PictureBadge::keepToItsPlace() {
  resize(sizeHint());
  move((parentWidget()->width() - width()) / 2, parentWidget()->height() - height() - kMargin);
}

void PictureBadge::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor ground = palette().window().color();
  ground.setAlpha(235);
  const QColor warning = forms::warningColour(palette());
  painter.setBrush(ground);
  painter.setPen(QPen(warning, 1.4));
  const QRectF frame = QRectF(rect()).adjusted(0.7, 0.7, -0.7, -0.7);
  painter.drawRoundedRect(frame, frame.height() / 2, frame.height() / 2);
  painter.setPen(Qt::NoPen);
  painter.setBrush(warning);
  painter.drawEllipse(QRectF(kPadding, (height() - kDot) / 2.0, kDot, kDot));
  painter.setPen(palette().windowText().color());
  painter.drawText(rect().adjusted(kPadding + kDot + kGap, 0, 0, 0),
                   Qt::AlignLeft | Qt::AlignVCenter, text_);
}

void PictureBadge::changeEvent(QEvent* event) {
  if (event->type() == QEvent::FontChange)
    keepToItsPlace();
  QWidget::changeEvent(event);
}

bool PictureBadge::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Resize)
    keepToItsPlace();
  return QWidget::eventFilter(watched, event);
}

} // namespace voluta::window
