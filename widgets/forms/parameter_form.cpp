#include "forms/parameter_form.h"

#include "base/error.h"
#include "forms/fold.h"
#include "forms/icons.h"
#include "forms/parameter_row.h"
#include "forms/tab_order.h"
#include "language/parameter_texts.h"
#include "language/setting_words.h"
#include "language/words.h"

#include <QAbstractButton>
#include <QApplication>
#include <QButtonGroup>
#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

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
  search_->installEventFilter(this);
  connect(qApp, &QApplication::focusChanged, this, [this](QWidget* before, const QWidget* now) {
    if (now == search_)
      beforeSearch_ = before;
  });
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
  addRows();
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

ParameterForm::Group& ParameterForm::groupOf(Section section, base::Text name, QWidget* content) {
  const auto group = std::ranges::find_if(groups_, [&](const Group& g) {
    return g.section == section && (section != Section::Table || g.name == name);
  });
  if (group != groups_.end())
    return *group;
  auto* rows = new QWidget(content);
  auto* rowColumn = new QVBoxLayout(rows);
  rowColumn->setContentsMargins(0, 0, 0, 0);
  rowColumn->setSpacing(2);
  auto* fold = new Fold(rows, content);
  fold->setObjectName(section == Section::First      ? QStringLiteral("firstSettings")
                      : section == Section::Research ? QStringLiteral("research")
                                                     : QString::fromStdString(base::english(name)));
  fold->setOpen(section != Section::Research);
  column_->addWidget(fold);
  groups_.push_back({section, name, fold, {}});
  return groups_.back();
}

// The first settings in their order, the others in that of the table.
void ParameterForm::addRows() {
  QWidget* content = column_->parentWidget();
  const auto add = [&](const base::ParameterSpec& spec, Section section) {
    Group& group = groupOf(section, spec.group, content);
    auto* row = new ParameterRow(spec, group.fold);
    group.rows.push_back(row);
    group.fold->contentLayout()->addWidget(row);
    connect(row, &ParameterRow::committed, this, [this](const QString& key, const QString& text) {
      mark();
      emit changed(key, text);
    });
    connect(row, &ParameterRow::resetRequested, this, [this](const QString& key) {
      mark();
      emit resetRequested(key);
    });
  };
  const auto has = [](const std::vector<std::string>& keys, const std::string& key) {
    return std::ranges::find(keys, key) != keys.end();
  };
  const auto& first = language::firstSettings();
  const auto& research = language::researchSettings();
  for (const std::string& key : first)
    if (const base::ParameterSpec* spec = table_.find(key))
      add(*spec, Section::First);
  for (const base::ParameterSpec& spec : table_.specs())
    if (!has(first, spec.key) && !has(research, spec.key))
      add(spec, Section::Table);
  for (const base::ParameterSpec& spec : table_.specs())
    if (has(research, spec.key))
      add(spec, Section::Research);
}

void ParameterForm::setHeader(QWidget* header, Search search) {
  column_->insertWidget(0, header);
  searchHeader_ = std::move(search);
}

void ParameterForm::setResearch(QWidget* choices, Search search) {
  Group& group = groupOf(Section::Research, {}, column_->parentWidget());
  static_cast<QVBoxLayout*>(group.fold->contentLayout())->insertWidget(0, choices);
  searchResearch_ = std::move(search);
  retranslate();
  filter();
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

bool ParameterForm::offers(const ParameterRow& row) const {
  return applies(row.spec().key);
}

void ParameterForm::reveal(const QWidget& field) {
  search_->clear();
  for (const Group& group : groups_)
    for (const ParameterRow* row : group.rows)
      if (row->isAncestorOf(&field) && row->isHidden())
        setShowAll(true);
}

// The keys of commands do not work while the focus is in a field for typing.
void ParameterForm::leaveSearch(bool toFound) {
  QWidget* next = beforeSearch_ && beforeSearch_->isVisible() ? beforeSearch_.data() : window();
  if (!toFound)
    search_->clear();
  else if (!search_->text().isEmpty())
    for (QWidget* field : inReadingOrder(scroll_))
      if (field->isVisible() && !qobject_cast<QAbstractButton*>(field) && field != scroll_ &&
          !qobject_cast<QScrollBar*>(field)) {
        next = field;
        break;
      }
  next->setFocus(Qt::OtherFocusReason);
}

bool ParameterForm::eventFilter(QObject* watched, QEvent* event) {
  if (watched == search_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Escape || key == Qt::Key_Return || key == Qt::Key_Enter) {
      leaveSearch(key != Qt::Key_Escape);
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

void ParameterForm::showSwitch() {
  // Pressed and raised buttons are hard to distinguish in a dark palette.
  for (QToolButton* button : {simple_, all_}) {
    QFont font = button->font();
    font.setBold(button->isChecked());
    button->setFont(font);
  }
}

namespace {
bool anyProblem(const std::vector<ParameterRow*>& rows) {
  return std::ranges::any_of(rows, [](const ParameterRow* row) { return row->hasProblem(); });
}
} // namespace

void ParameterForm::filter() {
  const QStringList words = search_->text().split(QChar(' '), Qt::SkipEmptyParts);
  bool any = searchHeader_ && searchHeader_(words);
  const bool ended = std::exchange(isSearching_, !words.isEmpty()) && words.isEmpty();
  for (const Group& group : groups_) {
    const bool isFirst = group.section == Section::First;
    bool anyInGroup =
        group.section == Section::Research && searchResearch_ && searchResearch_(words);
    for (ParameterRow* row : group.rows) {
      const bool wanted = words.isEmpty() ? showsAll_ || isFirst || row->spec().simple ||
                                                row->isChanged() || row->hasProblem()
                                          : row->matches(words);
      const bool shown = wanted && applies(row->spec().key);
      row->setVisible(shown);
      row->highlight(words);
      anyInGroup = anyInGroup || shown;
    }
    group.fold->setVisible(anyInGroup);
    if (anyInGroup && (!words.isEmpty() || anyProblem(group.rows)))
      group.fold->setOpen(true);
    else if (ended && group.section == Section::Research)
      group.fold->setOpen(false);
    any = any || anyInGroup;
  }
  nothingFound_->setVisible(!any);
}

QString ParameterForm::titleOf(const Group& group) const {
  switch (group.section) {
  case Section::First:
    return tr("Print");
  case Section::Research:
    return tr("Research");
  case Section::Table:
    break;
  }
  return language::heading(group.name);
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
  search_->setPlaceholderText(tr("Search settings"));
  search_->setAccessibleName(search_->placeholderText());
  simple_->setText(tr("Simple"));
  simple_->setToolTip(tr("Show the most important and the changed parameters"));
  all_->setText(tr("All"));
  all_->setToolTip(tr("Show every parameter"));
  resetAll_->setText(tr("Reset all"));
  resetAll_->setToolTip(tr("Reset every parameter to its default"));
  nothingFound_->setText(tr("No matching parameter."));
  for (const Group& group : groups_) {
    group.fold->setTitle(titleOf(group));
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
