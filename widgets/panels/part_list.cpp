#include "panels/part_list.h"

#include "forms/colours.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

namespace voluta::panels {

namespace {
constexpr int kName = 0, kStrategy = 1, kSize = 2;
constexpr int kMaxRows = 5;
constexpr int kRowSpace = 6; // [px]
} // namespace

PartList::PartList(QWidget* parent) : QWidget(parent) {
  build();
  retranslate();
}

void PartList::build() {
  rows_ = new QTreeWidget(this);
  rows_->setObjectName(QStringLiteral("partRows"));
  rows_->setColumnCount(3);
  rows_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  rows_->setRootIsDecorated(false);
  rows_->setUniformRowHeights(true);
  rows_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  rows_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  rows_->header()->setStretchLastSection(false);
  rows_->header()->setSectionResizeMode(kName, QHeaderView::Stretch);
  for (const int fits : {kStrategy, kSize})
    rows_->header()->setSectionResizeMode(fits, QHeaderView::ResizeToContents);
  connect(rows_, &QTreeWidget::currentItemChanged, this, [this](QTreeWidgetItem* row) {
    if (row)
      emit selected(static_cast<std::size_t>(rows_->indexOfTopLevelItem(row)));
  });
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(4);
  const auto button = [&](const char* name, void (PartList::*asked)()) {
    auto* made = new QToolButton(this);
    made->setObjectName(QString::fromLatin1(name));
    buttons->addWidget(made);
    connect(made, &QToolButton::clicked, this, asked);
    return made;
  };
  add_ = button("partAdd", &PartList::addRequested);
  duplicate_ = button("partDuplicate", &PartList::duplicateRequested);
  remove_ = button("partRemove", &PartList::removeRequested);
  arrange_ = button("partArrange", &PartList::arrangeRequested);
  buttons->addStretch(1);
  orderLabel_ = new QLabel(this);
  order_ = new QComboBox(this);
  order_->setObjectName(QStringLiteral("printOrder"));
  for (const auto order : {layers::PrintOrder::OneAfterAnother, layers::PrintOrder::ByLayer})
    order_->addItem({}, static_cast<int>(order));
  orderLabel_->setBuddy(order_);
  connect(order_, &QComboBox::activated, this, [this] {
    emit printOrderChosen(static_cast<layers::PrintOrder>(order_->currentData().toInt()));
  });
  auto* order = new QHBoxLayout;
  order->addWidget(orderLabel_);
  order->addWidget(order_, 1);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(6, 6, 6, 6);
  column->setSpacing(4);
  column->addWidget(rows_);
  column->addLayout(buttons);
  column->addLayout(order);
}

void PartList::setParts(const std::vector<ListedPart>& parts, std::size_t active) {
  const QSignalBlocker quiet(rows_);
  const auto count = static_cast<int>(parts.size());
  while (rows_->topLevelItemCount() > count)
    delete rows_->takeTopLevelItem(rows_->topLevelItemCount() - 1);
  while (rows_->topLevelItemCount() < count)
    rows_->addTopLevelItem(new QTreeWidgetItem);
  for (int i = 0; i < count; ++i) {
    const ListedPart& part = parts[static_cast<std::size_t>(i)];
    QTreeWidgetItem* row = rows_->topLevelItem(i);
    row->setSizeHint(kName, QSize(0, fontMetrics().height() + kRowSpace));
    row->setText(kName, part.name);
    row->setToolTip(kName, part.name);
    row->setText(kStrategy, part.strategy);
    row->setText(kSize, part.size);
    for (const int muted : {kStrategy, kSize})
      row->setForeground(muted, forms::mutedColour(palette()));
  }
  rows_->setCurrentItem(rows_->topLevelItem(static_cast<int>(active)));
  fitHeight();
  rows_->scrollToItem(rows_->currentItem());
}

void PartList::selectAll() {
  rows_->selectAll();
}

std::vector<std::size_t> PartList::selection() const {
  std::vector<std::size_t> selected;
  for (int i = 0; i < rows_->topLevelItemCount(); ++i)
    if (rows_->topLevelItem(i)->isSelected() || rows_->topLevelItem(i) == rows_->currentItem())
      selected.push_back(static_cast<std::size_t>(i));
  return selected;
}

void PartList::setPrintOrder(layers::PrintOrder order) {
  order_->setCurrentIndex(order_->findData(static_cast<int>(order)));
}

void PartList::fitHeight() {
  const int rows = std::clamp(rows_->topLevelItemCount(), 1, kMaxRows);
  rows_->setFixedHeight(rows_->header()->sizeHint().height() +
                        rows * (fontMetrics().height() + kRowSpace) + 2 * rows_->frameWidth());
}

void PartList::retranslate() {
  rows_->setHeaderLabels({tr("Part"), tr("Mode"), tr("Size [mm]")});
  add_->setText(tr("Add…"));
  add_->setToolTip(tr("Adds a part from a file beside the others"));
  duplicate_->setText(tr("Duplicate"));
  duplicate_->setToolTip(tr("Adds a copy of the selected part with its settings"));
  remove_->setText(tr("Remove"));
  remove_->setToolTip(tr("Removes the selected part; can be undone"));
  arrange_->setText(tr("Arrange"));
  arrange_->setToolTip(tr("Moves all parts beside each other, with room for the print head"));
  orderLabel_->setText(tr("Print order"));
  order_->setItemText(0, tr("One after another"));
  order_->setItemText(1, tr("Layer by layer"));
  order_->setToolTip(tr("One after another: each part is finished before the next begins. Layer by "
                        "layer: all parts grow together."));
}

void PartList::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    retranslate();
  QWidget::changeEvent(event);
}

} // namespace voluta::panels
