#include "window/run_dialog.h"

#include "forms/duration_text.h"
#include "language/words.h"

#include <QDialogButtonBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>

namespace voluta::window {

namespace {
constexpr int kWidth = 560, kRows = 8;
constexpr std::size_t kListedOfKind = 50;

QString percent(double share) {
  return QLocale().toString(std::round(1000.0 * share) / 10.0 + 0.0, 'f', 1); // no "-0.0"
}
QString mm(double length) {
  return QLocale().toString(length, 'f', 2);
}

forms::Icon signOf(record::RunVerdict verdict) {
  switch (verdict) {
  case record::RunVerdict::Within:
    return forms::Icon::Good;
  case record::RunVerdict::Beyond:
    return forms::Icon::Warning;
  case record::RunVerdict::Incomplete:
  case record::RunVerdict::OtherJob:
    break;
  }
  return forms::Icon::Blocked;
}
} // namespace

QString placeText(const record::ErrorPlace& place) {
  const QString over = QLocale().toString(place.lengthMm, 'f', 1);
  switch (place.kind) {
  case record::ErrorKind::Path:
    return RunDialog::tr("Path %1 mm over %2 mm").arg(mm(place.worst), over);
  case record::ErrorKind::Speed:
    return RunDialog::tr("Speed %1 % over %2 mm").arg(percent(place.worst), over);
  case record::ErrorKind::Flow:
    return RunDialog::tr("Flow %1 % over %2 mm").arg(percent(place.worst), over);
  case record::ErrorKind::Missing:
    return RunDialog::tr("%1 mm of beads are missing").arg(mm(place.worst));
  }
  return {};
}

RunDialog::RunDialog(const QString& record, std::shared_ptr<const pipeline::PlanResult> plan,
                     QWidget* parent)
    : QDialog(parent), sign_(new QLabel(this)), figures_(new QLabel(this)),
      progress_(new QProgressBar(this)), placesTitle_(new QLabel(tr("Worst places"), this)),
      places_(new QListWidget(this)),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Cancel, this)) {
  setObjectName("runDialog");
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(tr("Recorded run %1").arg(QFileInfo(record).fileName()));
  setMinimumWidth(kWidth);
  figures_->setObjectName("runFigures");
  figures_->setWordWrap(true);
  figures_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  figures_->setText(tr("Comparing the record with the current plan…"));
  sign_->setObjectName("runSign");
  sign_->setAlignment(Qt::AlignTop);
  progress_->setRange(0, 100);
  progress_->setTextVisible(false);
  places_->setObjectName("runPlaces");
  places_->setWordWrap(true);
  places_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  places_->setMinimumHeight(kRows * (fontMetrics().height() + 6));
  placesTitle_->setBuddy(places_);
  placesTitle_->hide();
  places_->hide();

  auto* head = new QHBoxLayout;
  head->addWidget(sign_);
  head->addWidget(figures_, 1);
  auto* column = new QVBoxLayout(this);
  column->addLayout(head);
  column->addWidget(progress_);
  column->addWidget(placesTitle_);
  column->addWidget(places_, 1);
  column->addWidget(buttons_);

  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  connect(places_, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
    if (item)
      emit placeChosen(static_cast<std::size_t>(item->data(Qt::UserRole).toULongLong()));
  });
  connect(&comparing_, &document::RunComparing::progressed, this,
          [this](double fraction) { progress_->setValue(static_cast<int>(100.0 * fraction)); });
  connect(&comparing_, &document::RunComparing::compared, this, &RunDialog::show);
  connect(&comparing_, &document::RunComparing::failed, this,
          [this](const QString& message) { conclude(message, forms::Icon::Warning); });
  comparing_.compare(record, std::move(plan));
}

void RunDialog::conclude(const QString& text, forms::Icon sign) {
  progress_->hide();
  figures_->setText(text);
  const int size = fontMetrics().height() + 4;
  sign_->setPixmap(forms::icon(sign).pixmap(size, size));
  buttons_->setStandardButtons(QDialogButtonBox::Close);
}

void RunDialog::show(const pipeline::ComparedRun& run) {
  const record::RunComparison& c = run.comparison;
  const QString flow = c.flowIsRecorded ? tr("Flow, recorded: mean %1 %, from %2 to %3 %")
                                        : tr("Flow at this speed: mean %1 %, from %2 to %3 %");
  QStringList lines{
      tr("Path: mean %1 mm, greatest %2 mm").arg(mm(c.pathMeanMm), mm(c.pathMaxMm)),
      tr("Speed: mean %1 %, from %2 to %3 %")
          .arg(percent(c.speedMean), percent(c.speedSlowest), percent(c.speedFastest)),
      flow.arg(percent(c.flowMean), percent(c.flowLowest), percent(c.flowHighest)),
      tr("Beads recorded: %1 of %2 mm").arg(mm(c.printedMm), mm(c.beadsMm))};
  lines.prepend(language::words(record::verdictSentence(c)));
  lines.front().front() = lines.front().front().toUpper();
  conclude(lines.join(QLatin1Char('\n')), signOf(c.verdict()));
  list(c.places);
  emit compared(c.places);
  adjustSize();
}

void RunDialog::list(const std::vector<record::ErrorPlace>& places) {
  std::size_t ofKind = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const record::ErrorPlace& place = places[i];
    ofKind = i > 0 && places[i - 1].kind == place.kind ? ofKind + 1 : 0;
    if (ofKind >= kListedOfKind)
      continue;
    auto* item = new QListWidgetItem(
        QStringLiteral("%1   %2").arg(forms::clockText(place.planS, place.planS), placeText(place)),
        places_);
    item->setData(Qt::UserRole, QVariant::fromValue<qulonglong>(place.point));
  }
  placesTitle_->setVisible(!places.empty());
  places_->setVisible(!places.empty());
}

} // namespace voluta::window
