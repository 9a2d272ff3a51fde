// Measures of a program from the replay, with their limits.
#pragma once

#include "project/report.h"

#include <QTableWidget>
#include <optional>
#include <vector>

namespace voluta::panels {

struct VerdictMeasure {
  QString label, value, limit; // limit empty: for information only
  bool passed = false;
  bool blocks = true; // whether the replay refuses a program outside the limit
};

// What the report of a replay does not contain.
struct VerdictFacts {
  double bridgeMm = 0.0;      // length of an unsupported run that the material bridges; 0: unknown
  std::size_t deviations = 0; // places where the program differs from the plan; none allowed
};

// Returns the measures of a verdict in the user's language.
std::vector<VerdictMeasure> verdictMeasures(const project::ReplayReport& report,
                                            const VerdictFacts& facts = {});

// Measure, value, limit and a tick or a stop sign.
class VerdictTable : public QTableWidget {
  Q_OBJECT

public:
  explicit VerdictTable(QWidget* parent = nullptr);

  // nullopt: no program was replayed. `outOfDate`: of settings that have changed since; the report
  // is shown as outdated.
  void setReport(std::optional<project::ReplayReport> report, bool outOfDate = false,
                 const VerdictFacts& facts = {});

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslate();

  std::optional<project::ReplayReport> report_;
  bool outOfDate_ = false;
  VerdictFacts facts_;
};

} // namespace voluta::panels
