#include "forms/parameter_row.h"

#include "base/error.h"
#include "forms/colours.h"
#include "forms/icons.h"
#include "forms/value_boxes.h"
#include "language/parameter_texts.h"
#include "language/setting_words.h"
#include "language/translated.h"
#include "language/words.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <limits>

namespace voluta::forms {

namespace {
constexpr int kMaxChoiceLetters = 22;
constexpr int kSpacing = 4;            // [px] between the widgets of a row
constexpr double kProblemShare = 0.22; // Share of the mark's colour in a field that has a problem

// Returns the width of a combo box that shows each of its entries whole.
int widestText(const QComboBox& combo) {
  constexpr int kBesideText = 34; // [px] arrow and frame
  int widest = 0;
  for (int i = 0; i < combo.count(); ++i)
    widest = std::max(widest, combo.fontMetrics().horizontalAdvance(combo.itemText(i)));
  return widest + kBesideText;
}

int clampToInt(double value) {
  return static_cast<int>(std::clamp(value, double(std::numeric_limits<int>::min()),
                                     double(std::numeric_limits<int>::max())));
}

// Returns for each character whether it belongs to one of the words, wherever they occur.
std::vector<bool> matchedLetters(const QString& text, const QStringList& words) {
  std::vector<bool> matched(static_cast<std::size_t>(text.size()), false);
  for (const QString& word : words)
    for (qsizetype at = text.indexOf(word, 0, Qt::CaseInsensitive); at >= 0;
         at = text.indexOf(word, at + 1, Qt::CaseInsensitive))
      std::fill_n(matched.begin() + at, word.size(), true);
  return matched;
}
} // namespace

ParameterRow::ParameterRow(const base::ParameterSpec& spec, QWidget* parent)
    : QWidget(parent), spec_(spec), value_(spec.defaultValue) {
  setObjectName(key());
  label_ = new QLabel(this);
  label_->setWordWrap(true);
  label_->setTextFormat(Qt::RichText);
  label_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  label_->setMinimumWidth(fontMetrics().averageCharWidth() * 12);

  buildEditor();
  editor_->setObjectName(QStringLiteral("editor"));
  label_->setBuddy(editor_);

  browse_ = new QToolButton(this);
  browse_->setObjectName(QStringLiteral("browse"));
  browse_->setText(QStringLiteral("…"));
  const bool takesFile = !spec_.file.patterns.empty();
  browse_->setVisible(takesFile);
  if (takesFile)
    editor_->setFixedWidth(editor_->minimumWidth() - browse_->sizeHint().width() - kSpacing);
  connect(browse_, &QToolButton::clicked, this, &ParameterRow::chooseFile);

  reset_ = new QToolButton(this);
  reset_->setObjectName(QStringLiteral("reset"));
  reset_->setIcon(icon(Icon::Reset));
  reset_->setAutoRaise(true);
  QSizePolicy keepsItsPlace = reset_->sizePolicy();
  keepsItsPlace.setRetainSizeWhenHidden(true);
  reset_->setSizePolicy(keepsItsPlace);
  connect(reset_, &QToolButton::clicked, this, [this] {
    setValue(spec_.defaultValue);
    emit resetRequested(key());
  });

  problem_ = new QWidget(this);
  problem_->hide();
  problemIcon_ = new QLabel(problem_);
  problemText_ = new QLabel(problem_);
  problemText_->setWordWrap(true);
  problemText_->setTextFormat(Qt::PlainText);
  auto* problemRow = new QHBoxLayout(problem_);
  problemRow->setContentsMargins(0, 0, 0, 2);
  problemRow->setSpacing(4);
  problemRow->addWidget(problemIcon_, 0, Qt::AlignTop);
  problemRow->addWidget(problemText_, 1);

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 1, 0, 1);
  column->setSpacing(0);
  auto* row = new QHBoxLayout;
  row->setSpacing(kSpacing);
  row->addWidget(label_, 1);
  row->addWidget(editor_, 0);
  row->addWidget(browse_, 0);
  row->addWidget(reset_, 0);
  column->addLayout(row);
  column->addWidget(problem_);
  retranslate();
  showValue();
}

void ParameterRow::buildEditor() {
  const int width = fontMetrics().averageCharWidth() * 16;
  switch (spec_.type) {
  case base::ParameterType::Number: {
    auto* box = new NumberBox(this);
    const double shown = language::shownFactor(spec_);
    box->setRange(shown * spec_.minimum, shown * spec_.maximum);
    box->setSingleStep(
        stepFor(shown * std::get<double>(spec_.defaultValue), shown * spec_.maximum));
    box->setUnit(language::unitText(spec_.unit));
    connect(box, &QDoubleSpinBox::valueChanged, this,
            [this, shown](double value) { commit(value / shown); });
    editor_ = box;
    break;
  }
  case base::ParameterType::Integer: {
    QSpinBox* box = makeIntegerBox(this);
    box->setRange(clampToInt(spec_.minimum), clampToInt(spec_.maximum));
    connect(box, &QSpinBox::valueChanged, this,
            [this](int value) { commit(static_cast<long long>(value)); });
    editor_ = box;
    break;
  }
  case base::ParameterType::Boolean: {
    auto* box = new QCheckBox(this);
    connect(box, &QCheckBox::toggled, this, [this](bool value) { commit(value); });
    editor_ = box;
    break;
  }
  case base::ParameterType::Choice: {
    QComboBox* combo = makeCombo(this);
    for (const base::Choice& choice : spec_.choices)
      combo->addItem(language::heading(choice.label), QString::fromStdString(choice.id));
    connect(combo, &QComboBox::activated, this,
            [this, combo] { commit(combo->currentData().toString().toStdString()); });
    editor_ = combo;
    break;
  }
  case base::ParameterType::Text: {
    auto* line = new QLineEdit(this);
    connect(line, &QLineEdit::editingFinished, this,
            [this, line] { commit(line->text().toStdString()); });
    editor_ = line;
    break;
  }
  }
  if (auto* combo = qobject_cast<QComboBox*>(editor_)) {
    // The words of a choice are read whole, as far as there is room.
    const int widest = fontMetrics().averageCharWidth() * kMaxChoiceLetters;
    combo->setMinimumContentsLength(kMaxChoiceLetters);
    combo->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    combo->setMinimumWidth(width);
    combo->setMaximumWidth(std::clamp(widestText(*combo), width, widest));
    return;
  }
  if (qobject_cast<QLineEdit*>(editor_) && spec_.file.patterns.empty()) {
    // Texts are longer than numbers.
    editor_->setMinimumWidth(width);
    editor_->setMaximumWidth(std::max(width, fontMetrics().averageCharWidth() * kMaxChoiceLetters));
    return;
  }
  editor_->setFixedWidth(width);
}

void ParameterRow::chooseFile() {
  const QString prefix = QString::fromStdString(spec_.file.prefix);
  QString now = QString::fromStdString(std::get<std::string>(value_));
  if (now.startsWith(prefix))
    now.remove(0, prefix.size());
  const QString chosen = QFileDialog::getOpenFileName(
      this, language::heading(spec_.label), QFileInfo(now).absolutePath(),
      tr("Files (%1)").arg(QString::fromStdString(spec_.file.patterns)) + QStringLiteral(";;") +
          tr("All files (*)"));
  if (chosen.isEmpty())
    return;
  const base::ParameterValue value = (prefix + chosen).toStdString();
  commit(value);
  showValue();
}

void ParameterRow::setValue(const base::ParameterValue& value) {
  value_ = value;
  showValue();
}

void ParameterRow::commit(const base::ParameterValue& value) {
  if (value == value_)
    return;
  value_ = value;
  showLabel();
  emit committed(key(), QString::fromStdString(base::formatParameter(value)));
}

void ParameterRow::setDefault(const base::ParameterValue& value) {
  spec_.defaultValue = value;
  retranslate();
}

bool ParameterRow::isChanged() const {
  return value_ != spec_.defaultValue;
}

void ParameterRow::showValue() {
  const QSignalBlocker quiet(editor_);
  switch (spec_.type) {
  case base::ParameterType::Number:
    static_cast<NumberBox*>(editor_)->setValue(language::shownFactor(spec_) *
                                               std::get<double>(value_));
    break;
  case base::ParameterType::Integer:
    static_cast<QSpinBox*>(editor_)->setValue(
        clampToInt(static_cast<double>(std::get<long long>(value_))));
    break;
  case base::ParameterType::Boolean:
    static_cast<QCheckBox*>(editor_)->setChecked(std::get<bool>(value_));
    break;
  case base::ParameterType::Choice: {
    auto* combo = static_cast<QComboBox*>(editor_);
    combo->setCurrentIndex(combo->findData(QString::fromStdString(std::get<std::string>(value_))));
    break;
  }
  case base::ParameterType::Text:
    static_cast<QLineEdit*>(editor_)->setText(
        QString::fromStdString(std::get<std::string>(value_)));
    static_cast<QLineEdit*>(editor_)->setCursorPosition(0);
    break;
  }
  showLabel();
}

void ParameterRow::setProblem(const QString& problem) {
  problemIcon_->setPixmap(iconBeside(*this, Icon::Blocked));
  problemText_->setText(problem);
  problem_->setVisible(!problem.isEmpty());
  editor_->setAccessibleDescription(problem);
  QPalette marked;
  if (!problem.isEmpty())
    marked.setColor(QPalette::Base, mixed(palette().color(QPalette::Base), blockedColour(palette()),
                                          kProblemShare));
  editor_->setPalette(marked);
}

bool ParameterRow::hasProblem() const {
  return !problemText_->text().isEmpty();
}

bool ParameterRow::matches(const QStringList& words) const {
  const QString all = language::heading(spec_.label) + QChar(' ') + key() + QChar(' ') +
                      language::heading(spec_.group) + QChar(' ') + language::heading(spec_.help) +
                      QChar(' ') + language::synonyms(spec_.key);
  return std::all_of(words.begin(), words.end(),
                     [&](const QString& word) { return all.contains(word, Qt::CaseInsensitive); });
}

void ParameterRow::highlight(const QStringList& words) {
  words_ = words;
  showLabel();
}

void ParameterRow::showLabel() {
  const QString text = language::heading(spec_.label);
  const std::vector<bool> matched = matchedLetters(text, words_);
  const QString mark =
      QStringLiteral("<span style=\"background-color:%1\">").arg(matchColour(palette()).name());
  QString html;
  bool inside = false;
  for (qsizetype i = 0; i < text.size(); ++i) {
    if (const bool now = matched[static_cast<std::size_t>(i)]; now != inside) {
      html += now ? mark : QStringLiteral("</span>");
      inside = now;
    }
    html += QString(text[i]).toHtmlEscaped();
  }
  if (inside)
    html += QStringLiteral("</span>");
  label_->setText(isChanged() ? QStringLiteral("<b>• %1</b>").arg(html) : html);
  if (reset_)
    reset_->setVisible(isChanged());
}

void ParameterRow::retranslate() {
  showLabel();
  const QString tip = language::parameterToolTip(spec_);
  label_->setToolTip(tip);
  editor_->setToolTip(tip);
  editor_->setAccessibleName(language::heading(spec_.label));
  const QString zero = language::capitalized(language::zeroText(spec_.key));
  if (auto* box = qobject_cast<QDoubleSpinBox*>(editor_); box && !zero.isEmpty())
    box->setSpecialValueText(zero);
  else if (auto* whole = qobject_cast<QSpinBox*>(editor_); whole && !zero.isEmpty())
    whole->setSpecialValueText(zero);
  browse_->setToolTip(tr("Choose a file"));
  browse_->setAccessibleName(tr("Choose a file"));
  reset_->setToolTip(tr("Reset to %1").arg(language::valueText(spec_, spec_.defaultValue)));
  if (auto* combo = qobject_cast<QComboBox*>(editor_))
    for (int i = 0; i < combo->count(); ++i)
      combo->setItemText(i, language::heading(spec_.choices[static_cast<std::size_t>(i)].label));
}

} // namespace voluta::forms
