#include "window/spacing_view.h"

#include <QEvent>
#include <QHelpEvent>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QToolTip>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

namespace voluta::window {

namespace {
constexpr int kChartHeight = 104, kSide = 6;

QColor colourOf(const scene::Colour& c) {
  return QColor::fromRgbF(static_cast<float>(c[0]), static_cast<float>(c[1]),
                          static_cast<float>(c[2]));
}

// Never rounds a share below 100 % up to 100 %, or a share above 0 % down to 0 %.
QString percent(const QLocale& locale, double share) {
  const double value = 100.0 * share;
  if (value > 99.99 && share < 1.0)
    return QStringLiteral("> ") + locale.toString(99.99, 'f', 2);
  if (value > 0.0 && value < 0.01)
    return QStringLiteral("< ") + locale.toString(0.01, 'f', 2);
  const int digits = (value > 99.0 && value < 100.0) || (value > 0.0 && value < 1.0) ? 2
                     : value < 100.0 && value > 0.0                                  ? 1
                                                                                     : 0;
  return locale.toString(value, 'f', digits);
}
} // namespace

// Bars over millimetres, with the limits and the nominal height as labelled lines.
class SpacingChart : public QWidget {
public:
  using QWidget::QWidget;
  void setSpacing(const LayerSpacing& spacing) {
    spacing_ = spacing;
    update();
  }
  QSize sizeHint() const override { return {260, kChartHeight}; }
  QSize minimumSizeHint() const override { return {160, kChartHeight}; }

protected:
  void paintEvent(QPaintEvent*) override {
    if (spacing_.shares.empty())
      return;
    QPainter painter(this);
    const QRectF area = plot();
    const double highest = *std::max_element(spacing_.shares.begin(), spacing_.shares.end());
    const double wide = area.width() / static_cast<double>(spacing_.shares.size());
    const scene::HeightLimits& h = spacing_.heights;
    QColor rim = palette().windowText().color();
    rim.setAlpha(140);
    for (std::size_t i = 0; i < spacing_.shares.size(); ++i) {
      if (spacing_.shares[i] <= 0.0)
        continue;
      // Keep even the smallest share visible.
      const double tall = std::max(1.5, area.height() * spacing_.shares[i] / highest);
      const double t = h.shareOf(heightAt(static_cast<double>(i) + 0.5));
      painter.setBrush(colourOf(t < 0.0   ? scene::tooThinColour()
                                : t > 1.0 ? scene::tooThickColour()
                                          : scene::divergingColour(t)));
      painter.setPen(QPen(rim, 0.5));
      painter.drawRect(QRectF(area.left() + static_cast<double>(i) * wide, area.bottom() - tall,
                              wide - 0.5, tall));
    }
    painter.setPen(palette().mid().color());
    painter.drawLine(area.bottomLeft(), area.bottomRight());
    const QLocale locale;
    for (const auto& [mm, limit] :
         {std::pair(h.minMm, true), std::pair(h.nominalMm, false), std::pair(h.maxMm, true)}) {
      const double x = xOf(mm);
      painter.setPen(QPen(palette().windowText().color(), 1.0, limit ? Qt::DashLine : Qt::DotLine));
      painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom() + 3));
      const QString text = locale.toString(mm, 'f', 2);
      const double half = 0.5 * fontMetrics().horizontalAdvance(text) + 1;
      const double left = std::clamp(x - half, 0.0, width() - 2 * half);
      painter.drawText(QRectF(left, area.bottom() + 3, 2 * half, fontMetrics().height()),
                       Qt::AlignCenter, text);
    }
  }

  bool event(QEvent* event) override {
    if (event->type() != QEvent::ToolTip || spacing_.shares.empty())
      return QWidget::event(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const double place = (help->pos().x() - plot().left()) / plot().width() *
                         static_cast<double>(spacing_.shares.size());
    const auto bin = static_cast<std::size_t>(
        std::clamp(place, 0.0, static_cast<double>(spacing_.shares.size()) - 1.0));
    const QLocale locale;
    QToolTip::showText(help->globalPos(),
                       SpacingView::tr("%1–%2 mm: %3 % of the area")
                           .arg(locale.toString(heightAt(static_cast<double>(bin)), 'f', 2),
                                locale.toString(heightAt(static_cast<double>(bin) + 1.0), 'f', 2),
                                percent(locale, spacing_.shares[bin])),
                       this);
    return true;
  }

private:
  QRectF plot() const {
    return {double(kSide), 4.0, width() - 2.0 * kSide, height() - fontMetrics().height() - 10.0};
  }
  double heightAt(double bin) const {
    return spacing_.lowMm +
           (spacing_.highMm - spacing_.lowMm) * bin / static_cast<double>(spacing_.shares.size());
  }
  double xOf(double mm) const {
    return plot().left() +
           plot().width() * (mm - spacing_.lowMm) / (spacing_.highMm - spacing_.lowMm);
  }

  LayerSpacing spacing_;
};

SpacingView::SpacingView(QWidget* parent)
    : QWidget(parent), title_(new QLabel(this)), words_(new QLabel(this)),
      chart_(new SpacingChart(this)) {
  setObjectName("layerSpacing");
  chart_->setObjectName("spacingChart");
  words_->setObjectName("spacingWords");
  for (QLabel* label : {title_, words_})
    label->setWordWrap(true);
  words_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(8, 4, 8, 6);
  column->setSpacing(3);
  for (QWidget* widget : {static_cast<QWidget*>(title_), static_cast<QWidget*>(chart_),
                          static_cast<QWidget*>(words_)})
    column->addWidget(widget);
  retranslate();
  hide();
}

void SpacingView::setSpacing(const LayerSpacing& spacing) {
  spacing_ = spacing;
  chart_->setSpacing(spacing);
  setVisible(!spacing.shares.empty());
  retranslate();
}

QString SpacingView::words() const {
  return words_->text();
}

void SpacingView::retranslate() {
  title_->setText(tr("Layer spacing, share of area by thickness [mm]"));
  chart_->setAccessibleName(title_->text());
  const QLocale locale;
  const auto mm = [&](double value) { return locale.toString(value, 'f', 2); };
  QString text = tr("Mean %1 mm. Within %2–%3 mm: %4 %.")
                     .arg(mm(spacing_.meanMm), mm(spacing_.heights.minMm),
                          mm(spacing_.heights.maxMm), percent(locale, spacing_.within));
  if (spacing_.thinner > 0.0)
    text += ' ' + tr("Too thin: %1 %.").arg(percent(locale, spacing_.thinner));
  if (spacing_.thicker > 0.0)
    text += ' ' + tr("Too thick: %1 %.").arg(percent(locale, spacing_.thicker));
  words_->setText(text);
}

void SpacingView::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::LocaleChange)
    retranslate();
  QWidget::changeEvent(event);
}

} // namespace voluta::window
