// The list of program formats, each with its verdict.
#pragma once

#include "base/parameters.h"
#include "panels/verdict_table.h"
#include "project/report.h"

#include <QString>
#include <QStringList>
#include <QTreeWidget>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace voluta::panels {

// Blocked: the replay passes, but the plan has a blocking finding.
enum class VerdictState { NotYet, Passed, NotAsAsked, Unchecked, Blocked, Refused, OutOfDate };

struct ExportFile {
  QString name;                            // name in the folder
  std::shared_ptr<const std::string> text; // shared with the result, never copied
};

// One row of the dialect registry with its planned program.
struct ExportFormat {
  QString id, label;
  bool foreign = false;
  QString whyNot; // reason why this job cannot be written in it, a sentence; empty if it can
  VerdictState state = VerdictState::NotYet;
  QString whyRefused;                           // failed measures, or the plan's first blocker
  std::optional<project::ReplayReport> verdict; // after the replay
  VerdictFacts facts;                           // as well
  std::vector<ExportFile> files;                // after planning
  double plannedS = 0.0; // of the plan; the controller's duration is in the verdict
  std::vector<base::ParameterSpec> options; // options of its text
  QStringList assumptions;                  // sentences on its controller
};

class FormatList : public QTreeWidget {
  Q_OBJECT

public:
  explicit FormatList(QWidget* parent = nullptr);

  // Keeps the current row if its id still exists. Emits nothing.
  void setFormats(const std::vector<ExportFormat>& formats);
  void setChecked(const QStringList& ids);
  QStringList checkedIds() const;
  // Empty: no row is current.
  QString currentId() const;

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

signals:
  void checkedChanged(const QStringList& ids);
  void currentChangedTo(const QString& id);

protected:
  void changeEvent(QEvent* event) override;

private:
  void makeRows();
  void offerCheckBoxes();
  static QString verdictOf(const ExportFormat& format);
  void retranslate();

  std::vector<ExportFormat> formats_;
  bool chosen_ = false; // whether the current row was chosen by mouse or keys
};

} // namespace voluta::panels
