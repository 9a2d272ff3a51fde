// What the replay measured of a program, and the limits it has to keep to.
#pragma once

#include "project/report.h"

#include <QTableWidget>
#include <optional>
#include <vector>

namespace voluta::panels {

struct VerdictMeasure {
  QString label, value, limit; // limit empty: it is only told
  bool passed = false;
};

// The measures of a verdict in the user's language.
std::vector<VerdictMeasure> verdictMeasures(const project::ReplayReport& report);

// Measure, value, limit and a tick or a stop sign.
class VerdictTable : public QTableWidget {
  Q_OBJECT

public:
  explicit VerdictTable(QWidget* parent = nullptr);

  // nullopt: no program was replayed. `outOfDate`: of settings that have changed since; then it is
  // shown, but says nothing of what is there now.
  void setReport(std::optional<project::ReplayReport> report, bool outOfDate = false);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslate();

  std::optional<project::ReplayReport> report_;
  bool outOfDate_ = false;
};

} // namespace voluta::panels
