#include "panels/head_table.h"

#include "forms/icons.h"
#include "forms/value_boxes.h"
#include "language/numbers.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

namespace voluta::panels {

namespace {
constexpr double kMaxMm = 5000.0, kNewSectionMm = 10.0;

// Edits numbers in boxes with their unit.
class NumberDelegate : public QStyledItemDelegate {
public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem&,
                        const QModelIndex&) const override {
    auto* box = new forms::NumberBox(parent);
    box->setRange(0.0, kMaxMm);
    box->setUnit(QStringLiteral("mm"));
    box->setFrame(false);
    return box;
  }
  QString displayText(const QVariant& value, const QLocale&) const override {
    return language::numberText(value.toDouble(), 6);
  }
};

bool same(const process::HeadShape& a, const process::HeadShape& b) {
  return std::ranges::equal(a.sections, b.sections, [](const auto& one, const auto& other) {
    return one.zMm == other.zMm && one.radiusMm == other.radiusMm;
  });
}
} // namespace

HeadTable::HeadTable(QWidget* parent)
    : QWidget(parent), table_(new QTableWidget(0, 2, this)), add_(new QToolButton(this)),
      remove_(new QToolButton(this)), reset_(new QToolButton(this)), problemIcon_(new QLabel(this)),
      problem_(new QLabel(this)) {
  table_->setObjectName("headTable");
  table_->setItemDelegate(new NumberDelegate(table_));
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setTabKeyNavigation(false);
  table_->setMinimumHeight(5 * (fontMetrics().height() + 6));
  add_->setObjectName("headAdd");
  remove_->setObjectName("headRemove");
  reset_->setObjectName("headReset");
  reset_->setIcon(forms::icon(forms::Icon::Reset));
  reset_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  problem_->setObjectName("headProblem");
  problem_->setWordWrap(true);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(add_);
  buttons->addWidget(remove_);
  buttons->addStretch(1);
  buttons->addWidget(reset_);
  auto* line = new QHBoxLayout;
  line->addWidget(problemIcon_, 0, Qt::AlignTop);
  line->addWidget(problem_, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(table_, 1);
  column->addLayout(line);
  column->addLayout(buttons);
  connect(table_, &QTableWidget::cellChanged, this, &HeadTable::edit);
  connect(table_, &QTableWidget::itemSelectionChanged, this, &HeadTable::showButtons);
  connect(add_, &QToolButton::clicked, this, &HeadTable::addRow);
  connect(remove_, &QToolButton::clicked, this, &HeadTable::removeRow);
  connect(reset_, &QToolButton::clicked, this, [this] { take(reference_); });
  setProblem({});
  retranslate();
  showButtons();
}

void HeadTable::setHead(const process::HeadShape& head) {
  if (same(head, head_) && table_->rowCount() > 0)
    return;
  head_ = head;
  fill();
}

void HeadTable::setReference(const process::HeadShape& head) {
  reference_ = head;
  showButtons();
}

void HeadTable::setReadOnly(bool readOnly) {
  readOnly_ = readOnly;
  table_->setEditTriggers(readOnly ? QAbstractItemView::NoEditTriggers
                                   : QAbstractItemView::AllEditTriggers);
  showButtons();
}

void HeadTable::setProblem(const QString& problem) {
  problemIcon_->setPixmap(forms::iconBeside(*this, forms::Icon::Blocked));
  problem_->setText(problem);
  problemIcon_->setVisible(!problem.isEmpty());
  problem_->setVisible(!problem.isEmpty());
}

void HeadTable::fill() {
  const QSignalBlocker quiet(table_);
  const int current = table_->currentRow();
  table_->setRowCount(static_cast<int>(head_.sections.size()));
  for (int row = 0; row < table_->rowCount(); ++row)
    for (int column = 0; column < 2; ++column) {
      const process::HeadSection& section = head_.sections[static_cast<std::size_t>(row)];
      auto* item = new QTableWidgetItem;
      item->setData(Qt::EditRole, column == 0 ? section.zMm : section.radiusMm);
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      table_->setItem(row, column, item);
    }
  if (current >= 0)
    table_->setCurrentCell(std::min(current, table_->rowCount() - 1), 0);
  showButtons();
}

void HeadTable::take(process::HeadShape head) {
  head_ = std::move(head);
  fill();
  emit headChanged(head_);
}

void HeadTable::edit(int row, int column) {
  process::HeadSection& section = head_.sections[static_cast<std::size_t>(row)];
  double& value = column == 0 ? section.zMm : section.radiusMm;
  const double typed = table_->item(row, column)->data(Qt::EditRole).toDouble();
  if (typed == value)
    return;
  value = typed;
  showButtons();
  emit headChanged(head_);
}

void HeadTable::addRow() {
  process::HeadShape head = head_;
  const int current = table_->currentRow();
  const std::size_t at = current < 0 ? head.sections.size() : static_cast<std::size_t>(current) + 1;
  process::HeadSection section = at > 0 ? head.sections[at - 1] : process::HeadSection();
  section.zMm = at < head.sections.size() ? 0.5 * (section.zMm + head.sections[at].zMm)
                                          : section.zMm + kNewSectionMm;
  head.sections.insert(head.sections.begin() + static_cast<long>(at), section);
  take(std::move(head));
  table_->setCurrentCell(static_cast<int>(at), 0);
}

void HeadTable::removeRow() {
  const int row = table_->currentRow();
  if (row < 0)
    return;
  process::HeadShape head = head_;
  head.sections.erase(head.sections.begin() + row);
  take(std::move(head));
}

void HeadTable::showButtons() {
  add_->setEnabled(!readOnly_);
  remove_->setEnabled(!readOnly_ && table_->currentRow() >= 0);
  reset_->setVisible(!readOnly_ && !same(head_, reference_));
}

void HeadTable::retranslate() {
  table_->setHorizontalHeaderLabels({tr("Height [mm]"), tr("Radius [mm]")});
  table_->setToolTip(tr("Sections of the head from the tip up. Two rows of the same height are a "
                        "step."));
  table_->setAccessibleName(tr("Sections of the head"));
  add_->setText(tr("Add row"));
  remove_->setText(tr("Remove row"));
  reset_->setText(tr("Reset head"));
}

void HeadTable::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    retranslate();
  QWidget::changeEvent(event);
}

} // namespace voluta::panels
