#include "panels/format_list.h"

#include "forms/colours.h"
#include "forms/discard.h"
#include "forms/icons.h"

#include <QEvent>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <algorithm>

namespace voluta::panels {

namespace {
constexpr int kLabel = 0, kForeign = 1, kVerdict = 2;
constexpr int kIdRole = Qt::UserRole;

forms::Icon iconOf(VerdictState state) {
  switch (state) {
  case VerdictState::Passed:
    return forms::Icon::Good;
  case VerdictState::NotAsAsked:
  case VerdictState::Unchecked:
    return forms::Icon::Warning;
  case VerdictState::Blocked:
  case VerdictState::Refused:
    return forms::Icon::Blocked;
  case VerdictState::NotYet:
  case VerdictState::OutOfDate:
    break;
  }
  return forms::Icon::Pending;
}

// Unavailable rows are grey but still clickable, to show why. The check box edges of Fusion, a
// darker shade of the window colour, are invisible on a dark list, so they are painted here.
class FormatDelegate : public QStyledItemDelegate {
public:
  using QStyledItemDelegate::QStyledItemDelegate;

protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    QStyledItemDelegate::initStyleOption(option, index);
    if (!index.flags().testFlag(Qt::ItemIsUserCheckable))
      option->state.setFlag(QStyle::State_Enabled, index.column() != kLabel);
    if (forms::isDark(option->palette))
      option->palette.setColor(QPalette::Window, forms::mutedColour(option->palette));
  }
};
} // namespace

FormatList::FormatList(QWidget* parent) : QTreeWidget(parent) {
  setColumnCount(3);
  setItemDelegate(new FormatDelegate(this));
  setHeaderHidden(true);
  setRootIsDecorated(false);
  setUniformRowHeights(true);
  setAllColumnsShowFocus(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  header()->setStretchLastSection(false);
  header()->setMinimumSectionSize(fontMetrics().height());
  header()->setSectionResizeMode(kLabel, QHeaderView::Stretch);
  header()->setSectionResizeMode(kForeign, QHeaderView::ResizeToContents);
  header()->setSectionResizeMode(kVerdict, QHeaderView::ResizeToContents);
  connect(this, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem*, int column) {
    if (column != kLabel)
      return;
    offerCheckBoxes();
    emit checkedChanged(checkedIds());
  });
  connect(this, &QTreeWidget::currentItemChanged, this, [this] {
    chosen_ = true;
    emit currentChangedTo(currentId());
  });
}

void FormatList::setFormats(const std::vector<ExportFormat>& formats) {
  const QSignalBlocker quiet(this);
  const bool sameRows =
      std::ranges::equal(formats, formats_, {}, &ExportFormat::id, &ExportFormat::id);
  formats_ = formats;
  if (!sameRows)
    makeRows();
  const bool stays = chosen_ && currentItem();
  if (!currentItem() && topLevelItemCount() > 0)
    setCurrentItem(topLevelItem(0));
  // A row with a program is preferred over one without that the user has not chosen.
  const auto written = [](const ExportFormat& format) { return !format.files.empty(); };
  const int row = indexOfTopLevelItem(currentItem());
  const auto first = std::find_if(formats_.begin(), formats_.end(), written);
  if (!stays && row >= 0 && !written(formats_[static_cast<std::size_t>(row)]) &&
      first != formats_.end())
    setCurrentItem(topLevelItem(static_cast<int>(first - formats_.begin())));
  offerCheckBoxes();
  retranslate();
  updateGeometry();
}

// Keeps the current row and the check marks.
void FormatList::makeRows() {
  const QString current = currentId();
  const QStringList checked = checkedIds();
  forms::discardRows(*this);
  for (const ExportFormat& format : formats_) {
    auto* item = new QTreeWidgetItem(this);
    item->setData(kLabel, kIdRole, format.id);
    item->setCheckState(kLabel, checked.contains(format.id) ? Qt::Checked : Qt::Unchecked);
    if (format.id == current)
      setCurrentItem(item);
  }
}

// A format that cannot be written can only be unchecked.
void FormatList::offerCheckBoxes() {
  const QSignalBlocker quiet(this);
  for (int i = 0; i < topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = topLevelItem(i);
    const bool offered = formats_[static_cast<std::size_t>(i)].whyNot.isEmpty();
    Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    flags.setFlag(Qt::ItemIsUserCheckable, offered || item->checkState(kLabel) == Qt::Checked);
    item->setFlags(flags);
  }
}

void FormatList::setChecked(const QStringList& ids) {
  const QSignalBlocker quiet(this);
  for (int i = 0; i < topLevelItemCount(); ++i) {
    QTreeWidgetItem* item = topLevelItem(i);
    item->setCheckState(
        kLabel, ids.contains(item->data(kLabel, kIdRole).toString()) ? Qt::Checked : Qt::Unchecked);
  }
  offerCheckBoxes();
}

QStringList FormatList::checkedIds() const {
  QStringList ids;
  for (int i = 0; i < topLevelItemCount(); ++i)
    if (topLevelItem(i)->checkState(kLabel) == Qt::Checked)
      ids << topLevelItem(i)->data(kLabel, kIdRole).toString();
  return ids;
}

QString FormatList::currentId() const {
  return currentItem() ? currentItem()->data(kLabel, kIdRole).toString() : QString();
}

QSize FormatList::sizeHint() const {
  const int row = topLevelItemCount() > 0 ? sizeHintForRow(0) : fontMetrics().height() + 4;
  const int rows = std::clamp(topLevelItemCount(), 3, 8);
  return {fontMetrics().averageCharWidth() * 40, rows * row + 2 * frameWidth()};
}

QSize FormatList::minimumSizeHint() const {
  return {fontMetrics().averageCharWidth() * 20, sizeHint().height()};
}

QString FormatList::verdictOf(const ExportFormat& format) {
  switch (format.state) {
  case VerdictState::NotYet:
    break;
  case VerdictState::Passed:
    return tr("Passed: the replay found no errors");
  case VerdictState::NotAsAsked:
    return tr("Safe to run, not as asked: %1").arg(format.whyRefused);
  case VerdictState::Unchecked:
    return tr("Safe to run but for your own statements: %1").arg(format.whyRefused);
  case VerdictState::Blocked:
    return tr("Not passed, the plan is blocked: %1").arg(format.whyRefused);
  case VerdictState::Refused:
    return tr("Refused by the replay: %1").arg(format.whyRefused);
  case VerdictState::OutOfDate:
    return tr("Not replayed since the change");
  }
  return tr("Not replayed yet");
}

void FormatList::retranslate() {
  const QSignalBlocker quiet(this);
  for (int i = 0; i < topLevelItemCount(); ++i) {
    const ExportFormat& format = formats_[static_cast<std::size_t>(i)];
    QTreeWidgetItem* item = topLevelItem(i);
    item->setText(kLabel, format.foreign ? tr("%1, foreign").arg(format.label) : format.label);
    item->setIcon(kForeign, format.foreign ? forms::icon(forms::Icon::Foreign) : QIcon());
    item->setToolTip(kForeign, format.foreign
                                   ? tr("For another maker's controller: where the nozzle goes, "
                                        "not how this robot moves")
                                   : QString());
    const bool offered = format.whyNot.isEmpty();
    item->setIcon(kVerdict, offered ? forms::icon(iconOf(format.state)) : QIcon());
    const QString verdict = offered ? verdictOf(format) : format.whyNot;
    item->setToolTip(kVerdict, verdict);
    item->setToolTip(kLabel, item->text(kLabel) + QStringLiteral("\n") + verdict);
    item->setData(kVerdict, Qt::AccessibleTextRole, verdict);
  }
}

void FormatList::changeEvent(QEvent* event) {
  QTreeWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange)
    retranslate();
}

} // namespace voluta::panels
