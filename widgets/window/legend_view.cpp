#include "window/legend_view.h"

#include "language/words.h"

#include <QEvent>
#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>
#include <algorithm>

namespace voluta::window {

namespace {
constexpr int kPadding = 10, kSwatch = 16, kGap = 8, kGradientSteps = 16;
constexpr int kColumnGap = 14; // [px] before a column of figures

QColor colourOf(const scene::Colour& c) {
  return QColor::fromRgbF(static_cast<float>(c[0]), static_cast<float>(c[1]),
                          static_cast<float>(c[2]));
}

QFontMetrics boldMetrics(const QWidget& widget) {
  QFont bold = widget.font();
  bold.setBold(true);
  return QFontMetrics(bold);
}
} // namespace

LegendView::LegendView(QWidget* parent) : QWidget(parent) {
  setObjectName("legend");
  setAttribute(Qt::WA_TransparentForMouseEvents);
  hide();
}

void LegendView::setLegend(const scene::Legend& legend, const LegendFigures& figures) {
  legend_ = legend;
  figures_ = figures;
  setAttribute(Qt::WA_TransparentForMouseEvents, figures_.rows.empty());
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

int LegendView::nameWidth() const {
  int width = legend_.entries.empty() ? 0 : fontMetrics().horizontalAdvance(title());
  for (const auto* list : {&legend_.entries, &legend_.marks})
    for (const scene::LegendEntry& entry : *list)
      width = std::max(width, kSwatch + kGap + fontMetrics().horizontalAdvance(labelOf(entry)));
  for (const auto& [name, cells] : figures_.totals)
    width = std::max(width, kSwatch + kGap + boldMetrics(*this).horizontalAdvance(name));
  return width;
}

std::vector<int> LegendView::columnWidths() const {
  std::vector<int> widths;
  const QFontMetrics bold = boldMetrics(*this);
  const auto fit = [&](const QStringList& cells) {
    widths.resize(std::max(widths.size(), static_cast<std::size_t>(cells.size())), 0);
    for (qsizetype i = 0; i < cells.size(); ++i)
      widths[static_cast<std::size_t>(i)] =
          std::max(widths[static_cast<std::size_t>(i)], bold.horizontalAdvance(cells[i]));
  };
  fit(figures_.heads);
  for (const scene::LegendEntry& entry : legend_.entries)
    if (const auto row = figures_.rows.find(static_cast<int>(entry.value));
        row != figures_.rows.end())
      fit(row->second);
  for (const auto& [name, cells] : figures_.totals)
    fit(cells);
  return widths;
}

int LegendView::topOfEntries() const {
  return kPadding + (legend_.entries.empty() ? 0 : rowHeight() + kGap / 2);
}

QRect LegendView::rowOf(int value) const {
  for (std::size_t i = 0; i < legend_.entries.size(); ++i)
    if (legend_.categorical && static_cast<int>(legend_.entries[i].value) == value)
      return {kPadding, topOfEntries() + static_cast<int>(i) * rowHeight(), width() - 2 * kPadding,
              rowHeight()};
  return {};
}

int LegendView::valueAt(int y) const {
  const int row = (y - topOfEntries()) / rowHeight();
  return figures_.rows.empty() || y < topOfEntries() ||
                 row >= static_cast<int>(legend_.entries.size())
             ? -1
             : static_cast<int>(legend_.entries[static_cast<std::size_t>(row)].value);
}

void LegendView::mousePressEvent(QMouseEvent* event) {
  const int value = valueAt(qRound(event->position().y()));
  if (value < 0 || event->button() != Qt::LeftButton)
    event->ignore();
  else
    emit entryClicked(value);
}

bool LegendView::event(QEvent* event) {
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const int value = valueAt(help->pos().y());
    if (value >= 0)
      QToolTip::showText(help->globalPos(), (figures_.hidden >> value & 1U) != 0
                                                ? tr("Click to show these beads")
                                                : tr("Click to hide these beads"));
    return true;
  }
  return QWidget::event(event);
}

void LegendView::paintFigures(QPainter& painter, const QStringList& cells, int y) const {
  const std::vector<int> widths = columnWidths();
  int x = kPadding + nameWidth();
  for (qsizetype i = 0; i < cells.size(); ++i) {
    const int wide = widths[static_cast<std::size_t>(i)];
    painter.drawText(QRect(x + kColumnGap, y, wide, rowHeight()), Qt::AlignRight | Qt::AlignVCenter,
                     cells[i]);
    x += kColumnGap + wide;
  }
}

QSize LegendView::sizeHint() const {
  const bool titled = !legend_.entries.empty();
  int width = nameWidth();
  for (const int column : columnWidths())
    width += kColumnGap + column;
  int height =
      static_cast<int>(legend_.entries.size() + legend_.marks.size() + figures_.totals.size()) *
      rowHeight();
  height += figures_.totals.empty() ? 0 : kGap;
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
    paintFigures(painter, figures_.heads, top);
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
    const auto figures = figures_.rows.find(static_cast<int>(entry.value));
    const bool hidden =
        figures != figures_.rows.end() && (figures_.hidden >> figures->first & 1U) != 0;
    if (swatch) {
      painter.setPen(palette().mid().color());
      painter.setBrush(hidden ? QBrush(Qt::NoBrush) : QBrush(colourOf(entry.colour)));
      painter.drawRoundedRect(QRectF(kPadding + 1.5, y + (row - 13) / 2.0, 13, 13), 2, 2);
    }
    painter.setPen(hidden ? palette().color(QPalette::Disabled, QPalette::WindowText)
                          : palette().windowText().color());
    if (figures != figures_.rows.end())
      paintFigures(painter, figures->second, y);
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
  for (std::size_t i = 0; i < figures_.totals.size(); ++i) {
    const auto& [name, cells] = figures_.totals[i];
    if (i + 1 == figures_.totals.size()) {
      painter.setPen(palette().mid().color());
      painter.drawLine(kPadding, y, width() - kPadding, y);
      QFont bold = font();
      bold.setBold(true);
      painter.setFont(bold);
    }
    painter.setPen(palette().windowText().color());
    painter.drawText(QRect(kPadding + kSwatch + kGap, y, width(), row),
                     Qt::AlignLeft | Qt::AlignVCenter, name);
    paintFigures(painter, cells, y);
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
