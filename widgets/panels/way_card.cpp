#include "panels/way_card.h"

#include "forms/colours.h"

#include <QEvent>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>

namespace voluta::panels {

namespace {
constexpr int kMargin = 6;
constexpr double kRadius = 4.0, kTick = 18.0;
} // namespace

WayCard::WayCard(QWidget* parent) : QAbstractButton(parent) {
  setCheckable(true);
  setFocusPolicy(Qt::StrongFocus);
  setAttribute(Qt::WA_Hover);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void WayCard::setOrientation(const ShownOrientation& orientation) {
  orientation_ = orientation;
  retranslate();
}

void WayCard::retranslate() {
  const QLocale locale;
  const auto whole = [&](double value) { return locale.toString(value, 'f', 0); };
  const auto count = [&](std::size_t n) { return locale.toString(static_cast<qulonglong>(n)); };
  lines_ = {tr("Contact %1 mm²").arg(whole(orientation_.contactMm2)),
            tr("Missed voxels %1").arg(count(orientation_.missed)),
            tr("About %1").arg(orientation_.time)};
  const QString figures =
      tr("contact %1 mm², overhang %2 mm²\n%3 mm high\n%4 of %5 voxels missed in one "
         "growth pass\nabout %6, estimated from size, walls and infill without supports")
          .arg(whole(orientation_.contactMm2), whole(orientation_.overhangMm2),
               locale.toString(orientation_.heightMm, 'f', 1), count(orientation_.missed),
               count(orientation_.voxels), orientation_.time);
  setToolTip(figures);
  setAccessibleName(lines_[0] + QStringLiteral(", ") + lines_[1] + QStringLiteral(", ") +
                    lines_[2]);
  setAccessibleDescription(figures);
  updateGeometry();
  update();
}

QSize WayCard::minimumSizeHint() const {
  int width = kPicture.width() / 2;
  for (const QString& line : lines_)
    width = std::max(width, fontMetrics().horizontalAdvance(line));
  return {width + 2 * kMargin, kPicture.height() +
                                   static_cast<int>(lines_.size()) * fontMetrics().lineSpacing() +
                                   2 * kMargin + 2};
}

QSize WayCard::sizeHint() const {
  return minimumSizeHint().expandedTo({kPicture.width() + 2 * kMargin, 0});
}

void WayCard::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  const QColor chosen = palette().color(QPalette::Highlight);
  const QColor ground = palette().color(QPalette::Base), text = palette().color(QPalette::Text);
  const QRectF frame = QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0);
  const bool over = isDown() || (isEnabled() && underMouse());
  painter.setBrush(isChecked() ? forms::mixed(ground, chosen, 0.12)
                   : over      ? forms::mixed(ground, text, 0.07)
                               : ground);
  painter.setPen(
      QPen(isChecked() || hasFocus() ? chosen : forms::mixed(ground, text, over ? 0.45 : 0.25),
           isChecked() ? 2.0 : 1.0));
  painter.drawRoundedRect(frame, kRadius, kRadius);
  if (hasFocus()) {
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(chosen, 1.0, Qt::DotLine));
    painter.drawRoundedRect(frame.adjusted(3, 3, -3, -3), kRadius - 1, kRadius - 1);
  }
  painter.setOpacity(isEnabled() ? 1.0 : 0.5);
  const QRect above(kMargin, kMargin, width() - 2 * kMargin, kPicture.height());
  if (!orientation_.picture.isNull()) {
    const QSize size =
        orientation_.picture.size().scaled(above.size().boundedTo(kPicture), Qt::KeepAspectRatio);
    QRect where(QPoint(), size);
    where.moveCenter(above.center());
    painter.drawImage(where, orientation_.picture);
  }
  const int line = fontMetrics().lineSpacing();
  for (std::size_t n = 0; n < lines_.size(); ++n) {
    painter.setPen(n == 0 ? text : forms::mutedColour(palette()));
    painter.drawText(
        QRect(kMargin, above.bottom() + 3 + static_cast<int>(n) * line, above.width(), line),
        Qt::AlignHCenter | Qt::AlignVCenter, lines_[n]);
  }
  if (isChecked())
    paintTick(painter);
}

// The selection is not shown by colour alone.
void WayCard::paintTick(QPainter& painter) const {
  const QRectF disc(width() - kTick - 5.0, 5.0, kTick, kTick);
  painter.setPen(Qt::NoPen);
  painter.setBrush(palette().color(QPalette::Highlight));
  painter.drawEllipse(disc);
  QPainterPath tick;
  tick.moveTo(disc.left() + 0.27 * kTick, disc.top() + 0.52 * kTick);
  tick.lineTo(disc.left() + 0.44 * kTick, disc.top() + 0.69 * kTick);
  tick.lineTo(disc.left() + 0.74 * kTick, disc.top() + 0.34 * kTick);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(palette().color(QPalette::HighlightedText), 2.0, Qt::SolidLine, Qt::RoundCap,
                      Qt::RoundJoin));
  painter.drawPath(tick);
}

void WayCard::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    retranslate();
  QAbstractButton::changeEvent(event);
}

} // namespace voluta::panels
