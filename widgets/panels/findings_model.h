// Findings in the order in which they are to be read: blocking first, then by stage.
#pragma once

#include "plan/finding.h"

#include <QAbstractListModel>
#include <vector>

namespace voluta::panels {

class FindingsModel : public QAbstractListModel {
  Q_OBJECT

public:
  // Roles beside Qt::DisplayRole (the reason).
  enum Role { DetailRole = Qt::UserRole, BlockingRole };

  explicit FindingsModel(QObject* parent = nullptr);

  void setFindings(plan::Findings findings);
  void setBlockedOnly(bool only);

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  // Precondition: 0 <= row < rowCount().
  const plan::Finding& finding(int row) const;
  // Stage, count, place and time in one line.
  static QString detail(const plan::Finding& finding);

  std::size_t blocking() const { return blocking_; }
  std::size_t total() const { return findings_.size(); }
  // Texts made anew, after a change of language.
  void retranslate();

private:
  plan::Findings findings_; // sorted, so that the blocking ones come first
  std::size_t blocking_ = 0;
  bool blockedOnly_ = false;
};

} // namespace voluta::panels
