#include "forms/choices_form.h"

#include "base/data_files.h"
#include "forms/choice_combo.h"
#include "forms/icons.h"
#include "forms/platform_editor.h"
#include "forms/value_boxes.h"
#include "language/setting_words.h"

#include <QColor>
#include <QComboBox>
#include <QDir>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPixmap>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <algorithm>
#include <initializer_list>
#include <limits>
#include <utility>

namespace voluta::forms {

ChoicesForm::ChoicesForm(QWidget* parent) : QWidget(parent) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(12, 2, 4, 6);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(4);
  grid->setColumnStretch(1, 1);
  addCombo(mode_, QStringLiteral("mode"), *grid, 0);
  addCombo(cell_, QStringLiteral("cell"), *grid, 3);
  addCombo(process_, QStringLiteral("process"), *grid, 4);
  addCombo(material_, QStringLiteral("material"), *grid, 5);
  research_ = new QWidget(this);
  auto* research = new QGridLayout(research_);
  research->setContentsMargins(12, 1, 4, 1);
  research->setHorizontalSpacing(8);
  research->setVerticalSpacing(4);
  research->setColumnStretch(1, 1);
  addCombo(growth_, QStringLiteral("growth"), *research, 0);
  addLibrary(process_, QStringLiteral("process"), 4);
  addLibrary(material_, QStringLiteral("material"), 5);
  materialFacts_ = new QLabel(this);
  materialFacts_->setObjectName(QStringLiteral("materialFacts"));
  materialFacts_->setWordWrap(true);
  grid->addWidget(materialFacts_, 6, 1, 1, 2);

  platformLabel_ = new QLabel(this);
  platform_ = new PlatformEditor(this);
  platform_->setObjectName(QStringLiteral("platform"));
  // Aligned with the first line of its editor, which may have several.
  platformLabel_->setMinimumHeight(mode_.combo->sizeHint().height());
  grid->addWidget(platformLabel_, 2, 0, Qt::AlignTop);
  grid->addWidget(platform_, 2, 1, 1, 2);
  platformLabel_->setBuddy(platform_);
  connect(platform_, &PlatformEditor::changed, this,
          [this](const QString& text) { emit changed(QStringLiteral("platform"), text); });

  connect(platform_, &PlatformEditor::profileChanged, this, &ChoicesForm::rodProfileChanged);

  seedLabel_ = new QLabel(this);
  seed_ = makeIntegerBox(this);
  seed_->setObjectName(QStringLiteral("seed"));
  seed_->setRange(0, std::numeric_limits<int>::max());
  seed_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  seedLabel_->setBuddy(seed_);
  tools_ = new ToolRows(this);
  grid->addWidget(tools_, 7, 0, 1, 3);
  research->addWidget(seedLabel_, 1, 0);
  research->addWidget(seed_, 1, 1, 1, 2);
  grid->addWidget(research_, 8, 0, 1, 3);
  connect(seed_, &QSpinBox::valueChanged, this,
          [this](int value) { emit changed(QStringLiteral("seed"), QString::number(value)); });

  noticeRow_ = new QWidget(this);
  auto* noticeLine = new QHBoxLayout(noticeRow_);
  noticeLine->setContentsMargins(0, 4, 0, 0);
  noticeIcon_ = new QLabel(noticeRow_);
  notice_ = new QLabel(noticeRow_);
  notice_->setObjectName(QStringLiteral("notice"));
  notice_->setWordWrap(true);
  notice_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  noticeLine->addWidget(noticeIcon_, 0, Qt::AlignTop);
  noticeLine->addWidget(notice_, 1);
  noticeButton_ = new QPushButton(this);
  noticeButton_->setObjectName(QStringLiteral("noticeButton"));
  grid->addWidget(noticeRow_, 9, 0, 1, 3);
  grid->addWidget(noticeButton_, 10, 0, 1, 3);
  connect(noticeButton_, &QPushButton::clicked, this, &ChoicesForm::noticePressed);
  setNotice({}, {}, false);
  retranslate();
}

void ChoicesForm::setNotice(const QString& line, const QString& button, bool blocking) {
  notice_->setText(line);
  const int side = fontMetrics().height();
  noticeIcon_->setPixmap(blocking ? icon(Icon::Blocked).pixmap(side, side) : QPixmap());
  noticeIcon_->setVisible(blocking);
  noticeRow_->setVisible(!line.isEmpty());
  noticeButton_->setText(button);
  noticeButton_->setVisible(!button.isEmpty());
}

void ChoicesForm::setGrows(bool grows) {
  grows_ = grows;
  growth_.label->setVisible(grows);
  growth_.combo->setVisible(grows);
}

void ChoicesForm::choosePlatformFile() {
  platform_->chooseFile();
}

namespace {
bool matches(const QLabel* label, const QWidget* field, const char* key, const QStringList& words) {
  const QString all = label->text() + QChar(' ') + language::synonyms(key) + QChar(' ') +
                      field->toolTip() + QChar(' ') + QLatin1String(key);
  return std::ranges::all_of(
      words, [&](const QString& word) { return all.contains(word, Qt::CaseInsensitive); });
}
} // namespace

bool ChoicesForm::showMatching(const QStringList& words) {
  bool any = false;
  const auto show = [&](bool on, std::initializer_list<QWidget*> widgets) {
    for (QWidget* widget : widgets)
      widget->setVisible(on);
    any = any || on;
  };
  for (const auto& [row, key] : {std::pair(&mode_, "mode"), {&cell_, "cell"}})
    show(matches(row->label, row->combo, key, words), {row->label, row->combo});
  show(matches(platformLabel_, platform_, "platform", words), {platformLabel_, platform_});
  show(matches(process_.label, process_.combo, "process", words),
       {process_.label, process_.combo, process_.library});
  const bool material = matches(material_.label, material_.combo, "material", words);
  show(material, {material_.label, material_.combo, material_.library});
  materialFacts_->setVisible(material && !materialFacts_->text().isEmpty());
  show(matches(process_.label, tools_, "tools", words), {tools_});
  noticeRow_->setVisible(words.isEmpty() && !notice_->text().isEmpty());
  noticeButton_->setVisible(words.isEmpty() && !noticeButton_->text().isEmpty());
  return any;
}

bool ChoicesForm::showMatchingResearch(const QStringList& words) {
  const bool growth = grows_ && matches(growth_.label, growth_.combo, "growth", words);
  const bool seed = matches(seedLabel_, seed_, "seed", words);
  growth_.label->setVisible(growth);
  growth_.combo->setVisible(growth);
  seedLabel_->setVisible(seed);
  seed_->setVisible(seed);
  research_->setVisible(growth || seed);
  return growth || seed;
}

void ChoicesForm::addCombo(Row& row, const QString& field, QGridLayout& grid, int at) {
  row.label = new QLabel(this);
  row.combo = makeCombo(this);
  row.combo->setObjectName(field);
  row.label->setBuddy(row.combo);
  grid.addWidget(row.label, at, 0);
  grid.addWidget(row.combo, at, 1, 1, 2);
  connect(row.combo, &QComboBox::currentIndexChanged, this, [this, field, &row] {
    showTip(row);
    emit changed(field, row.combo->currentData().toString());
  });
}

void ChoicesForm::addLibrary(Row& row, const QString& field, int at) {
  row.library = new QToolButton(this);
  row.library->setObjectName(field + QStringLiteral("Library"));
  row.library->setText(QStringLiteral("…"));
  auto* grid = static_cast<QGridLayout*>(layout());
  grid->addWidget(row.combo, at, 1);
  grid->addWidget(row.library, at, 2);
  connect(row.library, &QToolButton::clicked, this,
          [this, field] { emit libraryRequested(field); });
}

void ChoicesForm::showTip(const Row& row) {
  const QString help = row.combo->currentData(Qt::ToolTipRole).toString();
  row.combo->setToolTip(help.isEmpty()      ? row.tip
                        : row.tip.isEmpty() ? help
                                            : help + QChar('\n') + row.tip);
}

void ChoicesForm::setLists(const ChoiceLists& lists) {
  fillCombo(mode_.combo, lists.modes);
  fillCombo(growth_.combo, lists.growths);
  fillCombo(cell_.combo, lists.cells);
  fillCombo(process_.combo, lists.processes);
  fillCombo(material_.combo, lists.materials);
  tools_->setLists(lists.processes, lists.materials);
  platforms_ = lists.platforms;
}

void ChoicesForm::setTexts(const ChoiceTexts& texts) {
  chooseId(mode_.combo, texts.mode);
  chooseId(growth_.combo, texts.growth);
  chooseId(cell_.combo, texts.cell, texts.cellLabel);
  chooseId(process_.combo, texts.process, texts.processLabel);
  showMaterial(texts);
  tools_->setTools(texts.moreTools);
  for (const Row* row : {&mode_, &growth_, &cell_, &process_, &material_})
    showTip(*row);
  if (const auto at = platforms_.find(texts.mode); at != platforms_.end())
    platform_->setUses(at->second);
  platform_->setText(texts.platform);
  platform_->setProfile(texts.rod);
  const QSignalBlocker quiet(seed_);
  seed_->setValue(texts.seed);
}

void ChoicesForm::showMaterial(const ChoiceTexts& texts) {
  chooseId(material_.combo, texts.material);
  materialFacts_->setText(texts.materialFacts);
  materialFacts_->setVisible(!texts.materialFacts.isEmpty());
  const int at = material_.combo->currentIndex();
  if (const QColor colour(texts.materialColour); at >= 0 && colour.isValid()) {
    material_.combo->setItemIcon(at, swatchOf(colour, fontMetrics().height()));
  }
}

void ChoicesForm::retranslate() {
  mode_.label->setText(tr("Mode"));
  growth_.label->setText(tr("Growth scheme"));
  platformLabel_->setText(tr("Platform"));
  cell_.label->setText(tr("Cell"));
  process_.label->setText(tr("Process"));
  material_.label->setText(tr("Material"));
  const auto own = [](const char* folder) {
    return QDir::toNativeSeparators(
        QString::fromStdString((base::userDataFolder() / folder).string()));
  };
  mode_.tip = tr("How the part is divided into layers");
  cell_.tip = tr("Your own cells are JSON files in %1").arg(own("cells"));
  process_.tip = tr("Your own processes are JSON files in %1").arg(own("processes"));
  material_.tip = tr("Your own materials are JSON files in %1").arg(own("materials"));
  for (const Row* row : {&mode_, &growth_, &cell_, &process_, &material_})
    showTip(*row);
  process_.library->setToolTip(tr("Edit processes"));
  material_.library->setToolTip(tr("Edit materials"));
  for (const Row* row : {&process_, &material_})
    row->library->setAccessibleName(row->library->toolTip());
  seedLabel_->setText(tr("Seed"));
  seed_->setToolTip(
      tr("Another seed may find other travel paths; the same seed always gives the same result."));
}

void ChoicesForm::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    retranslate();
  QWidget::changeEvent(event);
}

} // namespace voluta::forms
