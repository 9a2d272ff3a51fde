#include "window/cell_editor.h"

#include "base/error.h"
#include "forms/colours.h"
#include "forms/icons.h"
#include "forms/value_boxes.h"
#include "language/words.h"
#include "panels/frame_form.h"
#include "program/extruder.h"
#include "viewer/viewport.h"
#include "window/background.h"
#include "window/picture_area.h"

#include <QAction>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QToolButton>
#include <QTreeWidget>
#include <QUndoCommand>
#include <QUndoStack>
#include <QVBoxLayout>
#include <map>

namespace voluta::window {

using robot::CellDraft;
using robot::DraftBody;

namespace {

constexpr int kSideWidth = 380, kTreeHeight = 150, kFaultsHeight = 96;
constexpr double kMostKg = 1000.0;
constexpr double kNewBoxMm = 100.0;
constexpr int kBodyRole = Qt::UserRole;

QString named(const std::string& text) {
  return QString::fromStdString(text);
}

QString nameOf(const DraftBody& body) {
  switch (body.kind) {
  case DraftBody::Kind::Nozzle:
    return CellEditor::tr("Nozzle");
  case DraftBody::Kind::Platform:
    return CellEditor::tr("Plate");
  case DraftBody::Kind::Axis:
  case DraftBody::Kind::Obstacle:
    break;
  }
  return named(body.name);
}

QString parentOf(const DraftBody& body, bool axes) {
  if (body.onFlange)
    return CellEditor::tr("in the flange");
  if (body.kind == DraftBody::Kind::Platform && axes)
    return CellEditor::tr("on the last axis");
  if (body.kind == DraftBody::Kind::Axis && body.index > 0)
    return CellEditor::tr("on the axis before it");
  return CellEditor::tr("in the robot's base");
}

// The origin of a body's frame at rest, in the base.
Eigen::Vector3d placeOf(const DraftBody& body, const robot::Cell& cell) {
  std::vector<Eigen::Isometry3d> frames;
  cell.framePoses(cell.home(), frames);
  const auto at = [&](int frame) { return frames[static_cast<std::size_t>(frame)].translation(); };
  switch (body.kind) {
  case DraftBody::Kind::Nozzle:
    return at(cell.toolFrame());
  case DraftBody::Kind::Platform:
    return at(cell.workFrame());
  case DraftBody::Kind::Axis:
    return body.index < cell.externalAxes().size() ? at(cell.axisFrame(body.index))
                                                   : Eigen::Vector3d::Zero().eval();
  case DraftBody::Kind::Obstacle:
    break;
  }
  return body.pose.translation();
}

} // namespace

struct CellEditor::Looked {
  pipeline::CheckedCell checked;
  std::shared_ptr<const scene::CellDrawing> drawing;
};

class CellEditor::Edit : public QUndoCommand {
public:
  Edit(CellEditor& editor, CellDraft before, CellDraft after, const QString& name)
      : QUndoCommand(name), editor_(editor), before_(std::move(before)), after_(std::move(after)) {}
  void undo() override { editor_.setDraft(before_); }
  void redo() override { editor_.setDraft(after_); }

private:
  CellEditor& editor_;
  CellDraft before_, after_;
};

CellEditor::CellEditor(const CellDraft& draft, const process::Process& process, double partKg,
                       QWidget* parent)
    : QDialog(parent), draft_(draft), process_(process), partKg_(partKg),
      undo_(new QUndoStack(this)),
      viewport_(new viewer::Viewport(
          sceneTheme(forms::isDark(palette()) ? Appearance::Dark : Appearance::Light), this)) {
  setObjectName("cellEditor");
  setWindowTitle(tr("Edit cell"));
  build();
  listen();
  showDraft();
  resize(1120, 720);
}

CellEditor::~CellEditor() = default;

void CellEditor::build() {
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  save_ = buttons->addButton(tr("Save as own cell"), QDialogButtonBox::AcceptRole);
  save_->setObjectName("cellSave");
  connect(save_, &QPushButton::clicked, this, &CellEditor::save);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  // Enter commits a number, and ends nothing.
  for (QAbstractButton* button : buttons->buttons())
    static_cast<QPushButton*>(button)->setAutoDefault(false);
  auto* row = new QHBoxLayout;
  row->addWidget(viewport_, 1);
  row->addWidget(buildSide());
  auto* column = new QVBoxLayout(this);
  column->addLayout(row, 1);
  column->addWidget(buttons);
}

QWidget* CellEditor::buildSide() {
  auto* side = new QWidget(this);
  side->setFixedWidth(kSideWidth);
  name_ = new QLineEdit(side);
  name_->setObjectName("cellName");
  robot_ = forms::makeCombo(side);
  robot_->setObjectName("cellRobot");
  for (const std::string& id : robot::robotIds())
    robot_->addItem(named(id), named(id));
  extruder_ = forms::makeCombo(side);
  extruder_->setObjectName("cellExtruder");
  for (const program::Extruder& extruder : program::extruders())
    extruder_->addItem(language::words(extruder.label), named(std::string(extruder.id)));
  carried_ = new forms::NumberBox(side);
  carried_->setObjectName("cellCarried");
  carried_->setUnit(QStringLiteral("kg"));
  carried_->setRange(0.0, kMostKg);
  carried_->setSingleStep(0.1);
  carried_->setToolTip(tr("What the flange carries before anything is printed: the plate and its "
                          "stem, or head and extruder"));
  auto* form = new QFormLayout;
  form->addRow(tr("Name"), name_);
  form->addRow(tr("Robot"), robot_);
  form->addRow(tr("Extruder"), extruder_);
  form->addRow(tr("Carried"), carried_);

  faultIcon_ = new QLabel(side);
  faults_ = new QLabel(side);
  faults_->setObjectName("cellFaults");
  faults_->setWordWrap(true);
  faults_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  faults_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  auto* told = new QWidget;
  auto* line = new QHBoxLayout(told);
  line->setContentsMargins(0, 0, 0, 0);
  line->addWidget(faultIcon_, 0, Qt::AlignTop);
  line->addWidget(faults_, 1);
  auto* scroll = new QScrollArea(side);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFixedHeight(kFaultsHeight);
  scroll->setWidget(told);

  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(form);
  column->addWidget(buildBodies(), 1);
  column->addWidget(scroll);
  return side;
}

QWidget* CellEditor::buildBodies() {
  auto* bodies = new QWidget(this);
  tree_ = new QTreeWidget(bodies);
  tree_->setObjectName("cellBodies");
  tree_->setHeaderHidden(true);
  tree_->setMinimumHeight(kTreeHeight);
  frameOf_ = new QLabel(bodies);
  frame_ = new panels::FrameForm(bodies);
  auto* add = new QPushButton(tr("Add box"), bodies);
  add->setObjectName("cellAddBox");
  remove_ = new QPushButton(tr("Remove"), bodies);
  remove_->setObjectName("cellRemove");
  rest_ = new QPushButton(tr("Find rest"), bodies);
  rest_->setObjectName("cellRest");
  rest_->setToolTip(tr("Rest where the arm is clearest of everything, the nozzle over the plate"));
  connect(add, &QPushButton::clicked, this, &CellEditor::addBox);
  connect(remove_, &QPushButton::clicked, this, &CellEditor::removeBody);
  connect(rest_, &QPushButton::clicked, this, &CellEditor::rest);
  auto* row = new QHBoxLayout;
  for (QAction* action : {undo_->createUndoAction(this), undo_->createRedoAction(this)}) {
    const bool undoes = row->count() == 0;
    action->setShortcut(undoes ? QKeySequence::Undo : QKeySequence::Redo);
    addAction(action);
    auto* button = new QToolButton(bodies);
    button->setDefaultAction(action);
    button->setText(undoes ? tr("Undo") : tr("Redo"));
    // The action's text names the edit, which is for its tip.
    connect(action, &QAction::changed, button, [button, undoes] {
      button->setText(undoes ? CellEditor::tr("Undo") : CellEditor::tr("Redo"));
    });
    row->addWidget(button);
  }
  row->addStretch(1);
  for (QPushButton* button : {add, remove_, rest_})
    row->addWidget(button);
  for (QPushButton* button : {add, remove_, rest_})
    button->setAutoDefault(false); // as the dialog's own
  auto* column = new QVBoxLayout(bodies);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(tree_, 1);
  column->addLayout(row);
  column->addWidget(frameOf_);
  column->addWidget(frame_);
  return bodies;
}

void CellEditor::listen() {
  connect(name_, &QLineEdit::textEdited, this, &CellEditor::showFaults);
  connect(robot_, &QComboBox::activated, this, [this] {
    try {
      edit(draft_.withRobot(robot::loadRobot(robot_->currentData().toString().toStdString())),
           tr("robot"));
    } catch (const base::Error& error) {
      faults_->setText(language::words(error.whole()));
    }
  });
  connect(extruder_, &QComboBox::activated, this, [this] {
    edit(draft_.withExtruder(extruder_->currentData().toString().toStdString()), tr("extruder"));
  });
  connect(carried_, &QDoubleSpinBox::valueChanged, this,
          [this](double kg) { edit(draft_.withCarriedKg(kg), tr("carried mass")); });
  connect(tree_, &QTreeWidget::currentItemChanged, this, &CellEditor::showBody);
  connect(frame_, &panels::FrameForm::frameChanged, this, [this](const Eigen::Isometry3d& pose) {
    if (const auto body = chosen())
      edit(draft_.withPose(*body, pose), tr("move %1").arg(nameOf(*body)));
  });
  connect(frame_, &panels::FrameForm::sizeChanged, this, [this](const Eigen::Vector3d& size) {
    if (const auto body = chosen(); body && body->sizeMm)
      edit(draft_.withSize(*body, size), tr("edges of %1").arg(nameOf(*body)));
  });
}

void CellEditor::edit(const CellDraft& draft, const QString& name) {
  if (!(draft == draft_))
    undo_->push(new Edit(*this, draft_, draft, name));
}

void CellEditor::setDraft(const CellDraft& draft) {
  draft_ = draft;
  showDraft();
}

void CellEditor::showDraft() {
  const auto choose = [](QComboBox* combo, const std::string& id) {
    const QSignalBlocker quiet(combo);
    if (combo->findData(named(id)) < 0)
      combo->addItem(named(id), named(id));
    combo->setCurrentIndex(combo->findData(named(id)));
  };
  if (name_->text().isEmpty()) {
    const bool own = !robot::isShippedCell(draft_.id());
    name_->setText(named(draft_.id()) + (own ? QString() : QStringLiteral("-own")));
  }
  choose(robot_, draft_.robot());
  choose(extruder_, draft_.extruder());
  showBodies();
  look();
}

void CellEditor::showBodies() {
  const std::optional<DraftBody> before = chosen();
  const QSignalBlocker quiet(tree_);
  tree_->clear();
  auto* base = new QTreeWidgetItem(tree_, {tr("Robot's base")});
  auto* flange = new QTreeWidgetItem(base, {tr("Flange of %1").arg(named(draft_.robot()))});
  const std::vector<DraftBody> bodies = draft_.bodies();
  QTreeWidgetItem* now = nullptr;
  QTreeWidgetItem* last = base; // what the next axis stands on
  const auto add = [&](std::size_t n, QTreeWidgetItem* parent) {
    auto* item = new QTreeWidgetItem(parent, {nameOf(bodies[n])});
    item->setData(0, kBodyRole, static_cast<int>(n));
    if (before && bodies[n].sameAs(*before))
      now = item;
    return item;
  };
  for (std::size_t n = 0; n < bodies.size(); ++n)
    if (bodies[n].kind == DraftBody::Kind::Axis)
      last = add(n, last);
  for (std::size_t n = 0; n < bodies.size(); ++n)
    if (bodies[n].kind != DraftBody::Kind::Axis)
      add(n, bodies[n].onFlange                            ? flange
             : bodies[n].kind == DraftBody::Kind::Platform ? last
                                                           : base);
  tree_->expandAll();
  if (now)
    tree_->setCurrentItem(now);
  showBody();
}

std::optional<DraftBody> CellEditor::chosen() const {
  const QTreeWidgetItem* item = tree_->currentItem();
  const QVariant at = item ? item->data(0, kBodyRole) : QVariant();
  const std::vector<DraftBody> bodies = draft_.bodies();
  if (!at.isValid() || at.toInt() >= static_cast<int>(bodies.size()))
    return std::nullopt;
  return bodies[static_cast<std::size_t>(at.toInt())];
}

void CellEditor::showBody() {
  const std::optional<DraftBody> body = chosen();
  frame_->setEnabled(body.has_value());
  remove_->setEnabled(body && body->kind == DraftBody::Kind::Obstacle);
  const bool axes = std::ranges::any_of(
      draft_.bodies(), [](const DraftBody& other) { return other.kind == DraftBody::Kind::Axis; });
  frameOf_->setText(body ? tr("%1, %2").arg(nameOf(*body), parentOf(*body, axes))
                         : tr("Choose a body to move it"));
  frame_->setSizeMm(body ? body->sizeMm : std::nullopt);
  if (body)
    frame_->setFrame(body->pose);
  scene::ViewState view;
  view.part = view.platform = false;
  view.cell = true;
  view.world = scene::World::Base;
  if (body && checked_.cell) {
    const Eigen::Isometry3d base_T_work = checked_.cell->base_T_work(checked_.cell->home());
    view.marker = base_T_work.inverse() * placeOf(*body, *checked_.cell);
  }
  viewport_->setView(view);
}

void CellEditor::look() {
  save_->setEnabled(false);
  faultIcon_->clear();
  faults_->setText(tr("being looked at…"));
  inBackground(
      runner_,
      [text = draft_.text(), id = draft_.id(), process = process_,
       partKg = partKg_](const base::RunContext& ctx) {
        Looked looked{pipeline::checkedCell(text, id, process, partKg, ctx), nullptr};
        if (looked.checked.cell)
          looked.drawing = scene::drawCell(*looked.checked.cell);
        return looked;
      },
      [this](Looked&& looked) { take(std::move(looked)); });
}

void CellEditor::take(Looked&& looked) {
  checked_ = std::move(looked.checked);
  if (checked_.cell) {
    viewport_->scene().setCell(looked.drawing);
    const QSignalBlocker quiet(carried_);
    carried_->setValue(checked_.cell->carriedKg());
  }
  showBody();
  if (checked_.cell && !std::exchange(framed_, true))
    viewport_->frameAll();
  viewport_->requestFrame();
  showFaults();
}

void CellEditor::showFaults() {
  if (runner_.running())
    return;
  QStringList lines;
  for (const reach::CellFault& fault : checked_.faults) {
    const QString remedy = language::words(fault.remedy);
    lines << language::words(fault.what) + (remedy.isEmpty() ? QString() : ": " + remedy);
  }
  bool nameGood = true;
  try {
    static_cast<void>(robot::ownCellFile(idOfName().toStdString()));
  } catch (const base::Error& error) {
    nameGood = false;
    lines << language::words(error.message()) + ": " + language::words(error.remedy());
  }
  const int side = fontMetrics().height();
  const forms::Icon icon = !checked_.cell || !nameGood ? forms::Icon::Blocked
                           : lines.isEmpty()           ? forms::Icon::Good
                                                       : forms::Icon::Warning;
  faultIcon_->setPixmap(forms::icon(icon).pixmap(QSize(side, side), devicePixelRatioF()));
  faults_->setText(lines.isEmpty() ? tr("Nothing is wrong with it.")
                                   : lines.join(QLatin1Char('\n')));
  save_->setEnabled(checked_.cell && nameGood);
  rest_->setEnabled(checked_.cell != nullptr);
}

void CellEditor::addBox() {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  if (checked_.cell) {
    // Beside the plate, where it is seen.
    const Eigen::Vector3d plate = checked_.cell->base_T_work(checked_.cell->home()).translation();
    pose.translation() = plate + Eigen::Vector3d(0.0, 3.0 * kNewBoxMm, 0.0);
  }
  edit(draft_.withBox("box", pose, Eigen::Vector3d::Constant(kNewBoxMm)), tr("add a box"));
  // It is the last body there is.
  const int added = static_cast<int>(draft_.bodies().size()) - 1;
  const auto items =
      tree_->findItems(nameOf(draft_.bodies().back()), Qt::MatchExactly | Qt::MatchRecursive);
  for (QTreeWidgetItem* item : items)
    if (item->data(0, kBodyRole).toInt() == added)
      tree_->setCurrentItem(item);
}

void CellEditor::removeBody() {
  if (const auto body = chosen(); body && body->kind == DraftBody::Kind::Obstacle)
    edit(draft_.without(*body), tr("remove %1").arg(nameOf(*body)));
}

void CellEditor::rest() {
  if (!checked_.cell)
    return;
  rest_->setEnabled(false);
  faults_->setText(tr("being looked for…"));
  inBackground(
      runner_,
      [cell = checked_.cell, process = process_] {
        return std::pair(reach::clearestRest(*cell, process), cell);
      },
      [this](auto&& found) {
        const auto& [joints, cell] = found;
        if (joints) {
          edit(draft_.withHome(joints->head(cell->armDof()), cell->limits()), tr("rest"));
        }
        if (!runner_.running())
          showFaults();
        if (!joints)
          faults_->setText(tr("Nowhere over the plate is the arm clear of everything."));
      });
}

QString CellEditor::idOfName() const {
  return name_->text().trimmed();
}

void CellEditor::save() {
  const std::string id = idOfName().toStdString();
  const CellDraft named = draft_.named(id, id == draft_.id() ? draft_.label() : id);
  try {
    std::error_code none;
    if (std::filesystem::exists(robot::ownCellFile(id), none) && id != draft_.id() &&
        QMessageBox::question(this, windowTitle(), tr("Replace the cell %1?").arg(idOfName())) !=
            QMessageBox::Yes)
      return;
    robot::saveOwnCell(named);
  } catch (const base::Error& error) {
    QMessageBox::warning(this, windowTitle(), language::words(error.whole()));
    return;
  }
  savedId_ = idOfName();
  accept();
}

} // namespace voluta::window
