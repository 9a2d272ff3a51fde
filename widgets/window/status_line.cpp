#include "window/status_line.h"

#include "language/words.h"
#include "window/progress_line.h"

#include "forms/duration_text.h"

#include <QFile>
#include <QLabel>
#include <QTimer>
#include <cmath>
#include <unistd.h>

namespace voluta::window {

namespace {
constexpr int kMemoryMs = 2000;
constexpr double kMegabyte = 1024.0 * 1024.0;

double residentMb() {
  QFile file("/proc/self/statm");
  if (!file.open(QIODevice::ReadOnly))
    return 0.0;
  const QList<QByteArray> fields = file.readAll().split(' ');
  return fields.size() > 1
             ? fields[1].toDouble() * static_cast<double>(sysconf(_SC_PAGESIZE)) / kMegabyte
             : 0.0;
}
} // namespace

StatusLine::StatusLine(QWidget* parent)
    : QStatusBar(parent), stage_(new QLabel(this)), left_(new QLabel(this)),
      part_(new QLabel(this)), cell_(new QLabel(this)), memory_(new QLabel(this)),
      bar_(new ProgressLine(this)) {
  setObjectName("statusLine");
  stage_->setObjectName("statusStage");
  // Elide long sentences and show them in full in the tool tip, so that they do not widen the
  // window.
  stage_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  bar_->setObjectName("statusProgress");
  cell_->setObjectName("statusCell");
  bar_->hide();
  addWidget(stage_, 1);
  addWidget(bar_);
  addWidget(left_);
  for (QLabel* label : {part_, cell_, memory_})
    addPermanentWidget(label);
  auto* timer = new QTimer(this);
  connect(timer, &QTimer::timeout, this, &StatusLine::showMemory);
  timer->start(kMemoryMs);
  showMemory();
}

void StatusLine::showProgress(const jobs::Progress& progress) {
  setStage(language::words(progress.stage));
  bar_->show();
  bar_->setFraction(progress.fraction);
  left_->setText(progress.secondsLeft
                     ? tr("about %1 left").arg(forms::durationText(*progress.secondsLeft))
                     : QString());
}

void StatusLine::showIdle(const QString& text) {
  setStage(text);
  bar_->hide();
  left_->clear();
}

void StatusLine::setStage(const QString& text) {
  stage_->setText(text);
  stage_->setToolTip(text);
}

void StatusLine::setPart(const QString& sizeText) {
  part_->setText(sizeText);
}

void StatusLine::setCell(const QString& cell) {
  cell_->setText(cell);
}

void StatusLine::showMemory() {
  memory_->setText(tr("%1 MB").arg(std::lround(residentMb())));
}

} // namespace voluta::window
