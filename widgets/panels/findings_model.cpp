#include "panels/findings_model.h"

#include "language/words.h"
#include "plan/finding_kinds.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

namespace voluta::panels {

FindingsModel::FindingsModel(QObject* parent) : QAbstractListModel(parent) {}

void FindingsModel::setFindings(plan::Findings findings) {
  beginResetModel();
  findings_ = std::move(findings);
  std::stable_sort(findings_.begin(), findings_.end(),
                   [](const plan::Finding& a, const plan::Finding& b) {
                     if (a.blocking != b.blocking)
                       return a.blocking;
                     return plan::stageOf(a) < plan::stageOf(b);
                   });
  blocking_ = static_cast<std::size_t>(std::count_if(
      findings_.begin(), findings_.end(), [](const plan::Finding& f) { return f.blocking; }));
  endResetModel();
}

void FindingsModel::setBlockedOnly(bool only) {
  if (only == blockedOnly_)
    return;
  beginResetModel();
  blockedOnly_ = only;
  endResetModel();
}

int FindingsModel::rowCount(const QModelIndex& parent) const {
  if (parent.isValid())
    return 0;
  return static_cast<int>(blockedOnly_ ? blocking_ : findings_.size());
}

const plan::Finding& FindingsModel::finding(int row) const {
  return findings_.at(static_cast<std::size_t>(row));
}

QVariant FindingsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount())
    return {};
  const plan::Finding& f = finding(index.row());
  switch (role) {
  case Qt::DisplayRole:
    return language::words(plan::reasonOf(f));
  case Qt::ToolTipRole:
    return (QStringList{language::words(plan::reasonOf(f)), language::words(plan::remedyOf(f))})
        .join(QLatin1Char('\n'))
        .trimmed();
  case Qt::AccessibleTextRole:
    return (f.blocking ? tr("Blocked: %1") : tr("Worth knowing: %1"))
        .arg(language::words(plan::reasonOf(f)));
  case DetailRole:
    return detail(f);
  case BlockingRole:
    return f.blocking;
  default:
    return {};
  }
}

QString FindingsModel::detail(const plan::Finding& finding) {
  const QLocale locale;
  QStringList parts{language::words(plan::stageLabel(plan::stageOf(finding)))};
  if (finding.count > 1)
    parts << QStringLiteral("× ") + locale.toString(static_cast<qulonglong>(finding.count));
  if (finding.where) {
    const Eigen::Vector3d& at = *finding.where;
    parts << tr("at %1, %2, %3 mm")
                 .arg(locale.toString(at.x(), 'f', 1), locale.toString(at.y(), 'f', 1),
                      locale.toString(at.z(), 'f', 1));
  }
  if (finding.whenS) {
    const auto whole = static_cast<long long>(std::floor(*finding.whenS));
    parts << QStringLiteral("%1:%2").arg(whole / 60).arg(whole % 60, 2, 10, QLatin1Char('0'));
  }
  return parts.join(QStringLiteral(" · "));
}

void FindingsModel::retranslate() {
  if (rowCount() > 0)
    emit dataChanged(index(0), index(rowCount() - 1));
}

} // namespace voluta::panels
