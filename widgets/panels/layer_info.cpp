#include "panels/layer_info.h"

#include "forms/duration_text.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>

namespace voluta::panels {

LayerInfo::LayerInfo(QWidget* parent) : QWidget(parent) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(6, 4, 6, 4);
  grid->setHorizontalSpacing(10);
  grid->setVerticalSpacing(2);
  grid->setColumnStretch(1, 1);
  for (std::size_t row = 0; row < kRows; ++row) {
    names_[row] = new QLabel(this);
    values_[row] = new QLabel(this);
    values_[row]->setWordWrap(true);
    values_[row]->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    values_[row]->setTextInteractionFlags(Qt::TextSelectableByMouse);
    grid->addWidget(names_[row], static_cast<int>(row), 0);
    grid->addWidget(values_[row], static_cast<int>(row), 1);
  }
  retranslate();
}

void LayerInfo::setMeasures(const std::optional<LayerMeasures>& measures) {
  measures_ = measures;
  retranslate();
}

void LayerInfo::retranslate() {
  const QLocale locale;
  const auto whole = [&](std::size_t n) { return locale.toString(static_cast<qulonglong>(n)); };
  const auto number = [&](double value, int digits) { return locale.toString(value, 'f', digits); };
  const LayerMeasures m = measures_.value_or(LayerMeasures{});
  const std::array<std::pair<QString, QString>, kRows> rows{{
      {tr("Layer"), tr("%1 of %2").arg(m.index + 1).arg(m.layers)},
      {tr("Patches"), whole(m.patches)},
      {tr("Area"), QStringLiteral("%1 mm²").arg(number(m.areaMm2, 1))},
      {tr("Thickness"), QStringLiteral("%1 / %2 / %3 mm")
                            .arg(number(m.thicknessMinMm, 2), number(m.thicknessMeanMm, 2),
                                 number(m.thicknessMaxMm, 2))},
      {tr("Length"), QStringLiteral("%1 m").arg(number(m.lengthMm / 1000.0, 2))},
      {tr("Time"), m.timeS > 0.0 ? forms::durationText(m.timeS) : QStringLiteral("–")},
      {tr("Waypoints"), whole(m.waypoints)},
  }};
  for (std::size_t row = 0; row < kRows; ++row) {
    names_[row]->setText(rows[row].first);
    values_[row]->setText(measures_ ? rows[row].second : QStringLiteral("–"));
  }
  values_[3]->setToolTip(tr("Minimum, mean and maximum"));
  names_[3]->setToolTip(tr("Minimum, mean and maximum"));
}

void LayerInfo::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    retranslate();
  QWidget::changeEvent(event);
}

} // namespace voluta::panels
