#include "panels/regions_panel.h"

#include "base/error.h"
#include "forms/choice_combo.h"
#include "forms/fold.h"
#include "forms/icons.h"
#include "forms/parameter_row.h"
#include "forms/value_boxes.h"
#include "language/words.h"
#include "panels/paint_form.h"
#include "panels/region_names.h"
#include "pipeline/stage_options.h"
#include "regions/region_uses.h"

#include <QAction>
#include <QComboBox>
#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStandardItemModel>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

namespace voluta::panels {

namespace {
using project::Region;
using regions::RegionKind;
using regions::RegionUse;
using regions::ShapeField;

constexpr int kDecimals = 3;
constexpr int kListLines = 6;
constexpr const char* kDensity = "infillDensity";

QString qString(std::string_view text) {
  return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

std::string textOf(std::string_view word, const std::vector<double>& numbers) {
  QStringList texts;
  for (const double number : numbers)
    texts << QString::number(number, 'g', 12);
  return std::string(word) + ':' + texts.join(',').toStdString();
}

std::vector<double> numbersOf(const RegionUse& use, const std::string& text) {
  return use.fields.empty() ? std::vector<double>{}
                            : regions::parsedNumbers(text, use.fields, formOf(use));
}

// Returns the shape of a region; nullopt: its text is invalid.
std::optional<regions::Shape> shapeOf(const Region& region) {
  try {
    return regions::parsedShape(region.shape);
  } catch (const base::Error&) {
    return std::nullopt;
  }
}

const RegionUse* useOf(const Region& region) {
  try {
    return &regions::findUse(region.use);
  } catch (const base::Error&) {
    return nullptr;
  }
}

std::size_t colourOf(const Region& region) {
  const RegionUse* use = useOf(region);
  if (!use)
    return 0;
  return use->hasLayers() ? 1 : use->cuts ? 2 : use->hasSettings() ? 0 : 3;
}

bool isSolid(const Region& region) { // unless its density is set
  const RegionUse* use = useOf(region);
  return use && (use->layers == regions::RegionLayers::Surface ||
                 use->layers == regions::RegionLayers::Around);
}

// The numbers that a use begins with.
std::string textOfNew(const RegionUse& use) {
  if (use.fields.empty())
    return std::string(use.id);
  if (use.layers == regions::RegionLayers::Turning) // the usual direction does not turn
    return textOf(use.id, {1.0, 0.0, 1.0});
  std::vector<double> usual;
  for (const ShapeField& field : use.fields)
    usual.push_back(field.usual.value_or(field.minimum));
  return textOf(use.id, usual);
}

bool isAngle(const ShapeField& field) {
  return field.name == "SLOPE";
}
} // namespace

RegionsPanel::RegionsPanel(QWidget* parent) : QWidget(parent) {
  build();
  retranslate();
}

void RegionsPanel::build() {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(6, 6, 6, 6);
  column->setSpacing(4);
  title_ = new QLabel(this);
  title_->setObjectName(QStringLiteral("regionsTitle"));
  title_->setTextFormat(Qt::PlainText);
  QFont bold = font();
  bold.setBold(true);
  title_->setFont(bold);
  title_->setWordWrap(true);
  column->addWidget(title_);
  buildList(*column);
  details_ = new QWidget(this);
  auto* inside = new QVBoxLayout(details_);
  inside->setContentsMargins(0, 0, 0, 0);
  inside->setSpacing(4);
  buildFields(*inside);
  column->addWidget(details_);
  icon_ = new QLabel(this);
  problem_ = new QLabel(this);
  problem_->setObjectName(QStringLiteral("regionProblem"));
  problem_->setTextFormat(Qt::PlainText);
  problem_->setWordWrap(true);
  auto* said = new QHBoxLayout;
  said->addWidget(icon_, 0, Qt::AlignTop);
  said->addWidget(problem_, 1);
  column->addLayout(said);
  buildSettings(*column);
  close_ = new QPushButton(this);
  close_->setObjectName(QStringLiteral("regionsClose"));
  connect(close_, &QPushButton::clicked, this, &RegionsPanel::closeRequested);
  column->addWidget(close_);
  column->addStretch(1);
  setProblem({});
  refresh();
}

void RegionsPanel::buildList(QVBoxLayout& column) {
  list_ = new QTreeWidget(this);
  list_->setObjectName(QStringLiteral("regionList"));
  list_->setColumnCount(2);
  // The use is shown below the list too, the name is not.
  list_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  list_->setRootIsDecorated(false);
  list_->setUniformRowHeights(true);
  list_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  list_->setFixedHeight(fontMetrics().lineSpacing() * (kListLines + 3));
  list_->installEventFilter(this);
  connect(list_, &QTreeWidget::currentItemChanged, this, [this] {
    if (filling_)
      return;
    refresh();
    emit selectionChanged();
  });
  connect(list_, &QTreeWidget::itemDoubleClicked, this,
          [this](QTreeWidgetItem* item) { list_->editItem(item, 0); });
  connect(list_, &QTreeWidget::itemChanged, this, &RegionsPanel::takeName);
  column.addWidget(list_);
  none_ = new QLabel(this);
  none_->setWordWrap(true);
  column.addWidget(none_);

  shapes_ = new QMenu(this);
  for (const RegionKind& kind : regions::regionKinds()) {
    QAction* action = shapes_->addAction(QString());
    action->setObjectName(QStringLiteral("addRegion.") + qString(kind.word));
    connect(action, &QAction::triggered, this,
            [this, word = qString(kind.word)] { emit addRequested(word); });
  }
  add_ = new QToolButton(this);
  add_->setObjectName(QStringLiteral("regionAdd"));
  add_->setPopupMode(QToolButton::InstantPopup);
  add_->setToolButtonStyle(Qt::ToolButtonTextOnly);
  add_->setMenu(shapes_);
  add_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  remove_ = new QPushButton(this);
  remove_->setObjectName(QStringLiteral("regionRemove"));
  connect(remove_, &QPushButton::clicked, this, &RegionsPanel::removeChosen);
  up_ = new QToolButton(this);
  down_ = new QToolButton(this);
  up_->setObjectName(QStringLiteral("regionUp"));
  down_->setObjectName(QStringLiteral("regionDown"));
  up_->setArrowType(Qt::UpArrow);
  down_->setArrowType(Qt::DownArrow);
  connect(up_, &QToolButton::clicked, this, [this] { moveChosen(-1); });
  connect(down_, &QToolButton::clicked, this, [this] { moveChosen(1); });
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(add_, 1);
  buttons->addWidget(remove_, 1);
  buttons->addWidget(up_);
  buttons->addWidget(down_);
  const int height = remove_->sizeHint().height();
  for (QToolButton* button : {add_, up_, down_})
    button->setFixedHeight(height);
  column.addLayout(buttons);
}

RegionsPanel::Field RegionsPanel::addField(QGridLayout& grid, const QString& name,
                                           std::function<void(double)> takes) {
  Field field;
  field.box = new forms::NumberBox(this);
  field.box->setObjectName(name);
  field.box->setDecimals(kDecimals);
  field.label = new QLabel(this);
  field.label->setBuddy(field.box);
  connect(field.box, &QDoubleSpinBox::valueChanged, this,
          [takes = std::move(takes)](double value) { takes(value); });
  const int row = grid.rowCount();
  grid.addWidget(field.label, row, 0);
  grid.addWidget(field.box, row, 1);
  return field;
}

void RegionsPanel::buildFields(QVBoxLayout& column) {
  auto* grid = new QGridLayout;
  grid->setSpacing(4);
  grid->setColumnStretch(1, 1);
  use_ = forms::makeCombo(this);
  use_->setObjectName(QStringLiteral("regionUse"));
  for (const RegionUse& use : regions::regionUses())
    use_->addItem(QString(), qString(use.id));
  connect(use_, &QComboBox::activated, this, [this] { takeUse(use_->currentData().toString()); });
  useLabel_ = new QLabel(this);
  useLabel_->setBuddy(use_);
  grid->addWidget(useLabel_, 0, 0);
  grid->addWidget(use_, 0, 1);
  std::size_t ofShape = 0, ofUse = 0;
  for (const RegionKind& kind : regions::regionKinds())
    ofShape = std::max(ofShape, kind.fields.size());
  for (const RegionUse& use : regions::regionUses())
    ofUse = std::max(ofUse, use.fields.size());
  for (std::size_t i = 0; i < ofUse; ++i)
    useFields_.push_back(addField(*grid, QStringLiteral("regionUseNumber%1").arg(i),
                                  [this, i](double number) { takeUseNumber(i, number); }));
  for (std::size_t i = 0; i < ofShape; ++i)
    shapeFields_.push_back(addField(*grid, QStringLiteral("regionNumber%1").arg(i),
                                    [this, i](double number) { takeShapeNumber(i, number); }));
  column.addLayout(grid);
  paint_ = new PaintForm(this);
  connect(paint_, &PaintForm::changed, this, &RegionsPanel::paintChanged);
  column.addWidget(paint_);
}

void RegionsPanel::buildSettings(QVBoxLayout& column) {
  auto* content = new QWidget;
  auto* rows = new QVBoxLayout(content);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(2);
  settings_ = new forms::Fold(content, this);
  settings_->setObjectName(QStringLiteral("regionSettings"));
  const base::ParameterTable parameters = pipeline::allParameters();
  for (const base::ParameterSpec& spec : parameters.specs()) {
    if (spec.scope != base::ParameterScope::Region)
      continue;
    auto* row = new forms::ParameterRow(spec, content);
    row->setObjectName(QStringLiteral("region.") + row->key());
    connect(row, &forms::ParameterRow::committed, this, &RegionsPanel::takeSetting);
    connect(row, &forms::ParameterRow::resetRequested, this, [this, row](const QString& key) {
      takeSetting(key, QString::fromStdString(base::formatParameter(row->spec().defaultValue)));
    });
    rows->addWidget(row);
    rows_.push_back(row);
  }
  column.addWidget(settings_);
}

// ---- what is shown

void RegionsPanel::setPart(const QString& name) {
  part_ = name;
  title_->setText(name.isEmpty() ? tr("Regions") : tr("Regions of %1").arg(name));
}

void RegionsPanel::setRegions(const std::vector<Region>& regions) {
  regions_ = regions;
  refresh();
}

void RegionsPanel::select(std::optional<std::size_t> region) {
  filling_ = true;
  list_->setCurrentItem(region ? list_->topLevelItem(static_cast<int>(*region)) : nullptr);
  filling_ = false;
  refresh();
}

std::optional<std::size_t> RegionsPanel::selected() const {
  const int at = list_->currentItem() ? list_->indexOfTopLevelItem(list_->currentItem()) : -1;
  return at >= 0 && static_cast<std::size_t>(at) < regions_.size()
             ? std::optional(static_cast<std::size_t>(at))
             : std::nullopt;
}

void RegionsPanel::setPartValues(const base::ParameterTable& table,
                                 const std::set<std::string>& applying) {
  applying_ = applying;
  for (forms::ParameterRow* row : rows_)
    if (const base::ParameterSpec* spec = table.find(row->key().toStdString()))
      row->setDefault(spec->defaultValue);
  if (const base::ParameterSpec* spec = table.find(kDensity))
    partDensity_ = spec->defaultValue;
  refresh();
}

void RegionsPanel::setColours(const std::array<QColor, 4>& colours) {
  colours_ = colours;
  showList();
}

void RegionsPanel::setProblem(const QString& text) {
  icon_->setVisible(!text.isEmpty());
  icon_->setPixmap(forms::iconBeside(*this, forms::Icon::Warning));
  problem_->setText(text);
  problem_->setVisible(!text.isEmpty());
}

const PaintChoices& RegionsPanel::paint() const {
  return paint_->choices();
}

void RegionsPanel::openAddMenu() {
  shapes_->popup(add_->mapToGlobal(QPoint(0, add_->height())));
}

void RegionsPanel::refresh() {
  showList();
  const auto at = selected();
  details_->setVisible(at.has_value());
  const RegionUse* use = at ? useOf(regions_[*at]) : nullptr;
  settings_->setVisible(use && use->hasSettings());
  remove_->setEnabled(at.has_value());
  up_->setEnabled(at && *at > 0);
  down_->setEnabled(at && *at + 1 < regions_.size());
  if (!at)
    return;
  showFields(regions_[*at]);
  showSettings(regions_[*at]);
}

void RegionsPanel::showList() {
  filling_ = true;
  const auto at = selected();
  const int count = static_cast<int>(regions_.size());
  while (list_->topLevelItemCount() > count)
    delete list_->takeTopLevelItem(list_->topLevelItemCount() - 1);
  while (list_->topLevelItemCount() < count) {
    auto* item = new QTreeWidgetItem(list_);
    item->setFlags(item->flags() | Qt::ItemIsEditable);
  }
  const int side = fontMetrics().height() * 3 / 4;
  for (int i = 0; i < count; ++i) {
    QTreeWidgetItem* item = list_->topLevelItem(i);
    const Region& region = regions_[static_cast<std::size_t>(i)];
    const RegionUse* use = useOf(region);
    item->setText(0, nameOfRegion(regions_, static_cast<std::size_t>(i)));
    item->setText(1, use ? language::heading(use->label) : QString::fromStdString(region.use));
    item->setToolTip(0, item->text(0));
    item->setToolTip(1, item->text(1));
    item->setIcon(0, forms::swatchOf(colours_[colourOf(region)], side));
  }
  if (!at && list_->currentItem() && count == 0)
    list_->setCurrentItem(nullptr);
  filling_ = false;
  none_->setVisible(count == 0);
}

void RegionsPanel::showFields(const Region& region) {
  const auto shape = shapeOf(region);
  const RegionUse* use = useOf(region);
  const bool followsSurface = shape && regions::followsSurface(*shape->kind);
  auto* model = qobject_cast<QStandardItemModel*>(use_->model());
  for (int i = 0; i < use_->count(); ++i) {
    const RegionUse& one = regions::regionUses()[static_cast<std::size_t>(i)];
    const bool makesSense = one.layers != regions::RegionLayers::Surface || followsSurface;
    model->item(i)->setEnabled(makesSense);
    model->item(i)->setToolTip(
        makesSense ? QString()
                   : tr("Only a skin or a painted surface says which faces the layers follow"));
  }
  use_->setCurrentIndex(use ? use_->findData(qString(use->id)) : -1);
  const auto fill = [](const std::vector<Field>& fields, const std::vector<ShapeField>& specs,
                       const std::vector<double>& numbers, const char* unit) {
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const bool shown = i < specs.size() && i < numbers.size();
      fields[i].label->setVisible(shown);
      fields[i].box->setVisible(shown);
      if (!shown)
        continue;
      const QSignalBlocker quiet(fields[i].box);
      const QString label = language::heading(specs[i].label);
      fields[i].label->setText(label);
      fields[i].box->setAccessibleName(label);
      fields[i].box->setUnit(isAngle(specs[i]) ? QStringLiteral("°") : QLatin1String(unit));
      fields[i].box->setDecimals(specs[i].isWhole ? 0 : kDecimals);
      fields[i].box->setRange(specs[i].minimum, specs[i].maximum);
      fields[i].box->setSingleStep(specs[i].maximum <= 1.0 ? 0.1 : 1.0);
      fields[i].box->setValue(numbers[i]);
    }
  };
  paint_->setVisible(shape && shape->kind->mesh == regions::ShapeMesh::Painted);
  paint_->setHasLayers(use && use->hasLayers());
  static const std::vector<ShapeField> kNone;
  fill(shapeFields_, shape ? shape->kind->fields : kNone,
       shape ? shape->numbers : std::vector<double>{}, "mm");
  fill(useFields_, use ? use->fields : kNone,
       use ? numbersOf(*use, region.use) : std::vector<double>{},
       use && use->load == regions::RegionLoad::Force ? "N" : "");
}

void RegionsPanel::showSettings(const Region& region) {
  bool anyChanged = false;
  for (forms::ParameterRow* row : rows_) {
    const std::string key = row->key().toStdString();
    if (key == kDensity)
      row->setDefault(isSolid(region) ? base::ParameterValue(1.0) : partDensity_);
    base::ParameterValue value = row->spec().defaultValue;
    if (const auto given = region.parameters.find(key); given != region.parameters.end()) {
      try {
        value = base::parseParameter(row->spec(), given->second);
      } catch (const base::Error&) { // the line of the problem names it
      }
    }
    row->setValue(value);
    row->setVisible(applying_.contains(key) || region.parameters.contains(key));
    anyChanged = anyChanged || row->isChanged();
  }
  settings_->setMarked(anyChanged);
}

// ---- edits

Region* RegionsPanel::chosen() {
  const auto at = selected();
  return at ? &regions_[*at] : nullptr;
}

void RegionsPanel::emitEdited(const QString& editName) {
  refresh();
  emit edited(regions_, editName);
}

void RegionsPanel::takeName(QTreeWidgetItem* item) {
  if (filling_)
    return;
  const auto at = static_cast<std::size_t>(list_->indexOfTopLevelItem(item));
  if (at >= regions_.size())
    return;
  const QString name = item->text(0).trimmed();
  if (name == nameOfRegion(regions_, at)) {
    showList();
    return;
  }
  regions_[at].name = name.toStdString();
  emitEdited(tr("Rename region"));
}

void RegionsPanel::takeUse(const QString& id) {
  Region* region = chosen();
  if (!region || id == qString(std::string_view(region->use).substr(0, region->use.find(':'))))
    return;
  region->use = textOfNew(regions::findUse(id.toStdString()));
  emitEdited(tr("Use of a region"));
}

void RegionsPanel::takeShapeNumber(std::size_t at, double number) {
  Region* region = chosen();
  const auto shape = region ? shapeOf(*region) : std::nullopt;
  if (!shape || at >= shape->numbers.size())
    return;
  std::vector<double> numbers = shape->numbers;
  numbers[at] = number;
  region->shape = textOf(shape->kind->word, numbers);
  emitEdited(tr("Change region"));
}

void RegionsPanel::takeUseNumber(std::size_t at, double number) {
  Region* region = chosen();
  const RegionUse* use = region ? useOf(*region) : nullptr;
  if (!use || at >= use->fields.size())
    return;
  std::vector<double> numbers = numbersOf(*use, region->use);
  numbers[at] = number;
  region->use = textOf(use->id, numbers);
  emitEdited(tr("Change region"));
}

void RegionsPanel::takeSetting(const QString& key, const QString& text) {
  Region* region = chosen();
  const auto row = std::ranges::find(rows_, key, &forms::ParameterRow::key);
  if (!region || row == rows_.end())
    return;
  if (text.toStdString() == base::formatParameter((*row)->spec().defaultValue))
    region->parameters.erase(key.toStdString());
  else
    region->parameters[key.toStdString()] = text.toStdString();
  emitEdited(tr("Change %1").arg(language::words((*row)->spec().label)));
}

void RegionsPanel::removeChosen() {
  const auto at = selected();
  if (!at)
    return;
  regions_.erase(regions_.begin() + static_cast<std::ptrdiff_t>(*at));
  emitEdited(tr("Delete region"));
  emit selectionChanged();
}

void RegionsPanel::moveChosen(int by) {
  const auto at = selected();
  const auto to = at ? static_cast<std::ptrdiff_t>(*at) + by : -1;
  if (to < 0 || to >= static_cast<std::ptrdiff_t>(regions_.size()))
    return;
  std::swap(regions_[*at], regions_[static_cast<std::size_t>(to)]);
  select(static_cast<std::size_t>(to));
  emitEdited(tr("Order of regions"));
  emit selectionChanged();
}

void RegionsPanel::retranslate() {
  setPart(part_);
  list_->setHeaderLabels({tr("Region"), tr("Use")});
  list_->setAccessibleName(tr("Regions"));
  list_->setToolTip(tr("Where regions overlap, the lower one in the list holds. Double-click "
                       "renames."));
  none_->setText(tr("A region is printed by settings, or in layers, of its own."));
  add_->setText(tr("Add"));
  remove_->setText(tr("Delete"));
  up_->setToolTip(tr("Move up"));
  down_->setToolTip(tr("Move down: where regions overlap, the lower one holds"));
  up_->setAccessibleName(tr("Move up"));
  down_->setAccessibleName(tr("Move down"));
  useLabel_->setText(tr("Use"));
  settings_->setTitle(tr("Settings"));
  close_->setText(tr("Close"));
  for (QAction* action : shapes_->actions())
    for (const RegionKind& kind : regions::regionKinds())
      if (action->objectName() == QStringLiteral("addRegion.") + qString(kind.word))
        action->setText(language::heading(kind.label) +
                        (kind.mesh == regions::ShapeMesh::File ? QStringLiteral("…") : QString()));
  for (int i = 0; i < use_->count(); ++i)
    use_->setItemText(i,
                      language::heading(regions::regionUses()[static_cast<std::size_t>(i)].label));
  for (forms::ParameterRow* row : rows_)
    row->retranslate();
  refresh();
}

void RegionsPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange)
    retranslate();
  QWidget::changeEvent(event);
}

// The Delete key in the list deletes the region, not the part.
bool RegionsPanel::eventFilter(QObject* watched, QEvent* event) {
  const bool isKey = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
  if (watched != list_ || !isKey || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Delete)
    return QWidget::eventFilter(watched, event);
  event->accept();
  if (event->type() == QEvent::KeyPress)
    removeChosen();
  return true;
}

} // namespace voluta::panels
