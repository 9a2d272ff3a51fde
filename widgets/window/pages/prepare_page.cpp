#include "window/pages/prepare_page.h"

#include "document/document.h"
#include "document/opening.h"
#include "forms/parameter_form.h"
#include "geometry/measures.h"
#include "language/words.h"
#include "layers/tool_assignment.h"
#include "modes/mode_stages.h"
#include "modes/mode_table.h"
#include "panels/mesh_panel.h"
#include "panels/object_tree.h"
#include "panels/placement_panel.h"
#include "pipeline/given_paths.h"
#include "pipeline/path_parameters.h"
#include "pipeline/payload.h"
#include "pipeline/planned_parameters.h"
#include "pipeline/stage_options.h"
#include "plan/finding_kinds.h"
#include "program/dialect.h"
#include "robot/cell_draft.h"
#include "window/cell/cell_editor.h"
#include "window/mesh_summary.h"
#include "window/milling/mill_dialog.h"
#include "window/pages/cell_view.h"
#include "window/pages/cut_tool.h"
#include "window/pages/measure_tool.h"
#include "window/pages/parts_view.h"
#include "window/pages/reach_view.h"
#include "window/pages/regions_tool.h"
#include "window/pages/stand_chooser.h"
#include "window/presenters/presenter.h"
#include "window/presets/preset_editor.h"

#include <QScrollArea>
#include <QTabWidget>
#include <QVBoxLayout>
#include <set>
#include <utility>
#include <vector>

namespace voluta::window {

using project::Stage;

namespace {
// Without the name of the parameter, which is beside it.
std::string problemText(const base::Error& error) {
  const QString problem = language::words(error.message());
  const QString remedy = language::words(error.remedy());
  return (remedy.isEmpty() ? problem : problem + ": " + remedy).toStdString();
}
} // namespace

PreparePage::PreparePage(const Workspace& workspace)
    : Page({"prepare", QT_TRANSLATE_NOOP("Commands", "&Prepare")}, workspace),
      handles_(workspace, *this), measure_(new MeasureTool(workspace, *this, this)),
      cut_(new CutTool(workspace, *this, this)), regions_(new RegionsTool(workspace, *this, this)),
      parts_(new PartsView(work(), *this)), stands_(new StandChooser(work(), handles_, this)),
      reach_(new ReachView(work(), handles_, this)),
      choices_(new ChoicesEditor(workspace.document, this)),
      presets_(new PresetEditor(workspace.document, this)) {
  build();
  listen();
}

void PreparePage::build() {
  placement_ = new panels::PlacementPanel;
  placement_->setObjectName("placement");
  mesh_ = new panels::MeshPanel;
  parameters_ = new forms::ParameterForm(pipeline::allParameters());
  parameters_->setObjectName("parameters");
  forms::ChoicesForm* choices = choices_->form();
  parameters_->setHeader(
      choices, [choices](const QStringList& words) { return choices->showMatching(words); });
  parameters_->setResearch(choices->research(), [choices](const QStringList& words) {
    return choices->showMatchingResearch(words);
  });
  auto* part = new QWidget;
  auto* column = new QVBoxLayout(part);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(placement_);
  column->addWidget(stands_->list());
  column->addWidget(reach_->panel());
  column->addWidget(mesh_);
  column->addStretch(1);
  tabs_ = new QTabWidget;
  tabs_->setObjectName("prepareTabs");
  tabs_->setDocumentMode(true);
  auto* settings = new QWidget;
  auto* settingsColumn = new QVBoxLayout(settings);
  settingsColumn->setContentsMargins(0, 0, 0, 0);
  settingsColumn->setSpacing(0);
  settingsColumn->addWidget(presets_->bar());
  settingsColumn->addWidget(parameters_, 1);
  tabs_->addTab(settings, QString());
  tabs_->addTab(scrolled(part), QString());
  side_ = new QWidget;
  auto* both = new QVBoxLayout(side_);
  both->setContentsMargins(0, 0, 0, 0);
  both->setSpacing(0);
  both->addWidget(parts_->list());
  both->addWidget(tabs_, 1);
  // The panel of a tool takes the place of the settings while the tool is open.
  const auto place = [this, both](QWidget* panel) {
    QScrollArea* area = scrolled(panel);
    area->hide();
    both->addWidget(area, 1);
    return [this, area](bool open) {
      area->setVisible(open);
      tabs_->setVisible(!cut_->isOpen() && !regions_->isOpen());
      work().shell.showStates();
    };
  };
  connect(cut_, &CutTool::opened, this, place(cut_->panel()));
  connect(regions_, &RegionsTool::opened, this, place(regions_->panel()));
}

void PreparePage::listen() {
  document::Document& document = work().document;
  connect(&document, &document::Document::choicesChanged, this, &PreparePage::showChoices);
  connect(&document, &document::Document::sourceChanged, this, &PreparePage::showPart);
  connect(&document, &document::Document::resultChanged, this, &PreparePage::showPart);
  connect(&work().presenter, &Presenter::partDrawn, this, [this] {
    placement_->setPlacement(handles_.placed());
    showPart();
  });
  connect(&work().viewport, &viewer::Viewport::toolChanged, this,
          [this](viewer::Tool tool) { placement_->setLayOnFace(tool == viewer::Tool::LayFlat); });

  using panels::PlacementPanel;
  connect(placement_, &PlacementPanel::placementChanged, &document, &document::Document::place);
  connect(placement_, &PlacementPanel::scaleChanged, &document, &document::Document::setScale);
  connect(placement_, &PlacementPanel::layOnFaceToggled, this,
          [this](bool on) { handles_.setTool(on ? viewer::Tool::LayFlat : viewer::Tool::None); });
  connect(mesh_, &panels::MeshPanel::repairToggled, this, [this](bool repair) {
    project::Choices choices = work().document.choices();
    choices.item().repair = repair;
    work().document.setChoices(choices, repair ? tr("repair the mesh") : tr("mesh as read"));
  });
  using forms::ParameterForm;
  connect(parameters_, &ParameterForm::changed, this, &PreparePage::setParameter);
  connect(parameters_, &ParameterForm::resetRequested, &document,
          &document::Document::resetParameter);
  connect(parameters_, &ParameterForm::resetAllRequested, &document,
          &document::Document::resetParameters);
}

QWidget* PreparePage::side() {
  return side_;
}

std::vector<ViewportInput*> PreparePage::inputs() {
  return {&handles_, measure_, cut_, regions_, reach_};
}

std::vector<Command> PreparePage::commands() {
  std::vector<Command> commands = handles_.commands();
  for (Command& command : measure_->commands())
    commands.push_back(std::move(command));
  for (Command& command : cut_->commands())
    commands.push_back(std::move(command));
  for (Command& command : regions_->commands())
    commands.push_back(std::move(command));
  for (Command& command : parts_->commands())
    commands.push_back(std::move(command));
  commands.push_back({"resetParameters",
                      "editMenu",
                      2,
                      QT_TRANSLATE_NOOP("Commands", "Reset all &parameters"),
                      QT_TRANSLATE_NOOP("Commands", "Resets every parameter to its default"),
                      {},
                      [this] { work().document.resetParameters(); },
                      {},
                      {},
                      "reset"});
  commands.push_back(
      {"editCell",
       "editMenu",
       3,
       QT_TRANSLATE_NOOP("Commands", "Edit &cell…"),
       QT_TRANSLATE_NOOP("Commands", "Robot, and positions of nozzle, plate and obstacles"),
       {},
       [this] { editCell(); }});
  commands.push_back(
      {"editLibrary",
       "editMenu",
       3,
       QT_TRANSLATE_NOOP("Commands", "Processes and &materials…"),
       QT_TRANSLATE_NOOP("Commands", "Nozzle, bead sizes, speeds, head; own processes and "
                                     "materials"),
       {},
       [this] { choices_->openLibrary(process::Shelf::Processes); }});
  commands.push_back({"millPart",
                      "exportMenu",
                      2,
                      QT_TRANSLATE_NOOP("Commands", "&Mill from a block…"),
                      QT_TRANSLATE_NOOP("Commands", "Mills the part out of a block and writes the "
                                                    "G-code, checked on the block"),
                      {},
                      [this] { millPart(); },
                      [this] { return placedPart() != nullptr; }});
  return commands;
}

std::shared_ptr<const geometry::TriangleMesh> PreparePage::placedPart() const {
  const document::Document& document = work().document;
  const auto placed = document.itemResult(Stage::Load);
  return placed && document.upToDate(Stage::Load) ? placed->job.item().part : nullptr;
}

void PreparePage::millPart() {
  if (const auto part = placedPart())
    (new MillDialog(part, work().document.name(), work().viewport.window()))->open();
}

void PreparePage::editCell() {
  document::Document& document = work().document;
  try {
    const project::Choices& choices = document.choices();
    const process::Process process = process::loadProcess(choices.tool().process);
    const auto placed = document.result(Stage::Load);
    CellEditor editor(robot::draftOfCell(choices.cell), process,
                      placed ? pipeline::solidKg(*placed) : 0.0, work().viewport.window());
    if (editor.exec() != QDialog::Accepted)
      return;
    choices_->retranslate(); // there is a new cell to choose
    project::Choices with = choices;
    with.cell = editor.savedId().toStdString();
    if (with.cell == choices.cell)
      document.filesChanged();
    else
      document.setChoices(with, tr("cell"));
  } catch (const base::Error& error) {
    work().shell.showMessage(tr("Edit cell"), language::words(error.whole()));
  }
}

PageState PreparePage::state() const {
  return work().opening.running() ? PageState::Running : Page::state();
}

void PreparePage::retranslate() {
  tabs_->setTabText(0, tr("Settings"));
  tabs_->setTabText(1, tr("Part"));
  choices_->retranslate();
  measure_->retranslate();
  parts_->show();
  showChoices();
}

void PreparePage::left() {
  work().viewport.setTool(viewer::Tool::None);
}

void PreparePage::draw(scene::ViewState& view) {
  const bool part = work().tree.isShown(panels::SceneItem::Part);
  // While tools are active, the part itself is shown.
  const bool made = part && work().document.voxelsAhead() && work().document.voxelsInPlace() &&
                    work().viewport.tool() == viewer::Tool::None;
  view.voxels = made && work().presenter.hasVoxels();
  view.pieces = made && work().presenter.hasPieces();
  view.part = part && !view.voxels && !view.pieces;
  view.otherParts = part;
  drawCellAtRest(view, work());
  reach_->draw(view);
  cut_->draw(view);
  regions_->draw(view);
}

int PreparePage::interest(const plan::Finding& finding) const {
  return plan::stageOf(finding) == Stage::Load ? 2 : 0;
}

void PreparePage::setParameter(const QString& key, const QString& text) {
  try {
    work().document.setParameter(key, text);
  } catch (const base::Error& error) {
    parameters_->setProblems({{key.toStdString(), problemText(error)}});
  }
}

namespace {
// Returns whether the parameter matters only to jobs with several tools.
bool ofTools(const std::string& key) {
  return key == "purgeMm3" || key.starts_with("fibre") || layers::toolParameters().find(key);
}

// Returns the settings that have no effect because the active part is printed along the tool-paths
// of its file; those of the job only if all parts are.
base::ParameterTable withoutEffect(const document::Document& document) {
  const project::Choices& job = document.jobChoices();
  const auto sources = document.sources();
  const auto followsFile = [&](std::size_t i) {
    return sources[i] && pipeline::takesGivenPaths(
                             *sources[i], pipeline::parameterValues(project::onlyItem(job, i)));
  };
  if (sources.size() != job.items.size() || !followsFile(document.active()))
    return {};
  bool areAll = true;
  for (std::size_t i = 0; i < sources.size(); ++i)
    areAll = areAll && followsFile(i);
  std::vector<base::ParameterSpec> specs =
      pipeline::plannedParameters(modes::findMode(document.choices().item().mode)).specs();
  std::erase_if(specs, [&](const base::ParameterSpec& spec) {
    return !areAll && spec.scope == base::ParameterScope::Job;
  });
  return base::ParameterTable(std::move(specs));
}
} // namespace

void PreparePage::showChoices() {
  const project::Choices& c = work().document.choices();
  choices_->show();
  presets_->show();
  const base::ParameterTable table = document::parametersFor(c);
  // Changed settings are those that differ from the preset.
  parameters_->setDefaults(pipeline::withPresetDefaults(table, presets_->settings()));
  const base::ParameterTable ofPrograms = program::programParameters(); // shown on the Export page
  const base::ParameterTable ofPaths = pipeline::pathShapeParameters();
  const auto source = work().document.source();
  hasPaths_ = source && source->toolPaths;
  const base::ParameterTable ofPlanning = withoutEffect(work().document);
  std::set<std::string> applying;
  for (const base::ParameterSpec& spec : table.specs())
    if (modes::takesParameter(modes::findMode(c.item().mode), spec.key) &&
        !ofPrograms.find(spec.key) && (c.tools.size() > 1 || !ofTools(spec.key)) &&
        (hasPaths_ || !ofPaths.find(spec.key)) && !ofPlanning.find(spec.key))
      applying.insert(spec.key);
  parameters_->setApplying(applying);
  pipeline::Settings values = pipeline::givenParameters(c);
  for (const auto& [key, text] : presets_->settings())
    if (const base::ParameterSpec* spec = table.find(key))
      values.emplace(key, base::formatParameter(spec->defaultValue));
  parameters_->setValues(values);
  showProblems();
  placement_->setOnPlate(!modes::findMode(c.item().mode).aroundRod);
  placement_->setPlacement(handles_.placed());
  mesh_->setRepair(c.item().repair);
  showPart();
}

// Shows a problem below its field only.
void PreparePage::showProblems() {
  std::map<std::string, std::string> problems;
  if (const base::Error* error = work().document.unusable())
    if (const auto* key = std::get_if<std::string>(&error->context().data()))
      problems.emplace(*key, problemText(*error));
  parameters_->setProblems(problems);
}

void PreparePage::showPart() {
  showProblems();
  const document::Document& document = work().document;
  const auto source = document.source();
  if (hasPaths_ != (source && source->toolPaths))
    showChoices(); // Parameters of tool-paths apply to parts that bring some
  const auto placed = document.itemResult(Stage::Load);
  placement_->setEnabled(static_cast<bool>(source));
  placement_->setScale(QString::fromStdString(document.choices().item().scale),
                       placed && document.upToDate(Stage::Load) ? placed->job.item().scale : 0.0);
  if (!source) {
    mesh_->setSummary(std::nullopt);
    return;
  }
  // Until the part is placed anew, the size that was typed stays.
  if (placed && document.upToDate(Stage::Load) && placed->job.item().part)
    placement_->setSizeMm(geometry::bounds(*placed->job.item().part).sizes());
  mesh_->setSummary(meshSummary(*source, placed ? placed->job.report.item().model.volumeMm3
                                                : source->found.volumeMm3));
}

} // namespace voluta::window
