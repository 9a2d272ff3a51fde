// The status bar: the current step, progress and remaining time; size of the part, cell, memory.
#pragma once

#include "jobs/job_runner.h"

#include <QStatusBar>

class QLabel;

namespace voluta::window {

class ProgressLine;

class StatusLine : public QStatusBar {
  Q_OBJECT

public:
  explicit StatusLine(QWidget* parent = nullptr);

  void showProgress(const jobs::Progress& progress);
  // Nothing is running; `text` reports how the last run ended or what to do next.
  void showIdle(const QString& text);
  void setPart(const QString& sizeText);
  void setCell(const QString& cell);

private:
  void setStage(const QString& text);
  void showMemory();

  QLabel *stage_, *left_, *part_, *cell_, *memory_;
  ProgressLine* bar_;
};

} // namespace voluta::window
