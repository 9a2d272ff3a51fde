#include "forms/parameter_form.h"

#include "base/error.h"
#include "forms/fold.h"
#include "forms/icons.h"
#include "forms/parameter_row.h"
#include "language/parameter_texts.h"
#include "language/words.h"

#include <QButtonGroup>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

namespace voluta::forms {

ParameterForm::ParameterForm(base::ParameterTable table, QWidget* parent)
    : QWidget(parent), table_(std::move(table)) {
  build();
  showSwitch();
  retranslate();
  filter();
}

ParameterForm::~ParameterForm() = default;

void ParameterForm::build() {
  search_ = new QLineEdit(this);
  search_->setObjectName(QStringLiteral("search"));
  search_->setClearButtonEnabled(true);
  connect(search_, &QLineEdit::textChanged, this, &ParameterForm::filter);

  const auto switchButton = [this](const char* name) {
    auto* button = new QToolButton(this);
    button->setObjectName(QLatin1String(name));
    button->setCheckable(true);
    return button;
  };
  simple_ = switchButton("simple");
  all_ = switchButton("all");
  auto* either = new QButtonGroup(this);
  either->addButton(simple_);
  either->addButton(all_);
  simple_->setChecked(true);
  connect(all_, &QToolButton::toggled, this, &ParameterForm::setShowAll);

  resetAll_ = new QToolButton(this);
  resetAll_->setObjectName(QStringLiteral("resetAll"));
  resetAll_->setIcon(icon(Icon::Reset));
  resetAll_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  resetAll_->setAutoRaise(true);
  connect(resetAll_, &QToolButton::clicked, this, [this] {
    setValues({});
    emit resetAllRequested();
  });

  auto* content = new QWidget(this);
  column_ = new QVBoxLayout(content);
  column_->setContentsMargins(0, 0, 4, 4);
  column_->setSpacing(4);
  for (const base::ParameterSpec& spec : table_.specs()) {
    auto group = std::find_if(groups_.begin(), groups_.end(),
                              [&](const Group& g) { return g.name == spec.group; });
    if (group == groups_.end()) {
      auto* rows = new QWidget(content);
      auto* rowColumn = new QVBoxLayout(rows);
      rowColumn->setContentsMargins(0, 0, 0, 0);
      rowColumn->setSpacing(2);
      auto* fold = new Fold(rows, content);
      fold->setObjectName(QString::fromStdString(base::english(spec.group)));
      column_->addWidget(fold);
      groups_.push_back({spec.group, fold, {}});
      group = std::prev(groups_.end());
    }
    auto* row = new ParameterRow(spec, group->fold);
    group->rows.push_back(row);
    group->fold->contentLayout()->addWidget(row);
    connect(row, &ParameterRow::committed, this, [this](const QString& key, const QString& text) {
      mark();
      emit changed(key, text);
    });
    connect(row, &ParameterRow::resetRequested, this, [this](const QString& key) {
      mark();
      emit resetRequested(key);
    });
  }
  nothingFound_ = new QLabel(content);
  nothingFound_->setWordWrap(true);
  nothingFound_->setAlignment(Qt::AlignCenter);
  nothingFound_->hide();
  column_->addWidget(nothingFound_);
  column_->addStretch(1);

  scroll_ = new QScrollArea(this);
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setWidget(content);

  auto* bar = new QHBoxLayout;
  bar->setSpacing(0);
  bar->addWidget(simple_);
  bar->addWidget(all_);
  bar->addStretch(1);
  bar->addWidget(resetAll_);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(6, 6, 2, 2);
  all->setSpacing(6);
  all->addWidget(search_);
  all->addLayout(bar);
  all->addWidget(scroll_, 1);
  setFocusProxy(search_);
}

void ParameterForm::setHeader(QWidget* header) {
  column_->insertWidget(0, header);
}

void ParameterForm::setDefaults(const base::ParameterTable& table) {
  for (const Group& group : groups_)
    for (ParameterRow* row : group.rows)
      if (const base::ParameterSpec* spec = table.find(row->spec().key);
          spec && spec->defaultValue != row->spec().defaultValue)
        row->setDefault(spec->defaultValue);
  table_ = table;
}

void ParameterForm::setValues(const std::map<std::string, std::string>& changedTexts) {
  for (const Group& group : groups_)
    for (ParameterRow* row : group.rows) {
      const base::ParameterSpec& spec = row->spec();
      base::ParameterValue value = spec.defaultValue;
      if (const auto found = changedTexts.find(spec.key); found != changedTexts.end()) {
        try {
          value = base::parseParameter(spec, found->second);
        } catch (const base::Error&) {
          continue;
        }
      }
      if (value != row->value())
        row->setValue(value);
    }
  mark();
  filter();
}

void ParameterForm::setProblems(const std::map<std::string, std::string>& byKey) {
  for (const Group& group : groups_)
    for (ParameterRow* row : group.rows) {
      const auto found = byKey.find(row->spec().key);
      row->setProblem(found == byKey.end() ? QString() : QString::fromStdString(found->second));
    }
  filter();
}

void ParameterForm::setApplying(const std::set<std::string>& keys) {
  if (applying_ == keys)
    return;
  applying_ = keys;
  filter();
  mark();
}

void ParameterForm::setShowAll(bool all) {
  if (all == showsAll_)
    return;
  showsAll_ = all;
  (all ? all_ : simple_)->setChecked(true);
  showSwitch();
  filter();
}

void ParameterForm::showSwitch() {
  // Pressed and raised buttons are hard to distinguish in a dark palette.
  for (QToolButton* button : {simple_, all_}) {
    QFont font = button->font();
    font.setBold(button->isChecked());
    button->setFont(font);
  }
}

void ParameterForm::filter() {
  const QStringList words = search_->text().split(QChar(' '), Qt::SkipEmptyParts);
  bool any = false;
  for (const Group& group : groups_) {
    bool anyInGroup = false;
    for (ParameterRow* row : group.rows) {
      const bool wanted =
          words.isEmpty() ? showsAll_ || row->spec().simple || row->isChanged() || row->hasProblem()
                          : row->matches(words);
      const bool shown = wanted && applies(row->spec().key);
      row->setVisible(shown);
      row->highlight(words);
      anyInGroup = anyInGroup || shown;
    }
    group.fold->setVisible(anyInGroup);
    if (anyInGroup && !words.isEmpty())
      group.fold->setOpen(true);
    any = any || anyInGroup;
  }
  nothingFound_->setVisible(!any);
}

void ParameterForm::mark() {
  bool any = false;
  for (const Group& group : groups_) {
    const auto changed = [](const ParameterRow* row) { return row->isChanged(); };
    group.fold->setMarked(
        std::any_of(group.rows.begin(), group.rows.end(), [&](const ParameterRow* row) {
          return row->isChanged() && applies(row->spec().key);
        }));
    any = any || std::any_of(group.rows.begin(), group.rows.end(), changed);
  }
  resetAll_->setEnabled(any);
}

void ParameterForm::retranslate() {
  search_->setPlaceholderText(tr("Search parameters"));
  simple_->setText(tr("Simple"));
  simple_->setToolTip(tr("Show the most important and the changed parameters"));
  all_->setText(tr("All"));
  all_->setToolTip(tr("Show every parameter"));
  resetAll_->setText(tr("Reset all"));
  resetAll_->setToolTip(tr("Reset every parameter to its default"));
  nothingFound_->setText(tr("No matching parameter."));
  for (const Group& group : groups_) {
    group.fold->setTitle(language::heading(group.name));
    for (ParameterRow* row : group.rows)
      row->retranslate();
  }
  mark();
}

void ParameterForm::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange)
    retranslate();
  QWidget::changeEvent(event);
}

} // namespace voluta::forms
