#include "panels/compare_panel.h"

#include "forms/discard.h"
#include "forms/fold.h"
#include "forms/platform_editor.h"
#include "forms/value_boxes.h"

#include <QCheckBox>
#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QShortcut>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

namespace voluta::panels {

namespace {
constexpr double kLargestWeight = 100.0;
constexpr int kShownPlatforms = 3;
// Contact area, and extensions of it: the sources compare three sizes.
constexpr double kOfferedMarginsMm[] = {0.0, 20.0, 60.0};

QLabel* title(QWidget* parent) {
  auto* label = new QLabel(parent);
  QFont bold = label->font();
  bold.setBold(true);
  label->setFont(bold);
  return label;
}
} // namespace

ComparePanel::ComparePanel(QWidget* parent) : QWidget(parent) {
  modesTitle_ = title(this);
  growthsTitle_ = title(this);
  growthsTitle_->setWordWrap(true);
  platformsTitle_ = title(this);
  modesGrid_ = new QGridLayout;
  growthsGrid_ = new QGridLayout;

  platforms_ = new QListWidget(this);
  platforms_->setObjectName(QStringLiteral("platforms"));
  platforms_->setSpacing(2);
  for (const double margin : kOfferedMarginsMm)
    addPlatform(QString::fromStdString(project::Platform::madeForPart(margin).text()), false);
  connect(platforms_, &QListWidget::itemChanged, this, &ComparePanel::changed);
  auto* remove = new QShortcut(QKeySequence::Delete, platforms_, [this] {
    delete platforms_->currentItem();
    emit changed();
  });
  remove->setContext(Qt::WidgetShortcut);
  platform_ = new forms::PlatformEditor(this);
  add_ = new QPushButton(this);
  add_->setObjectName(QStringLiteral("addPlatform"));
  connect(add_, &QPushButton::clicked, this, [this] {
    addPlatform(platform_->text(), true);
    emit changed();
  });
  auto* adding = new QHBoxLayout;
  adding->addWidget(platform_, 1);
  adding->addWidget(add_, 0, Qt::AlignBottom);

  cells_ = new QListWidget(this);
  cells_->setObjectName(QStringLiteral("compareCells"));
  connect(cells_, &QListWidget::itemChanged, this, &ComparePanel::changed);
  cellsFold_ = new forms::Fold(cells_, this);
  cellsFold_->setOpen(false);

  untilTitle_ = new QLabel(this);
  untilTitle_->setWordWrap(true);
  until_ = forms::makeCombo(this);
  until_->setObjectName(QStringLiteral("until"));
  for (const project::Stage stage : {project::Stage::Replay, project::Stage::Decompose})
    until_->addItem(QString(), static_cast<int>(stage));
  connect(until_, &QComboBox::currentIndexChanged, this, &ComparePanel::changed);
  auto* far = new QHBoxLayout;
  far->addWidget(untilTitle_);
  far->addWidget(until_, 1);

  count_ = new QLabel(this);
  count_->setObjectName(QStringLiteral("count"));
  count_->setWordWrap(true);
  run_ = new QPushButton(this);
  run_->setObjectName(QStringLiteral("runCompare"));
  cancel_ = new QPushButton(this);
  cancel_->setObjectName(QStringLiteral("cancelCompare"));
  connect(run_, &QPushButton::clicked, this, &ComparePanel::runAsked);
  connect(cancel_, &QPushButton::clicked, this, &ComparePanel::cancelAsked);
  auto* running = new QHBoxLayout;
  running->addStretch(1);
  running->addWidget(run_);
  running->addWidget(cancel_);

  auto* weighed = new QWidget(this);
  auto* grid = new QGridLayout(weighed);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(4);
  grid->setColumnStretch(0, 1);
  rule_ = new QLabel(weighed);
  rule_->setWordWrap(true);
  grid->addWidget(rule_, 0, 0, 1, 2);
  int line = 1;
  for (const pipeline::Figure& figure : pipeline::figures()) {
    auto* name = new QLabel(weighed);
    name->setWordWrap(true);
    auto* box = new forms::NumberBox(weighed);
    box->setObjectName(
        QStringLiteral("weight_") +
        QString::fromUtf8(figure.key.data(), static_cast<qsizetype>(figure.key.size())));
    box->setRange(0.0, kLargestWeight);
    box->setDecimals(2);
    box->setSingleStep(0.5);
    box->setMinimumWidth(fontMetrics().averageCharWidth() * 11);
    name->setBuddy(box);
    connect(box, &QDoubleSpinBox::valueChanged, this, &ComparePanel::weightsChanged);
    grid->addWidget(name, line, 0);
    grid->addWidget(box, line, 1);
    weightNames_.push_back(name);
    weights_.push_back(box);
    ++line;
  }
  reset_ = new QPushButton(weighed);
  reset_->setObjectName(QStringLiteral("resetWeights"));
  connect(reset_, &QPushButton::clicked, this, [this] {
    setWeights(pipeline::defaultWeights());
    emit weightsChanged();
  });
  grid->addWidget(reset_, line, 1);
  counts_ = new forms::Fold(weighed, this);
  setWeights(pipeline::defaultWeights());

  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(10, 10, 10, 10);
  column->setSpacing(6);
  const auto section = [&](QLabel* heading, QGridLayout* ticks) {
    ticks->setSpacing(4);
    column->addWidget(heading);
    column->addLayout(ticks);
    column->addSpacing(6);
  };
  section(modesTitle_, modesGrid_);
  section(growthsTitle_, growthsGrid_);
  column->addWidget(platformsTitle_);
  column->addWidget(platforms_);
  column->addLayout(adding);
  column->addWidget(cellsFold_);
  column->addSpacing(6);
  column->addLayout(far);
  column->addWidget(count_);
  column->addLayout(running);
  column->addSpacing(6);
  column->addWidget(counts_);
  column->addStretch(1);
  retranslate();
}

void ComparePanel::fill(std::vector<Tick>& ticks, QGridLayout* grid,
                        const std::vector<forms::ChoiceItem>& items, const char* prefix, bool all) {
  const auto wasTicked = [&](const std::string& id) {
    for (const Tick& tick : ticks)
      if (tick.id == id)
        return tick.box->isChecked();
    return all || (ticks.empty() && id == items.front().id.toStdString());
  };
  std::vector<Tick> made;
  for (const forms::ChoiceItem& item : items) {
    auto* box = new QCheckBox(item.label, this);
    box->setObjectName(QLatin1String(prefix) + item.id);
    box->setToolTip(item.help);
    box->setChecked(wasTicked(item.id.toStdString()));
    connect(box, &QCheckBox::toggled, this, &ComparePanel::changed);
    grid->addWidget(box, static_cast<int>(made.size()), 0);
    made.push_back({item.id.toStdString(), box});
  }
  for (const Tick& tick : ticks)
    forms::discard(tick.box);
  ticks = std::move(made);
}

void ComparePanel::setLists(const std::vector<forms::ChoiceItem>& modes,
                            const std::vector<forms::ChoiceItem>& growths) {
  fill(modes_, modesGrid_, modes, "compareMode_", true);
  fill(growths_, growthsGrid_, growths, "compareGrowth_", false);
}

void ComparePanel::setFigures(const std::vector<QString>& labels) {
  for (std::size_t i = 0; i < weightNames_.size() && i < labels.size(); ++i) {
    QString label = labels[i];
    weightNames_[i]->setText(label.replace('\n', ' '));
    weights_[i]->setAccessibleName(label);
  }
}

void ComparePanel::addPlatform(const QString& platform, bool ticked) {
  const QSignalBlocker quiet(platforms_);
  for (int i = 0; i < platforms_->count(); ++i)
    if (QListWidgetItem* there = platforms_->item(i);
        there->data(Qt::UserRole).toString() == platform) {
      if (ticked)
        there->setCheckState(Qt::Checked);
      return;
    }
  auto* item = new QListWidgetItem(platforms_);
  item->setData(Qt::UserRole, platform);
  item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
  item->setCheckState(ticked ? Qt::Checked : Qt::Unchecked);
  showPlatforms();
  const int line = platforms_->sizeHintForRow(0) + 2 * platforms_->spacing();
  platforms_->setFixedHeight(std::clamp(platforms_->count(), kShownPlatforms, 6) * line +
                             2 * platforms_->frameWidth());
}

void ComparePanel::setPlatformTexts(std::function<QString(const QString&)> text) {
  platformText_ = std::move(text);
  showPlatforms();
}

void ComparePanel::showPlatforms() {
  const QSignalBlocker quiet(platforms_);
  for (int i = 0; i < platforms_->count(); ++i) {
    const QString platform = platforms_->item(i)->data(Qt::UserRole).toString();
    platforms_->item(i)->setText(platformText_ ? platformText_(platform) : platform);
  }
}

void ComparePanel::setPlatform(const QString& platform) {
  addPlatform(platform, platforms().empty());
}

void ComparePanel::setCells(const std::vector<forms::ChoiceItem>& cells) {
  const std::vector<std::string> ticked = this->cells();
  const QSignalBlocker quiet(cells_);
  cells_->clear();
  for (const forms::ChoiceItem& cell : cells) {
    auto* item = new QListWidgetItem(cell.label, cells_);
    item->setData(Qt::UserRole, cell.id);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    const bool was = std::find(ticked.begin(), ticked.end(), cell.id.toStdString()) != ticked.end();
    item->setCheckState(was ? Qt::Checked : Qt::Unchecked);
  }
}

std::vector<std::string> ComparePanel::cells() const {
  std::vector<std::string> ids;
  for (int i = 0; i < cells_->count(); ++i)
    if (cells_->item(i)->checkState() == Qt::Checked)
      ids.push_back(cells_->item(i)->data(Qt::UserRole).toString().toStdString());
  return ids;
}

std::vector<std::string> ComparePanel::modes() const {
  std::vector<std::string> ids;
  for (const Tick& tick : modes_)
    if (tick.box->isChecked())
      ids.push_back(tick.id);
  return ids;
}

std::vector<curved::GrowthScheme> ComparePanel::growths() const {
  std::vector<curved::GrowthScheme> schemes;
  for (const Tick& tick : growths_)
    if (tick.box->isChecked())
      schemes.emplace_back(tick.id);
  return schemes;
}

std::vector<project::Platform> ComparePanel::platforms() const {
  std::vector<project::Platform> platforms;
  for (int i = 0; i < platforms_->count(); ++i)
    if (platforms_->item(i)->checkState() == Qt::Checked)
      platforms.emplace_back(platforms_->item(i)->data(Qt::UserRole).toString().toStdString());
  return platforms;
}

project::Stage ComparePanel::until() const {
  return static_cast<project::Stage>(until_->currentData().toInt());
}

void ComparePanel::setCount(int count) {
  rows_ = count;
  showCount();
}

void ComparePanel::setState(bool part, bool running) {
  part_ = part;
  running_ = running;
  showCount();
}

void ComparePanel::showCount() {
  count_->setText(!part_       ? tr("Open a part first.")
                  : rows_ == 0 ? tr("Select what to compare.")
                               : tr("Plans: %1").arg(rows_));
  run_->setEnabled(part_ && rows_ > 0 && !running_);
  cancel_->setEnabled(running_);
}

void ComparePanel::setWeights(const pipeline::Weights& weights) {
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    const QSignalBlocker quiet(weights_[i]);
    const auto set = weights.find(pipeline::figures()[i].key);
    weights_[i]->setValue(set == weights.end() ? pipeline::figures()[i].weight : set->second);
  }
}

pipeline::Weights ComparePanel::weights() const {
  pipeline::Weights weights;
  for (std::size_t i = 0; i < weights_.size(); ++i)
    weights.emplace(pipeline::figures()[i].key, weights_[i]->value());
  return weights;
}

void ComparePanel::retranslate() {
  modesTitle_->setText(tr("Ways of building"));
  growthsTitle_->setText(tr("Growth of curved layers"));
  platformsTitle_->setText(tr("Platforms"));
  platforms_->setToolTip(tr("Delete removes the selected one from the list"));
  platforms_->setAccessibleName(tr("Platforms"));
  cellsFold_->setTitle(tr("Cells"));
  cells_->setAccessibleName(tr("Cells"));
  cells_->setToolTip(tr("Compares these cells; none selected: the job's own"));
  add_->setText(tr("Add"));
  add_->setToolTip(tr("Also compare with this platform"));
  untilTitle_->setText(tr("Plan up to"));
  until_->setItemText(0, tr("verified programs"));
  until_->setItemText(1, tr("missed voxels and pieces"));
  until_->setAccessibleName(tr("Plan up to"));
  run_->setText(tr("Compare"));
  run_->setToolTip(tr("Plans them one after the other, in the background"));
  cancel_->setText(tr("Cancel"));
  cancel_->setToolTip(tr("Stops; completed rows are kept"));
  counts_->setTitle(tr("Weights"));
  rule_->setText(tr("Ways without blocking findings rank first, then the lowest score: each "
                    "figure as a share of the column's largest, times its weight."));
  reset_->setText(tr("Reset"));
  reset_->setToolTip(tr("Restore the default weights"));
  showPlatforms();
  showCount();
}

void ComparePanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    retranslate();
  QWidget::changeEvent(event);
}

} // namespace voluta::panels
