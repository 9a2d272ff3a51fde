#include "panels/findings_model.h"

#include "forms/duration_text.h"
#include "language/translated.h"
#include "language/words.h"
#include "plan/finding_kinds.h"

#include <QLocale>
#include <algorithm>

namespace voluta::panels {

FindingsModel::FindingsModel(QObject* parent) : QAbstractListModel(parent) {}

FindingsModel::Weight FindingsModel::weightOf(const plan::Finding& finding) const {
  if (!finding.blocking)
    return Informs;
  return plan::blocksRunning(finding) || !hasPrograms_ ? Blocks : Differs;
}

void FindingsModel::setFindings(const plan::Findings& findings, const plan::Findings& before,
                                bool hasPrograms) {
  beginResetModel();
  hasPrograms_ = hasPrograms;
  const auto inOrder = [this](const plan::Findings& some) {
    std::vector<ListedFinding> rows = byFact(listed(some));
    std::stable_sort(rows.begin(), rows.end(),
                     [this](const ListedFinding& a, const ListedFinding& b) {
                       const Weight first = weightOf(a.finding), second = weightOf(b.finding);
                       if (first != second)
                         return first < second;
                       return plan::stageOf(a.finding) < plan::stageOf(b.finding);
                     });
    return rows;
  };
  rows_ = inOrder(findings);
  current_ = rows_.size();
  const auto count = [this](Weight weight) {
    return static_cast<std::size_t>(std::ranges::count_if(
        rows_, [&](const ListedFinding& row) { return weightOf(row.finding) == weight; }));
  };
  blocking_ = count(Blocks);
  differing_ = count(Differs);
  const std::vector<ListedFinding> older = inOrder(before);
  rows_.insert(rows_.end(), older.begin(), older.end());
  endResetModel();
}

QStringList FindingsModel::formats(int row) const {
  QStringList names;
  for (const std::string& format : rows_.at(static_cast<std::size_t>(row)).formats)
    names << QString::fromStdString(format);
  return names;
}

QString FindingsModel::reason(int row) const {
  // For several programs only the fact is shown, for a single one also its line.
  const ListedFinding& listed = rows_.at(static_cast<std::size_t>(row));
  return language::capitalized(language::words(
      listed.formats.empty() ? plan::reasonOf(listed.finding) : plan::factOf(listed.finding)));
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
  return static_cast<int>(blockedOnly_ ? blocking_ + differing_ : rows_.size());
}

const plan::Finding& FindingsModel::finding(int row) const {
  return rows_.at(static_cast<std::size_t>(row)).finding;
}

const plan::Findings& FindingsModel::places(int row) const {
  return rows_.at(static_cast<std::size_t>(row)).places;
}

QVariant FindingsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount())
    return {};
  const plan::Finding& f = finding(index.row());
  switch (role) {
  case Qt::DisplayRole:
    return reason(index.row());
  case Qt::ToolTipRole:
    return (QStringList{reason(index.row()), remedyText(f)}).join(QLatin1Char('\n')).trimmed();
  case Qt::AccessibleTextRole:
    return (weightOf(f) == Blocks                       ? tr("Blocked: %1")
            : f.kind == plan::FindingKind::OwnStatement ? tr("Not checked: %1")
            : weightOf(f) == Differs                    ? tr("Not as asked: %1")
                                                        : tr("Worth knowing: %1"))
        .arg((QStringList{reason(index.row())} + formats(index.row())).join(QStringLiteral(", ")));
  case DetailRole:
    return rowDetail(index.row());
  case FormatsRole:
    return formats(index.row());
  case OutOfDateRole:
    return isOutOfDate(index.row());
  case WeightRole:
    return weightOf(f);
  default:
    return {};
  }
}

QString FindingsModel::rowDetail(int row) const {
  QStringList parts;
  if (isOutOfDate(row))
    parts << tr("before the change");
  if (const std::size_t places = this->places(row).size(); places > 1) {
    parts << tr("%n places", nullptr, static_cast<int>(places));
    plan::Finding all = finding(row); // without one of its places
    all.where.reset();
    all.whenS.reset();
    parts << detail(all);
  } else {
    parts << detail(finding(row));
  }
  return parts.join(QStringLiteral(" · "));
}

QString FindingsModel::remedyText(const plan::Finding& finding) {
  return language::capitalized(language::words(plan::remedyOf(finding)));
}

QString FindingsModel::detail(const plan::Finding& finding) const {
  const QLocale locale;
  QStringList parts;
  if (finding.item >= 0 && finding.item < parts_.size())
    parts << parts_[finding.item];
  parts << language::words(plan::stageLabel(plan::stageOf(finding)));
  if (finding.count > 1)
    parts << QStringLiteral("× ") + locale.toString(static_cast<qulonglong>(finding.count));
  if (finding.where) {
    const Eigen::Vector3d& at = *finding.where;
    parts << tr("at %1, %2, %3 mm")
                 .arg(locale.toString(at.x(), 'f', 1), locale.toString(at.y(), 'f', 1),
                      locale.toString(at.z(), 'f', 1));
  }
  if (finding.whenS)
    parts << forms::clockText(*finding.whenS, *finding.whenS);
  return parts.join(QStringLiteral(" · "));
}

void FindingsModel::retranslate() {
  if (rowCount() > 0)
    emit dataChanged(index(0), index(rowCount() - 1));
}

} // namespace voluta::panels
