#include "window/cell/cell_editor.h"

#include "base/error.h"
#include "base/outcome.h"
#include "forms/dialog_buttons.h"
#include "forms/icons.h"
#include "forms/value_boxes.h"
#include "language/words.h"
#include "panels/frame_form.h"
#include "program/extruder.h"
#include "robot/plate.h"
#include "robot/shape/arm_look.h"
#include "scene/drawing_data.h"
#include "viewer/viewport.h"
#include "window/background.h"
#include "window/cell/body_tree.h"
#include "window/cell/measure_dialog.h"
#include "window/cell/obstacle_import.h"
#include "window/picture_area.h"

#include <QAction>
#include <QCheckBox>
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
#include <QUndoCommand>
#include <QUndoStack>
#include <QVBoxLayout>
#include <algorithm>

namespace voluta::window {

using robot::CellDraft;
using robot::DraftBody;

namespace {

constexpr int kSideWidth = 380, kTreeHeight = 150, kFaultsHeight = 96;
constexpr double kMaxKg = 1000.0;
constexpr double kNewBoxMm = 100.0;

QString named(const std::string& text) {
  return QString::fromStdString(text);
}

// Whether the drawn links can be reused for the cell.
bool sameArm(const scene::CellDrawing& drawn, const robot::Cell& cell) {
  return drawn.cell.robot().id == cell.robot().id;
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
      importing_(new ObstacleImport(this)), undo_(new QUndoStack(this)),
      viewport_(new viewer::Viewport(sceneTheme(palette()), this)) {
  setObjectName("cellEditor");
  setWindowTitle(tr("Edit cell"));
  build();
  listen();
  showDraft();
  resize(1120, 720);
}

CellEditor::~CellEditor() = default;

bool CellEditor::settled() const {
  return !runner_.running() && !importing_->running();
}

void CellEditor::build() {
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
  save_ = buttons->addButton(tr("Save as my cell"), QDialogButtonBox::AcceptRole);
  save_->setObjectName("cellSave");
  connect(save_, &QPushButton::clicked, this, &CellEditor::save);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  forms::keepOpenOnEnter(*buttons);
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
  carried_->setRange(0.0, kMaxKg);
  carried_->setSingleStep(0.1);
  carried_->setToolTip(
      tr("Mass on the flange before printing: the plate and its stem, or head and extruder"));
  auto* form = new QFormLayout;
  form->addRow(tr("Name"), name_);
  form->addRow(tr("Robot"), robot_);
  form->addRow(tr("Extruder"), extruder_);
  form->addRow(tr("Payload"), carried_);

  faultIcon_ = new QLabel(side);
  faults_ = new QLabel(side);
  faults_->setObjectName("cellFaults");
  faults_->setWordWrap(true);
  faults_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  faults_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  auto* problems = new QWidget;
  auto* line = new QHBoxLayout(problems);
  line->setContentsMargins(0, 0, 0, 0);
  line->addWidget(faultIcon_, 0, Qt::AlignTop);
  line->addWidget(faults_, 1);
  auto* scroll = new QScrollArea(side);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFixedHeight(kFaultsHeight);
  scroll->setWidget(problems);

  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(0, 0, 0, 0);
  column->addLayout(form);
  column->addWidget(buildBodies(), 1);
  column->addWidget(scroll);
  return side;
}

QWidget* CellEditor::buildBodies() {
  auto* bodies = new QWidget(this);
  tree_ = new BodyTree(bodies);
  tree_->setObjectName("cellBodies");
  tree_->setAccessibleName(tr("Bodies of the cell"));
  tree_->setMinimumHeight(kTreeHeight);
  frameOf_ = new QLabel(bodies);
  frame_ = new panels::FrameForm(bodies);
  auto* addBox = new QPushButton(tr("Add box"), bodies);
  addBox->setObjectName("cellAddBox");
  auto* addFile = new QPushButton(tr("Add from file…"), bodies);
  addFile->setObjectName("cellAddFile");
  addFile->setToolTip(
      tr("An obstacle from a drawing: a mesh, approximated by boxes, cylinders and capsules"));
  addPurgePlace_ = new QPushButton(tr("Add place for purges"), bodies);
  addPurgePlace_->setObjectName("cellAddPurgePlace");
  measure_ = new QPushButton(tr("Measure…"), bodies);
  measure_->setObjectName("cellMeasure");
  measure_->setToolTip(tr("Computes the body's pose from points touched at the real cell"));
  remove_ = new QPushButton(tr("Remove"), bodies);
  remove_->setObjectName("cellRemove");
  rest_ = new QPushButton(tr("Find home pose"), bodies);
  rest_->setObjectName("cellRest");
  rest_->setToolTip(
      tr("Finds the home pose with the greatest clearance, the nozzle over the plate"));
  connect(addBox, &QPushButton::clicked, this, &CellEditor::addBox);
  connect(addFile, &QPushButton::clicked, importing_, &ObstacleImport::choose);
  connect(addPurgePlace_, &QPushButton::clicked, this, &CellEditor::addPurgePlace);
  connect(measure_, &QPushButton::clicked, this, &CellEditor::measure);
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
    // The action's text names the edit; the button shows it only as a tool tip.
    connect(action, &QAction::changed, button, [button, undoes] {
      button->setText(undoes ? CellEditor::tr("Undo") : CellEditor::tr("Redo"));
    });
    row->addWidget(button);
  }
  solids_ = new QCheckBox(tr("Collision solids"), bodies);
  solids_->setObjectName("cellSolids");
  solids_->setToolTip(tr("Shows the solids used for collision checks over the arm"));
  connect(solids_, &QCheckBox::toggled, this, &CellEditor::showBody);
  row->addStretch(1);
  row->addWidget(solids_);
  row->addWidget(rest_);
  auto* below = new QGridLayout;
  below->addWidget(addBox, 0, 0);
  below->addWidget(addFile, 0, 1);
  below->addWidget(addPurgePlace_, 1, 0);
  below->addWidget(remove_, 1, 1);
  auto* title = new QHBoxLayout;
  title->addWidget(frameOf_, 1);
  title->addWidget(measure_);
  for (QPushButton* button : {addBox, addFile, addPurgePlace_, measure_, remove_, rest_})
    button->setAutoDefault(false); // As for the dialog's own buttons
  auto* column = new QVBoxLayout(bodies);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(tree_, 1);
  column->addLayout(row);
  column->addLayout(below);
  column->addLayout(title);
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
          [this](double kg) { edit(draft_.withCarriedKg(kg), tr("payload")); });
  connect(tree_, &QTreeWidget::currentItemChanged, this, &CellEditor::showBody);
  connect(viewport_, &viewer::Viewport::gizmoStarted, this, [this] { held_ = tree_->chosen(); });
  connect(viewport_, &viewer::Viewport::gizmoDragged, this, &CellEditor::drag);
  connect(viewport_, &viewer::Viewport::toolChanged, this, [this](viewer::Tool tool) {
    // Esc cancels a drag.
    if (tool == viewer::Tool::None && std::exchange(held_, std::nullopt))
      showDraft();
  });
  connect(importing_, &ObstacleImport::started, this,
          [this](const QString& file) { showStatus(tr("Reading %1…").arg(file)); });
  connect(importing_, &ObstacleImport::imported, this, &CellEditor::addSolids);
  connect(importing_, &ObstacleImport::failed, this, [this](const QString& why) {
    showFaults();
    showStatus(why, forms::Icon::Blocked);
  });
  connect(frame_, &panels::FrameForm::frameChanged, this, [this](const Eigen::Isometry3d& pose) {
    if (const auto body = tree_->chosen())
      edit(draft_.withPose(*body, pose), tr("move %1").arg(BodyTree::nameOf(*body)));
  });
  connect(frame_, &panels::FrameForm::sizeChanged, this, [this](const Eigen::Vector3d& size) {
    if (const auto body = tree_->chosen(); body && body->sizeMm)
      edit(draft_.withSize(*body, size), tr("edges of %1").arg(BodyTree::nameOf(*body)));
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
  tree_->setDraft(draft_);
  showBody();
  look();
}

void CellEditor::showBody() {
  const std::optional<DraftBody> body = tree_->chosen();
  frame_->setEnabled(body.has_value());
  const bool isPurgePlace = body && body->kind == DraftBody::Kind::PurgePlace;
  measure_->setEnabled(body && checked_.cell && !isPurgePlace);
  remove_->setEnabled(body && (isPurgePlace || body->kind == DraftBody::Kind::Obstacle));
  showPurgeButton();
  frameOf_->setText(
      body ? tr("%1, %2").arg(BodyTree::nameOf(*body), BodyTree::parentOf(*body, draft_))
           : tr("Select a body to move it"));
  frame_->setSizeMm(body ? body->sizeMm : std::nullopt);
  frame_->setRotationVisible(!isPurgePlace);
  if (body)
    frame_->setFrame(body->pose);
  scene::ViewState view;
  view.part = view.platform = false;
  view.cell = true;
  view.collisionSolids = solids_->isChecked();
  view.world = scene::World::Base;
  const bool shown = body && checked_.cell;
  if (shown) {
    const Eigen::Isometry3d frame = base_T_body(*body);
    view.marker = checked_.cell->base_T_work(checked_.cell->home()).inverse() * frame.translation();
    viewport_->setGizmoCentre(frame.translation(), frame.linear());
  }
  viewport_->setTool(!shown         ? viewer::Tool::None
                     : isPurgePlace ? viewer::Tool::Move
                                    : viewer::Tool::Frame);
  viewport_->setView(view);
}

void CellEditor::look() {
  save_->setEnabled(false);
  showStatus(tr("checking…"));
  inBackground(
      runner_,
      [text = draft_.text(), id = draft_.id(), process = process_, partKg = partKg_,
       before = drawing_](const base::RunContext& ctx) {
        Looked looked{pipeline::checkedCell(text, id, process, partKg, ctx), nullptr};
        if (const auto& cell = looked.checked.cell; cell && before && sameArm(*before, *cell))
          looked.drawing = scene::drawCell(*cell, *before);
        else if (cell)
          looked.drawing = scene::drawCell(*cell, robot::lookOf(cell->robot()));
        return looked;
      },
      [this](Looked&& looked) { take(std::move(looked)); });
}

void CellEditor::take(Looked&& looked) {
  checked_ = std::move(looked.checked);
  if (checked_.cell) {
    drawing_ = looked.drawing;
    viewport_->scene().setCell(drawing_);
    const QSignalBlocker quiet(carried_);
    carried_->setValue(checked_.cell->carriedKg());
  }
  if (!held_)
    showBody();
  if (checked_.cell && !std::exchange(framed_, true))
    viewport_->frameAll();
  viewport_->requestFrame();
  showFaults();
}

Eigen::Isometry3d CellEditor::base_T_body(const DraftBody& body) const {
  return base_T_parent(body, *checked_.cell) * body.pose;
}

// The handles are at the body's origin and rotate the body about it.
void CellEditor::drag(const viewer::GizmoChange& change, bool finished) {
  if (!held_ || !checked_.cell)
    return;
  Eigen::Isometry3d there = base_T_body(*held_);
  there.translation() += change.moveMm;
  there.linear() = change.rotation.toRotationMatrix() * there.linear();
  heldAt_ = base_T_parent(*held_, *checked_.cell).inverse(Eigen::Isometry) * there;
  if (!finished) {
    frame_->setFrame(heldAt_);
    preview();
    return;
  }
  const DraftBody body = *std::exchange(held_, std::nullopt);
  if (change.moveMm.isZero() &&
      change.rotation.angularDistance(Eigen::Quaterniond::Identity()) == 0.0)
    showDraft();
  else
    edit(draft_.withPose(body, heldAt_), tr("move %1").arg(BodyTree::nameOf(body)));
}

// Shows the cell as if the handle were released here, as often as it can be drawn.
void CellEditor::preview() {
  if (previewing_.running() || !drawing_)
    return;
  inBackground(
      previewing_,
      [draft = draft_.withPose(*held_, heldAt_), process = process_, before = drawing_] {
        return base::outcomeOf([&] {
          return scene::drawCell(pipeline::cellOfText(draft.text(), draft.id(), process), *before);
        });
      },
      [this, at = heldAt_](auto&& made) {
        const auto* drawing = std::get_if<std::shared_ptr<const scene::CellDrawing>>(&made);
        if (!held_ || !drawing)
          return;
        viewport_->scene().setCell(*drawing);
        viewport_->requestFrame();
        if (!heldAt_.isApprox(at))
          preview();
      });
}

void CellEditor::showStatus(const QString& text, std::optional<forms::Icon> icon) {
  if (icon)
    faultIcon_->setPixmap(forms::iconBeside(*this, *icon));
  else
    faultIcon_->clear();
  faults_->setText(text);
}

void CellEditor::showFaults() {
  if (!settled())
    return;
  QStringList lines;
  for (const cells::CellFault& fault : checked_.faults) {
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
  showStatus(lines.isEmpty() ? tr("No problems.") : lines.join(QLatin1Char('\n')),
             !checked_.cell || !nameGood ? forms::Icon::Blocked
             : lines.isEmpty()           ? forms::Icon::Good
                                         : forms::Icon::Warning);
  save_->setEnabled(checked_.cell && nameGood);
  rest_->setEnabled(checked_.cell != nullptr);
}

void CellEditor::addBox() {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  if (checked_.cell) {
    // Beside the plate, where it is visible.
    const Eigen::Vector3d plate = checked_.cell->base_T_work(checked_.cell->home()).translation();
    pose.translation() = plate + Eigen::Vector3d(0.0, 3.0 * kNewBoxMm, 0.0);
  }
  edit(draft_.withBox("box", pose, Eigen::Vector3d::Constant(kNewBoxMm)), tr("add a box"));
  tree_->choose(draft_.bodies().back());
}

// A cell has one place for purges, and only where its nozzle moves.
void CellEditor::showPurgeButton() {
  const std::vector<DraftBody> bodies = draft_.bodies();
  const auto nozzle = std::ranges::find(bodies, DraftBody::Kind::Nozzle, &DraftBody::kind);
  const bool moves = nozzle != bodies.end() && nozzle->onFlange;
  const bool isThere =
      std::ranges::find(bodies, DraftBody::Kind::PurgePlace, &DraftBody::kind) != bodies.end();
  addPurgePlace_->setEnabled(moves && !isThere && checked_.cell);
  addPurgePlace_->setToolTip(
      !moves    ? tr("Only a nozzle on the arm goes to a place for purges")
      : isThere ? tr("The cell has a place for purges: select it to move it")
                : tr("Where the nozzle's tip is when tools are changed and nozzles purged, instead "
                     "of a place that the plan chooses"));
}

// Beside the plate and a little above it, on the side of the new boxes.
void CellEditor::addPurgePlace() {
  if (!checked_.cell)
    return;
  constexpr double kBesideMm = 30.0, kAboveMm = 20.0;
  double edge = 0.0;
  if (const robot::Prism* plate = robot::plateOf(*checked_.cell))
    for (const Eigen::Vector2d& corner : plate->polygon)
      edge = std::max(edge, corner.y());
  const Eigen::Vector3d place = checked_.cell->base_T_work(checked_.cell->home()) *
                                Eigen::Vector3d(0.0, edge + kBesideMm, kAboveMm);
  edit(draft_.withPurgePlace(place.array().round().matrix()), tr("add the place for purges"));
  DraftBody added;
  added.kind = DraftBody::Kind::PurgePlace;
  tree_->choose(added);
}

// Keeps the coordinates of the file: they are correct if it was drawn in the cell's frame;
// otherwise the user moves the solids.
void CellEditor::addSolids(const QString& name, const std::vector<robot::Shape>& solids) {
  edit(draft_.withSolids(name.toStdString(), Eigen::Isometry3d::Identity(), solids),
       tr("add %1").arg(name));
  tree_->choose(draft_.bodies().back());
}

void CellEditor::measure() {
  const auto body = tree_->chosen();
  if (!body || !checked_.cell)
    return;
  const QString name = BodyTree::nameOf(*body);
  const bool tip = body->onFlange && body->kind == DraftBody::Kind::Nozzle;
  const std::unique_ptr<MeasureDialog> dialog(
      tip ? MeasureDialog::ofTip(name, checked_.cell->robot(), this)
          : MeasureDialog::ofFrame(
                name, body->onFlange ? tr("in the flange") : tr("in the robot's base, axes at 0"),
                this));
  if (dialog->exec() != QDialog::Accepted || !dialog->frame())
    return;
  Eigen::Isometry3d pose = *dialog->frame();
  if (tip)
    pose.linear() = body->pose.linear(); // Orientation is not measured
  else if (!body->onFlange)
    pose = base_T_parent(*body, *checked_.cell).inverse(Eigen::Isometry) * pose;
  edit(draft_.withPose(*body, pose), tr("measure %1").arg(name));
}

void CellEditor::removeBody() {
  if (const auto body = tree_->chosen(); body && (body->kind == DraftBody::Kind::Obstacle ||
                                                  body->kind == DraftBody::Kind::PurgePlace))
    edit(draft_.without(*body), tr("remove %1").arg(BodyTree::nameOf(*body)));
}

void CellEditor::rest() {
  if (!checked_.cell)
    return;
  rest_->setEnabled(false);
  faults_->setText(tr("searching…"));
  inBackground(
      runner_,
      [cell = checked_.cell, process = process_] {
        return std::pair(cells::clearestRest(*cell, process), cell);
      },
      [this](auto&& found) {
        const auto& [joints, cell] = found;
        if (joints) {
          edit(draft_.withHome(joints->head(cell->armDof()), cell->limits()), tr("home pose"));
        }
        if (!runner_.running())
          showFaults();
        if (!joints)
          faults_->setText(tr("No collision-free home pose over the plate was found."));
      });
}

void CellEditor::reject() {
  if (undo_->isClean() || mayDiscard())
    QDialog::reject();
}

bool CellEditor::mayDiscard() {
  QMessageBox box(QMessageBox::Warning, windowTitle(), tr("Discard the changes to this cell?"),
                  QMessageBox::NoButton, this);
  box.setObjectName(QStringLiteral("discardCellBox"));
  box.setInformativeText(tr("The last one is: %1.").arg(undo_->undoText()));
  const QPushButton* discard = box.addButton(tr("Discard"), QMessageBox::DestructiveRole);
  box.setDefaultButton(box.addButton(QMessageBox::Cancel));
  box.exec();
  return box.clickedButton() == discard;
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
