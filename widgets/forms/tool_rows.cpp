#include "forms/tool_rows.h"

#include "forms/value_boxes.h"
#include "layers/tool_assignment.h"

#include <QColor>
#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QToolButton>

namespace voluta::forms {

ToolRows::ToolRows(QWidget* parent) : QWidget(parent), grid_(new QGridLayout(this)) {
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(8);
  grid_->setVerticalSpacing(4);
  grid_->setColumnStretch(1, 3);
  grid_->setColumnStretch(2, 2);
  add_ = new QToolButton(this);
  add_->setObjectName(QStringLiteral("toolAdd"));
  grid_->addWidget(add_, 0, 0, 1, 4);
  connect(add_, &QToolButton::clicked, this, &ToolRows::addRequested);
  retranslate();
}

void ToolRows::setLists(const std::vector<ChoiceItem>& processes,
                        const std::vector<ChoiceItem>& materials) {
  processes_ = processes;
  materials_ = materials;
  for (const Row& row : rows_) {
    fillCombo(row.process, processes_);
    fillCombo(row.material, materials_);
  }
}

void ToolRows::addRow() {
  const int tool = static_cast<int>(rows_.size()) + 1;
  Row row;
  row.label = new QLabel(this);
  row.process = makeCombo(this);
  row.process->setObjectName(QStringLiteral("toolProcess%1").arg(tool + 1));
  row.material = makeCombo(this);
  row.material->setObjectName(QStringLiteral("toolMaterial%1").arg(tool + 1));
  row.remove = new QToolButton(this);
  row.remove->setObjectName(QStringLiteral("toolRemove%1").arg(tool + 1));
  row.remove->setText(QStringLiteral("\u00d7"));
  row.label->setBuddy(row.process);
  fillCombo(row.process, processes_);
  fillCombo(row.material, materials_);
  int column = 0;
  for (QWidget* cell :
       std::initializer_list<QWidget*>{row.label, row.process, row.material, row.remove})
    grid_->addWidget(cell, tool - 1, column++);
  grid_->addWidget(add_, tool, 0, 1, 4);
  connect(row.process, &QComboBox::activated, this, [this, tool, box = row.process] {
    emit processChosen(tool, box->currentData().toString());
  });
  connect(row.material, &QComboBox::activated, this, [this, tool, box = row.material] {
    emit materialChosen(tool, box->currentData().toString());
  });
  connect(row.remove, &QToolButton::clicked, this, [this, tool] { emit removeRequested(tool); });
  rows_.push_back(row);
  setTabOrder(row.process, row.material);
  setTabOrder(row.material, row.remove);
  setTabOrder(row.remove, add_);
}

void ToolRows::setTools(const std::vector<ToolTexts>& tools) {
  const std::size_t before = rows_.size();
  while (rows_.size() < tools.size())
    addRow();
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const Row& row = rows_[i];
    const bool isUsed = i < tools.size();
    for (QWidget* cell :
         std::initializer_list<QWidget*>{row.label, row.process, row.material, row.remove})
      cell->setVisible(isUsed);
    if (!isUsed)
      continue;
    chooseId(row.process, tools[i].process);
    chooseId(row.material, tools[i].material);
    if (const QColor colour(tools[i].colour); colour.isValid() && row.material->currentIndex() >= 0)
      row.material->setItemIcon(row.material->currentIndex(),
                                swatchOf(colour, fontMetrics().height()));
  }
  add_->setVisible(tools.size() + 1 < layers::kMaxTools);
  if (rows_.size() != before)
    retranslate();
}

void ToolRows::retranslate() {
  add_->setText(tr("Add tool"));
  add_->setToolTip(tr("Adds a second nozzle or material, for some parts, supports, pieces or the "
                      "interior. The program stops for each change."));
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    rows_[i].label->setText(tr("Tool %1").arg(i + 2));
    rows_[i].process->setToolTip(tr("Process of tool %1").arg(i + 2));
    rows_[i].material->setToolTip(tr("Material of tool %1").arg(i + 2));
    rows_[i].remove->setToolTip(tr("Remove tool %1").arg(i + 2));
    rows_[i].remove->setAccessibleName(rows_[i].remove->toolTip());
  }
}

void ToolRows::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    retranslate();
  QWidget::changeEvent(event);
}

} // namespace voluta::forms
