// The program formats to choose from, each with its verdict.
#pragma once

#include "base/parameters.h"
#include "project/report.h"

#include <QString>
#include <QStringList>
#include <QTreeWidget>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace voluta::panels {

enum class VerdictState { NotYet, Passed, Refused, OutOfDate };

struct ExportFile {
  QString name;                            // as it will be named in the folder
  std::shared_ptr<const std::string> text; // shared with the result, never copied
};

// One row of the dialect registry and what was planned for it.
struct ExportFormat {
  QString id, label;
  bool foreign = false;
  QString whyNot; // this job cannot be written in it, a sentence; empty: it can
  VerdictState state = VerdictState::NotYet;
  QString whyRefused;                           // names the measures that failed
  std::optional<project::ReplayReport> verdict; // once replayed
  std::vector<ExportFile> files;                // once written
  double plannedS = 0.0;                        // of the plan; the verdict has the controller's
  std::vector<base::ParameterSpec> options;     // what may be chosen about its text
  QStringList assumptions;                      // sentences on its controller
};

class FormatList : public QTreeWidget {
  Q_OBJECT

public:
  explicit FormatList(QWidget* parent = nullptr);

  // Emits nothing. Keeps the current row where its id is still there.
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
  bool chosen_ = false; // was the current row chosen by mouse or keys?
};

} // namespace voluta::panels
