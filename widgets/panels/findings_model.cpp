#include "panels/findings_model.h"

#include "panels/finding_texts.h"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <array>
#include <cmath>

namespace voluta::panels {

namespace {
struct StageName {
  const char* id;
  const char* label;
};
// In the order of the road.
constexpr auto kStages = std::to_array<StageName>({
    {"load", QT_TRANSLATE_NOOP("Stages", "Load")},
    {"decompose", QT_TRANSLATE_NOOP("Stages", "Decomposition")},
    {"layers", QT_TRANSLATE_NOOP("Stages", "Layers")},
    {"toolpath", QT_TRANSLATE_NOOP("Stages", "Tool-paths")},
    {"motion", QT_TRANSLATE_NOOP("Stages", "Motion")},
    {"replay", QT_TRANSLATE_NOOP("Stages", "Replay")},
});

std::size_t rankOf(const std::string& stage) {
  const auto found = std::find_if(kStages.begin(), kStages.end(),
                                  [&](const StageName& name) { return stage == name.id; });
  return static_cast<std::size_t>(found - kStages.begin());
}
} // namespace

QString stageText(const std::string& stage) {
  const std::size_t rank = rankOf(stage);
  return rank < kStages.size() ? QCoreApplication::translate("Stages", kStages[rank].label)
                               : QString::fromStdString(stage);
}

FindingsModel::FindingsModel(QObject* parent) : QAbstractListModel(parent) {}

void FindingsModel::setFindings(plan::Findings findings) {
  beginResetModel();
  findings_ = std::move(findings);
  std::stable_sort(findings_.begin(), findings_.end(),
                   [](const plan::Finding& a, const plan::Finding& b) {
                     if (a.blocking != b.blocking)
                       return a.blocking;
                     return rankOf(a.stage) < rankOf(b.stage);
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
    return findingText(f.reason);
  case Qt::ToolTipRole:
    return f.remedy.empty() ? findingText(f.reason)
                            : findingText(f.reason) + QLatin1Char('\n') + findingText(f.remedy);
  case Qt::AccessibleTextRole:
    return (f.blocking ? tr("Blocked: %1") : tr("Worth knowing: %1")).arg(findingText(f.reason));
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
  QStringList parts{stageText(finding.stage)};
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
