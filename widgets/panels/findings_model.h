// Findings in the order in which they are to be read: blocking first, then by stage.
#pragma once

#include "panels/listed_findings.h"

#include <QAbstractListModel>
#include <QStringList>
#include <vector>

namespace voluta::panels {

class FindingsModel : public QAbstractListModel {
  Q_OBJECT

public:
  // Roles beside Qt::DisplayRole (the reason).
  enum Role { DetailRole = Qt::UserRole, BlockingRole, OutOfDateRole, FormatsRole };

  explicit FindingsModel(QObject* parent = nullptr);

  // `before`: found before the choices were what they are now; they come last.
  void setFindings(const plan::Findings& findings, const plan::Findings& before = {});
  void setBlockedOnly(bool only);

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  // Precondition: 0 <= row < rowCount().
  const plan::Finding& finding(int row) const;
  // What is the matter; with the line of the program where it is of one alone.
  QString reason(int row) const;
  // Of the programs that a finding is about.
  QStringList formats(int row) const;
  // Stage, count, place and time in one line.
  static QString detail(const plan::Finding& finding);

  bool isOutOfDate(int row) const { return static_cast<std::size_t>(row) >= current_; }
  // Without those from before.
  std::size_t blocking() const { return blocking_; }
  std::size_t total() const { return current_; }
  // Texts made anew, after a change of language.
  void retranslate();

private:
  std::vector<ListedFinding> rows_; // sorted, the blocking ones first; then those from before
  std::size_t current_ = 0, blocking_ = 0;
  bool blockedOnly_ = false;
};

} // namespace voluta::panels
