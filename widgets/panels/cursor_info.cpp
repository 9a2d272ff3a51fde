#include "panels/cursor_info.h"

#include <QEvent>
#include <QFontDatabase>
#include <QGridLayout>
#include <QLabel>
#include <QLocale>

namespace voluta::panels {

namespace {
constexpr std::size_t kLine = 0;

QString fixed(double value) {
  const double shown = std::abs(value) < 0.05 ? 0.0 : value; // No "-0.0"
  return QLocale().toString(shown, 'f', 1);
}
} // namespace

CursorInfo::CursorInfo(QWidget* parent) : QWidget(parent) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(6, 4, 6, 4);
  grid->setHorizontalSpacing(10);
  grid->setVerticalSpacing(2);
  grid->setColumnStretch(1, 1);
  for (std::size_t row = 0; row < kRows; ++row) {
    names_[row] = new QLabel(this);
    values_[row] = new QLabel(this);
    values_[row]->setWordWrap(true);
    values_[row]->setTextFormat(Qt::PlainText);
    values_[row]->setTextInteractionFlags(Qt::TextSelectableByMouse);
    values_[row]->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    values_[row]->setMinimumWidth(1);
    grid->addWidget(names_[row], static_cast<int>(row), 0, Qt::AlignTop);
    grid->addWidget(values_[row], static_cast<int>(row), 1);
  }
  values_[kLine]->setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
  values_[kLine]->setWordWrap(false); // A line that wraps would move the rows below while playing
  retranslate();
}

void CursorInfo::setFacts(const std::optional<CursorFacts>& facts) {
  facts_ = facts;
  retranslate();
}

QString CursorInfo::shown(int row) const {
  return values_[static_cast<std::size_t>(row)]->text();
}

void CursorInfo::retranslate() {
  const CursorFacts facts = facts_.value_or(CursorFacts{});
  QStringList joints;
  for (const CursorFacts::Joint& joint : facts.joints)
    joints
        << (joint.slides ? QStringLiteral("%1 mm") : QStringLiteral("%1°")).arg(fixed(joint.value));
  const QString share =
      QStringLiteral("%1 %").arg(QLocale().toString(100.0 * facts.printedShare, 'f', 1));
  const QString none = QStringLiteral("–");
  const std::array<std::pair<QString, QString>, kRows> rows{{
      {facts.lineNumber > 0
           ? tr("Line %1").arg(QLocale().toString(static_cast<qulonglong>(facts.lineNumber)))
           : tr("Line"),
       facts.line.isEmpty() ? none : facts.line},
      {tr("Nozzle"),
       QStringLiteral("X %1  Y %2  Z %3 mm")
           .arg(fixed(facts.tipMm.x()), fixed(facts.tipMm.y()), fixed(facts.tipMm.z()))},
      {tr("Rotation"), QStringLiteral("A %1°  B %2°  C %3°")
                           .arg(fixed(facts.anglesDeg.x()), fixed(facts.anglesDeg.y()),
                                fixed(facts.anglesDeg.z()))},
      {tr("Tilt"), QStringLiteral("%1°").arg(fixed(facts.tiltDeg))},
      {tr("Speed"), QStringLiteral("%1 mm/s").arg(fixed(facts.speedMmPerS))},
      {tr("Joints"), joints.join(QStringLiteral("  "))},
      {tr("Printed"),
       facts.printedG > 0.0 ? QStringLiteral("%1, %2 g").arg(share, fixed(facts.printedG)) : share},
  }};
  for (std::size_t row = 0; row < kRows; ++row) {
    names_[row]->setText(rows[row].first);
    values_[row]->setText(facts_ ? rows[row].second : none);
  }
  values_[kLine]->setToolTip(facts.line);
  names_[2]->setToolTip(tr("About X, Y and Z of the platform, from the upright nozzle"));
  names_[1]->setToolTip(tr("The nozzle's tip, from the middle of the platform"));
}

void CursorInfo::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    retranslate();
  QWidget::changeEvent(event);
}

} // namespace voluta::panels
