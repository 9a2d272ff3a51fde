#include "window/legend_view.h"

#include "language/words.h"

#include <QEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>

namespace voluta::window {

namespace {
constexpr int kPadding = 10, kSwatch = 16, kGap = 8, kGradientSteps = 16;

QColor colourOf(const scene::Colour& c) {
  return QColor::fromRgbF(static_cast<float>(c[0]), static_cast<float>(c[1]),
                          static_cast<float>(c[2]));
}
} // namespace

LegendView::LegendView(QWidget* parent) : QWidget(parent) {
  setObjectName("legend");
  setAttribute(Qt::WA_TransparentForMouseEvents);
  hide();
}

void LegendView::setLegend(const scene::Legend& legend) {
  legend_ = legend;
  showWanted();
  resize(sizeHint());
  update();
}

void LegendView::setWanted(bool wanted) {
  wanted_ = wanted;
  showWanted();
}

void LegendView::showWanted() {
  setVisible(wanted_ && (!legend_.entries.empty() || !legend_.marks.empty()));
}

QString LegendView::title() const {
  const QString name = language::words(legend_.title);
  return legend_.unit.empty() ? name
                              : QString("%1 [%2]").arg(name, QString::fromStdString(legend_.unit));
}

QString LegendView::labelOf(const scene::LegendEntry& entry) const {
  return language::words(entry.text());
}

int LegendView::rowHeight() const {
  return std::max(fontMetrics().height() + 2, kSwatch);
}

QSize LegendView::sizeHint() const {
  const bool titled = !legend_.entries.empty();
  int width = titled ? fontMetrics().horizontalAdvance(title()) : 0;
  for (const auto* list : {&legend_.entries, &legend_.marks})
    for (const scene::LegendEntry& entry : *list)
      width = std::max(width, kSwatch + kGap + fontMetrics().horizontalAdvance(labelOf(entry)));
  int height = static_cast<int>(legend_.entries.size() + legend_.marks.size()) * rowHeight();
  if (titled)
    height += rowHeight() + kGap / 2 + (legend_.marks.empty() ? 0 : kGap);
  return {width + 2 * kPadding, height + 2 * kPadding};
}

void LegendView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor ground = palette().window().color();
  ground.setAlpha(225);
  painter.setBrush(ground);
  painter.setPen(palette().mid().color());
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
  const int row = rowHeight();
  const int count = static_cast<int>(legend_.entries.size());
  int top = kPadding;
  if (count > 0) {
    painter.setPen(palette().windowText().color());
    painter.drawText(QRect(kPadding, top, width() - 2 * kPadding, row),
                     Qt::AlignLeft | Qt::AlignVCenter, title());
    top += row + kGap / 2;
  }
  // The maximum of a scale is at the top, as users expect.
  const auto entryAt = [&](int i) -> const scene::LegendEntry& {
    return legend_.entries[static_cast<std::size_t>(legend_.categorical ? i : count - 1 - i)];
  };
  if (!legend_.categorical && count > 1) {
    QLinearGradient scale(0, top + row / 2.0, 0, top + (count - 0.5) * row);
    for (int i = 0; i <= kGradientSteps; ++i) {
      const double at = static_cast<double>(i) / kGradientSteps;
      scale.setColorAt(at, colourOf(legend_.scaleColour(1.0 - at)));
    }
    painter.fillRect(QRectF(kPadding, top + row / 2.0, kSwatch, (count - 1.0) * row), scale);
  }
  const auto paintRow = [&](const scene::LegendEntry& entry, int y, bool swatch) {
    if (swatch) {
      painter.setPen(palette().mid().color());
      painter.setBrush(colourOf(entry.colour));
      painter.drawRoundedRect(QRectF(kPadding + 1.5, y + (row - 13) / 2.0, 13, 13), 2, 2);
    }
    painter.setPen(palette().windowText().color());
    painter.drawText(QRect(kPadding + kSwatch + kGap, y, width(), row),
                     Qt::AlignLeft | Qt::AlignVCenter, labelOf(entry));
  };
  for (int i = 0; i < count; ++i)
    paintRow(entryAt(i), top + i * row, legend_.categorical || count == 1);
  int y = count > 0 ? top + count * row + kGap : top;
  for (const scene::LegendEntry& mark : legend_.marks) {
    paintRow(mark, y, true);
    y += row;
  }
}

void LegendView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::FontChange) {
    resize(sizeHint());
    update();
  }
  QWidget::changeEvent(event);
}

} // namespace voluta::window
