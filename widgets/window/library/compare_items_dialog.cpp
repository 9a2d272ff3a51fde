#include "window/library/compare_items_dialog.h"

#include "forms/value_boxes.h"
#include "language/parameter_texts.h"
#include "language/words.h"
#include "process/library_fields.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>

namespace voluta::window {

namespace {
// The word for a missing value, or the value with its unit.
QString shown(const base::ParameterSpec& spec, base::Text none, const base::ParameterValue& value) {
  const auto* number = std::get_if<double>(&value);
  if (number && !none.empty() && *number <= spec.minimum)
    return language::words(none);
  if (const auto* text = std::get_if<std::string>(&value))
    return QString::fromStdString(*text);
  return language::valueText(spec, value);
}
} // namespace

CompareItemsDialog::CompareItemsDialog(std::vector<process::LibraryItem> items, int first,
                                       int second, QWidget* parent)
    : QDialog(parent), items_(std::move(items)), first_(forms::makeCombo(this)),
      second_(forms::makeCombo(this)), table_(new QTableWidget(0, 3, this)),
      count_(new QLabel(this)) {
  setObjectName("compareItems");
  setWindowTitle(tr("Compare"));
  first_->setObjectName("compareFirst");
  second_->setObjectName("compareSecond");
  table_->setObjectName("compareFields");
  count_->setObjectName("compareCount");
  for (QComboBox* combo : {first_, second_})
    for (const process::LibraryItem& item : items_)
      combo->addItem(QString::fromStdString(item.id()));
  first_->setCurrentIndex(first);
  second_->setCurrentIndex(second);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionMode(QAbstractItemView::NoSelection);
  table_->setFocusPolicy(Qt::NoFocus);
  table_->verticalHeader()->hide();
  table_->setWordWrap(true);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  auto* both = new QHBoxLayout;
  both->addWidget(first_);
  both->addWidget(second_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  for (QComboBox* combo : {first_, second_})
    connect(combo, &QComboBox::currentIndexChanged, this, &CompareItemsDialog::show);
  auto* column = new QVBoxLayout(this);
  column->addLayout(both);
  column->addWidget(count_);
  column->addWidget(table_, 1);
  column->addWidget(buttons);
  resize(720, 460);
  show();
}

void CompareItemsDialog::show() {
  const process::LibraryItem& a = items_[static_cast<std::size_t>(first_->currentIndex())];
  const process::LibraryItem& b = items_[static_cast<std::size_t>(second_->currentIndex())];
  const std::vector<process::FieldDifference> found = process::differences(a, b);
  table_->setHorizontalHeaderLabels(
      {tr("Field"), QString::fromStdString(a.id()), QString::fromStdString(b.id())});
  table_->setRowCount(static_cast<int>(found.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    const process::FieldDifference& difference = found[static_cast<std::size_t>(row)];
    const auto put = [&](int column, const QString& text) {
      auto* item = new QTableWidgetItem(text);
      item->setToolTip(text);
      table_->setItem(row, column, item);
    };
    put(0, language::heading(difference.spec.label));
    put(1, shown(difference.spec, difference.none, difference.first));
    put(2, shown(difference.spec, difference.none, difference.second));
  }
  table_->resizeRowsToContents();
  count_->setText(found.empty() ? tr("No differences.")
                                : tr("Differing fields: %1").arg(found.size()));
}

} // namespace voluta::window
