#include "panels/item_form.h"

#include "base/error.h"
#include "forms/discard.h"
#include "forms/fold.h"
#include "forms/parameter_row.h"
#include "forms/value_boxes.h"
#include "language/words.h"

#include <QAction>
#include <QColorDialog>
#include <QComboBox>
#include <QEvent>
#include <QLineEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>
#include <algorithm>

namespace voluta::panels {

namespace {
// Scrolls up and down, and is never narrower than its content.
class UprightArea : public QScrollArea {
public:
  using QScrollArea::QScrollArea;

  QSize minimumSizeHint() const override {
    QSize size = QScrollArea::minimumSizeHint();
    if (widget())
      size.setWidth(widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width());
    return size;
  }
};

constexpr const char* kFoldedGroup = "Features";  // Seldom edited
constexpr int kTextChars = 36, kNumberChars = 23; // Widths of the editors
constexpr const char* kColour = "colour";         // Key of the field with a swatch
constexpr int kMaxWidth = 620;                    // Labels stay near their editors

// Materials are named by their ids, as in the job's list.
void nameMaterials(QComboBox& combo, const std::vector<base::Choice>& choices) {
  for (int i = 0; i < combo.count(); ++i)
    combo.setItemText(i, QString::fromStdString(choices[static_cast<std::size_t>(i)].id));
}

// Keeps the value as legible as one that can be edited.
void setLocked(QWidget& editor, bool locked) {
  if (auto* box = qobject_cast<QDoubleSpinBox*>(&editor)) {
    box->setReadOnly(locked);
    box->setButtonSymbols(locked ? QAbstractSpinBox::NoButtons : QAbstractSpinBox::UpDownArrows);
  } else if (auto* line = qobject_cast<QLineEdit*>(&editor)) {
    line->setReadOnly(locked);
  } else {
    editor.setEnabled(!locked);
  }
}

QIcon swatchOf(const QString& colour, int side) {
  QPixmap swatch(side, side);
  swatch.fill(QColor::isValidColorName(colour) ? QColor(colour) : Qt::transparent);
  return swatch;
}

// Returns the materials that the item's form offers.
std::vector<std::string> materialsOf(const process::LibraryItem& item) {
  std::vector<std::string> ids;
  for (const process::LibraryField& field : process::libraryFields(item))
    for (const base::Choice& choice : field.spec.choices)
      ids.push_back(choice.id);
  return ids;
}
} // namespace

ItemForm::ItemForm(QWidget* parent) : QWidget(parent) {
  auto* scroll = new UprightArea(this);
  scroll->setObjectName("itemScroll");
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* inside = new QWidget;
  column_ = new QVBoxLayout(inside);
  column_->setContentsMargins(0, 0, 4, 4);
  column_->addStretch(1);
  scroll->setWidget(inside);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(scroll);
}

ItemForm::~ItemForm() = default;

void ItemForm::setItem(const process::LibraryItem& item, const process::LibraryItem& reference,
                       bool readOnly) {
  const bool other =
      rows_.empty() || item.shelf() != item_.shelf() || materialsOf(item) != materialsOf(item_);
  item_ = item;
  if (other)
    build();
  // Fields know the item's own material.
  std::vector<process::LibraryField> fields = process::libraryFields(item);
  for (std::size_t i = 0; i < rows_.size(); ++i)
    rows_[i].field = std::move(fields[i]);
  for (const Row& row : rows_) {
    setLocked(*row.row->editor(), readOnly);
    row.row->setDefault(row.field.get(reference));
    row.row->setValue(row.field.get(item));
    if (row.field.spec.type == base::ParameterType::Choice)
      nameMaterials(*static_cast<QComboBox*>(row.row->editor()), row.field.spec.choices);
  }
  if (swatch_)
    swatch_->setEnabled(!readOnly);
  mark();
}

void ItemForm::build() {
  if (content_) {
    forms::discard(content_);
    content_->setParent(nullptr); // Its rows have the names of those that follow
  }
  rows_.clear();
  groups_.clear();
  swatch_ = nullptr;
  content_ = new QWidget;
  content_->setMaximumWidth(kMaxWidth);
  auto* column = new QVBoxLayout(content_);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  column_->insertWidget(0, content_);
  for (const process::LibraryField& field : process::libraryFields(item_))
    addRow(field);
  retranslate();
}

forms::Fold* ItemForm::foldOf(base::Text group) {
  const auto at = std::ranges::find(groups_, group, &Group::name);
  if (at != groups_.end())
    return at->fold;
  auto* rows = new QWidget;
  auto* column = new QVBoxLayout(rows);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  auto* fold = new forms::Fold(rows, content_);
  fold->setObjectName(QString::fromStdString(base::english(group)));
  if (group.english() == kFoldedGroup)
    fold->setOpen(false);
  content_->layout()->addWidget(fold);
  groups_.push_back({group, fold});
  return fold;
}

void ItemForm::addRow(const process::LibraryField& field) {
  forms::Fold* fold = foldOf(field.spec.group);
  auto* row = new forms::ParameterRow(field.spec, fold);
  const bool isText = field.spec.type == base::ParameterType::Text;
  row->editor()->setFixedWidth(fontMetrics().averageCharWidth() *
                               (isText ? kTextChars : kNumberChars));
  if (auto* box = qobject_cast<QDoubleSpinBox*>(row->editor()); box && !field.none.empty())
    box->setSpecialValueText(language::words(field.none));
  fold->contentLayout()->addWidget(row);
  if (field.spec.key == kColour)
    addSwatch(rows_.size(), *static_cast<QLineEdit*>(row->editor()));
  const std::size_t at = rows_.size();
  rows_.push_back({field, row});
  using forms::ParameterRow;
  connect(row, &ParameterRow::committed, this, [this, at] { change(at); });
  connect(row, &ParameterRow::resetRequested, this, [this, at] { change(at); });
}

// The swatch within the field opens a dialog.
void ItemForm::addSwatch(std::size_t at, QLineEdit& line) {
  swatch_ = line.addAction(QIcon(), QLineEdit::LeadingPosition);
  connect(swatch_, &QAction::triggered, this, [this, at, &line] {
    const QColor chosen = QColorDialog::getColor(QColor(line.text()), this);
    if (!chosen.isValid())
      return;
    rows_[at].row->setValue(chosen.name().toUpper().toStdString());
    change(at);
  });
}

void ItemForm::change(std::size_t at) {
  const Row& row = rows_[at];
  try {
    row.field.set(item_, row.row->value());
  } catch (const base::Error& error) {
    row.row->setProblem(language::words(error.whole()));
    return;
  }
  mark();
  emit edited(item_);
}

void ItemForm::setProblem(const std::optional<process::FieldProblem>& problem) {
  for (const Row& row : rows_)
    row.row->setProblem(problem && problem->key == row.field.spec.key
                            ? language::words(problem->reason)
                            : QString());
}

QString ItemForm::labelOf(const std::string& key) const {
  for (const Row& row : rows_)
    if (row.field.spec.key == key)
      return language::heading(row.field.spec.label);
  return {};
}

int ItemForm::changedFields() const {
  return static_cast<int>(
      std::ranges::count_if(rows_, [](const Row& row) { return row.row->isChanged(); }));
}

void ItemForm::mark() {
  if (const auto* material = std::get_if<process::Material>(&item_.data); material && swatch_)
    swatch_->setIcon(swatchOf(QString::fromStdString(material->colour), fontMetrics().height()));
  for (const Group& group : groups_)
    group.fold->setMarked(std::ranges::any_of(rows_, [&](const Row& row) {
      return row.field.spec.group == group.name && row.row->isChanged();
    }));
}

void ItemForm::retranslate() {
  for (const Group& group : groups_)
    group.fold->setTitle(language::heading(group.name));
  for (const Row& row : rows_) {
    row.row->retranslate();
    if (row.field.spec.key == kColour && swatch_)
      swatch_->setToolTip(tr("Choose a colour"));
    if (row.field.spec.type == base::ParameterType::Choice)
      nameMaterials(*static_cast<QComboBox*>(row.row->editor()), row.field.spec.choices);
  }
}

void ItemForm::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    retranslate();
  QWidget::changeEvent(event);
}

} // namespace voluta::panels
