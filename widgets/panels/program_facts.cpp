#include "panels/program_facts.h"

#include "forms/duration_text.h"
#include "forms/fold.h"

#include <QEvent>
#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>
#include <cmath>

namespace voluta::panels {

namespace {
// Smaller differences of the two times are not worth showing.
constexpr double kSameShare = 0.005;

QLabel* line(QWidget* parent, const char* name) {
  auto* label = new QLabel(parent);
  label->setObjectName(QLatin1String(name));
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  return label;
}
} // namespace

ProgramFacts::ProgramFacts(QWidget* parent)
    : QWidget(parent), size_(line(this, "programSize")), time_(line(this, "programTime")) {
  auto* content = new QWidget(this);
  assumed_ = line(content, "assumptions");
  auto* inside = new QVBoxLayout(content);
  inside->setContentsMargins(12, 0, 0, 0);
  inside->addWidget(assumed_);
  fold_ = new forms::Fold(content, this);
  fold_->setOpen(false);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  column->addWidget(size_);
  column->addWidget(time_);
  column->addWidget(fold_);
  retranslate();
}

void ProgramFacts::setFigures(const std::optional<ProgramFigures>& figures) {
  figures_ = figures;
  retranslate();
}

void ProgramFacts::setAssumptions(const QStringList& sentences) {
  QString text;
  for (const QString& sentence : sentences)
    text += (text.isEmpty() ? QString() : QStringLiteral("\n")) + QStringLiteral("• ") + sentence;
  assumed_->setText(text);
  fold_->setVisible(!sentences.isEmpty());
}

void ProgramFacts::retranslate() {
  fold_->setTitle(tr("Assumptions about the controller"));
  size_->setVisible(figures_.has_value());
  time_->setVisible(figures_.has_value());
  if (!figures_)
    return;
  const ProgramFigures& f = *figures_;
  const QString bytes = QLocale().formattedDataSize(static_cast<qint64>(f.bytes), 1);
  size_->setText(f.files == 1 ? tr("%1 in one file").arg(bytes)
                              : tr("%1 in %2 files").arg(bytes).arg(f.files));
  const double share = f.plannedS > 0.0 ? f.controllerS / f.plannedS - 1.0 : 0.0;
  const QString takes = forms::durationText(f.controllerS), plan = forms::durationText(f.plannedS);
  if (std::abs(share) < kSameShare) {
    time_->setText(tr("Time on the controller: %1, as planned").arg(takes));
    return;
  }
  const QString percent = QLocale().toString(100.0 * std::abs(share), 'f', 1);
  time_->setText(share > 0.0
                     ? tr("Time on the controller: %1, %3 % more than the planned time of %2")
                           .arg(takes, plan, percent)
                     : tr("Time on the controller: %1, %3 % less than the planned time of %2")
                           .arg(takes, plan, percent));
}

void ProgramFacts::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    retranslate();
  QWidget::changeEvent(event);
}

} // namespace voluta::panels
