// Findings sorted for reading: those that block first, then those by which the printed part
// differs, then by stage.
#pragma once

#include "panels/listed_findings.h"

#include <QAbstractListModel>
#include <QStringList>
#include <vector>

namespace voluta::panels {

class FindingsModel : public QAbstractListModel {
  Q_OBJECT

public:
  // Roles in addition to Qt::DisplayRole (the reason).
  enum Role { DetailRole = Qt::UserRole, WeightRole, OutOfDateRole, FormatsRole };
  // What a finding means for the programs; WeightRole.
  enum Weight { Blocks, Differs, Informs };

  explicit FindingsModel(QObject* parent = nullptr);

  // `before`: findings from before the last change of the choices; they come last. `hasPrograms`:
  // the plan has programs, so that findings that concern the printed part alone block none of them.
  void setFindings(const plan::Findings& findings, const plan::Findings& before = {},
                   bool hasPrograms = false);
  void setBlockedOnly(bool only);
  // Names of the parts that findings concern; empty: the job has one part.
  void setParts(const QStringList& names) { parts_ = names; }

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  // The first one of a row. Precondition: 0 <= row < rowCount().
  const plan::Finding& finding(int row) const;
  // All findings of a row: of one fact, at several places.
  const plan::Findings& places(int row) const;
  // Reason of the finding as a sentence; with the program's line if it concerns a single program.
  QString reason(int row) const;
  // Formats of the programs that a finding concerns.
  QStringList formats(int row) const;
  // The same for all places of a row, and whether they are from before the change.
  QString rowDetail(int row) const;
  // What would help, as a sentence; empty: nothing is known.
  static QString remedyText(const plan::Finding& finding);
  // Part, stage, count, place and time in one line.
  QString detail(const plan::Finding& finding) const;

  bool isOutOfDate(int row) const { return static_cast<std::size_t>(row) >= current_; }
  Weight weight(int row) const { return weightOf(finding(row)); }
  // Without those from before the change.
  std::size_t blocking() const { return blocking_; }
  std::size_t differing() const { return differing_; }
  std::size_t total() const { return current_; }
  // Updates the texts after a change of language.
  void retranslate();

private:
  Weight weightOf(const plan::Finding& finding) const;

  // sorted by weight; then those from before the change
  std::vector<ListedFinding> rows_;
  std::size_t current_ = 0, blocking_ = 0, differing_ = 0;
  bool blockedOnly_ = false, hasPrograms_ = false;
  QStringList parts_;
};

} // namespace voluta::panels
