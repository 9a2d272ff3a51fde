// What happens when something changes: the document, a run, a slider, a handle.
#include "base/files.h"
#include "forms/choices_form.h"
#include "forms/parameter_form.h"
#include "geometry/placement.h"
#include "panels/export_panel.h"
#include "panels/findings_panel.h"
#include "panels/layer_info.h"
#include "panels/mesh_panel.h"
#include "panels/placement_panel.h"
#include "pipeline/outputs.h"
#include "program/dialect.h"
#include "timeline/joint_plots.h"
#include "timeline/layer_range_slider.h"
#include "timeline/timeline_bar.h"
#include "window/legend_view.h"
#include "window/main_window.h"
#include "window/mesh_summary.h"
#include "window/program_preview.h"
#include "window/status_line.h"
#include "window/welcome.h"

#include <QActionGroup>
#include <QDragEnterEvent>
#include <QFileInfo>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QScreen>
#include <QSettings>
#include <algorithm>
#include <cmath>
#include <limits>

namespace voluta::window {

namespace {
using document::StageState;
using pipeline::Stage;

constexpr double kFindingRadiusMm = 15.0;

// A page is worth what its stages are worth; the worst counts.
PageState pageState(const document::Document& document, std::initializer_list<Stage> stages) {
  PageState worst = PageState::Nothing;
  const auto rank = [](PageState s) {
    switch (s) {
    case PageState::Nothing:
      return 0;
    case PageState::Done:
      return 1;
    case PageState::OutOfDate:
      return 2;
    case PageState::Blocked:
      return 3;
    default:
      return 4;
    }
  };
  for (const Stage stage : stages) {
    PageState one = PageState::Nothing;
    switch (document.state(stage)) {
    case StageState::Nothing:
      one = PageState::Nothing;
      break;
    case StageState::Running:
      one = PageState::Running;
      break;
    case StageState::Done:
      one = PageState::Done;
      break;
    case StageState::OutOfDate:
      one = PageState::OutOfDate;
      break;
    case StageState::Blocked:
    case StageState::Failed:
      one = PageState::Blocked;
      break;
    }
    if (rank(one) > rank(worst))
      worst = one;
  }
  return worst;
}

// What undo says of a choice.
QString editNameOf(const QString& field) {
  if (field == "mode")
    return MainWindow::tr("way of building");
  if (field == "growth")
    return MainWindow::tr("growth");
  if (field == "platform")
    return MainWindow::tr("platform");
  if (field == "cell")
    return MainWindow::tr("cell");
  if (field == "process")
    return MainWindow::tr("process");
  return MainWindow::tr("seed");
}

QString vectorText(const Eigen::Vector3d& v) {
  return QString::fromUtf8("%1 × %2 × %3 mm")
      .arg(v.x(), 0, 'f', 1)
      .arg(v.y(), 0, 'f', 1)
      .arg(v.z(), 0, 'f', 1);
}

// A result's files stay where they are; the panels hold on to the result through them.
std::vector<panels::ExportFile>
exportFiles(const std::shared_ptr<const pipeline::CheckedProgram>& checked) {
  std::vector<panels::ExportFile> files;
  for (const plan::ProgramFile& file : checked->program.files)
    files.push_back({QString::fromStdString(pipeline::writtenName(*checked, file)),
                     std::shared_ptr<const std::string>(checked, &file.text)});
  return files;
}
} // namespace

// ---- connections

void MainWindow::connectDocument() {
  connect(&document_, &document::Document::choicesChanged, this, &MainWindow::showChoices);
  connect(&document_, &document::Document::sourceChanged, this, &MainWindow::showPart);
  connect(&document_, &document::Document::stateChanged, this, &MainWindow::showStates);
  connect(&document_, &document::Document::resultChanged, this, [this] {
    showPart();
    showFindings();
    showExport();
  });
  const auto title = [this] { setWindowTitle(document_.name() + "[*] – Voluta"); };
  connect(&document_, &document::Document::nameChanged, this, title);
  connect(&document_, &document::Document::dirtyChanged, this,
          [this](bool dirty) { setWindowModified(dirty); });
  title();
  // The first stage is quick: the part lies where the numbers say without a word from the user.
  connect(&document_, &document::Document::edited, this, [this] {
    if (!planning_.running() && document_.source() && document_.sourceReady())
      planning_.plan(Stage::Load);
  });

  connect(&planning_, &document::Planning::started, this, &MainWindow::showStates);
  connect(&planning_, &document::Planning::progressed, status_, &StatusLine::showProgress);
  connect(&planning_, &document::Planning::finished, this, [this] {
    status_->showIdle(summaryText());
    showStates();
    showExport();
    if (const auto pending = std::exchange(pendingExport_, std::nullopt))
      writePrograms(pending->folder, pending->formats, pending->includeRefused);
  });
  connect(&planning_, &document::Planning::cancelled, this, [this] {
    pendingExport_.reset();
    showStates();
    status_->showIdle(tr("Cancelled. The last results stay on show."));
  });
  connect(&planning_, &document::Planning::failed, this, [this](Stage, const QString& message) {
    pendingExport_.reset();
    showStates();
    status_->showIdle(message);
    tell(tr("The run has stopped"), message);
  });

  connect(&opening_, &document::Opening::started, this, [this](const QString& path) {
    status_->showIdle(tr("Opening %1").arg(QFileInfo(path).fileName()));
    showStates();
  });
  connect(&opening_, &document::Opening::progressed, status_, &StatusLine::showProgress);
  connect(&opening_, &document::Opening::opened, this, [this](const QString& path, bool project) {
    if (!path.startsWith("sample:"))
      recent_.add(path);
    marker_.reset();
    if (project) {
      setPage(document_.result(Stage::Layers) ? Page::Layers : Page::Prepare);
      status_->showIdle(summaryText());
    } else {
      setPage(Page::Prepare);
    }
  });
  connect(&opening_, &document::Opening::repaired, this, [this] {
    status_->showIdle(tr("Ready. Press Plan."));
    planning_.plan(Stage::Load);
  });
  connect(&opening_, &document::Opening::cancelled, this,
          [this] { status_->showIdle(tr("Cancelled.")); });
  connect(&opening_, &document::Opening::failed, this,
          [this](const QString& path, const QString& message) {
            status_->showIdle(message);
            tell(tr("%1 cannot be opened").arg(QFileInfo(path).fileName()), message);
          });

  connect(&saving_, &document::Saving::saved, this, [this](const QString& file) {
    recent_.add(file);
    status_->showIdle(tr("Saved %1").arg(QFileInfo(file).fileName()));
    if (auto then = std::exchange(afterSave_, nullptr))
      then();
  });
  connect(&saving_, &document::Saving::failed, this,
          [this](const QString& file, const QString& message) {
            afterSave_ = nullptr;
            tell(tr("%1 is not saved").arg(QFileInfo(file).fileName()), message);
          });
  connect(autosave_.get(), &document::Autosave::failed, this,
          [this](const QString& message) { status_->showIdle(message); });
  connect(&recent_, &document::RecentFiles::dead, this,
          [this](const QString&, const QString& message) { tell(tr("Open recent"), message); });

  connect(viewport_, &viewer::VtkView::openGlMissing, this, [this](const QString& found) {
    welcome_->setMessage(tr("The viewport needs OpenGL 3.2; this display offers %1. Update the "
                            "graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1. Planning and export "
                            "work without a picture.")
                             .arg(found));
    welcome_->show();
  });
}

void MainWindow::connectPages() {
  connect(flow_, &FlowBar::pageChosen, this, &MainWindow::setPage);
  connect(welcome_, &Welcome::openRequested, this, &MainWindow::chooseFile);
  connect(welcome_, &Welcome::sampleRequested, this, [this] { open("sample:vase"); });

  // Prepare
  connect(placement_, &panels::PlacementPanel::placementChanged, &document_,
          &document::Document::place);
  connect(placement_, &panels::PlacementPanel::scaleChanged, &document_,
          &document::Document::setScale);
  connect(placement_, &panels::PlacementPanel::layOnFaceToggled, this,
          [this](bool on) { setTool(on ? viewer::Tool::LayFlat : viewer::Tool::None); });
  connect(mesh_, &panels::MeshPanel::repairToggled, this, [this](bool repair) {
    pipeline::Choices choices = document_.choices();
    choices.repair = repair;
    document_.setChoices(choices, repair ? tr("repair the mesh") : tr("mesh as read"));
  });
  connect(choices_, &forms::ChoicesForm::changed, this,
          [this](const QString& field, const QString& text) {
            pipeline::Choices c = document_.choices();
            const std::string value = text.toStdString();
            if (field == "mode")
              c.mode = value;
            else if (field == "growth")
              c.growth = value;
            else if (field == "platform")
              c.platform = value;
            else if (field == "cell")
              c.cell = value;
            else if (field == "process")
              c.process = value;
            else if (field == "seed")
              c.seed = text.toInt();
            document_.setChoices(c, editNameOf(field));
          });
  connect(parameters_, &forms::ParameterForm::changed, this,
          [this](const QString& key, const QString& text) {
            try {
              document_.setParameter(key, text);
            } catch (const base::Error& error) {
              showChoices();
              tell(tr("Not a value for this parameter"), QString::fromStdString(error.what()));
            }
          });
  connect(parameters_, &forms::ParameterForm::resetRequested, &document_,
          &document::Document::resetParameter);
  connect(parameters_, &forms::ParameterForm::resetAllRequested, &document_,
          &document::Document::resetParameters);
  connect(tree_, &panels::ObjectTree::visibilityChanged, this, &MainWindow::showView);

  connect(viewport_, &viewer::Viewport::gizmoStarted, this, [this] {
    beforeGizmo_ = document_.choices();
    const auto placed = document_.result(Stage::Load);
    scaleBeforeGizmo_ = placed ? placed->job.scale : 1.0;
  });
  connect(viewport_, &viewer::Viewport::gizmoDragged, this, &MainWindow::applyGizmo);
  connect(viewport_, &viewer::Viewport::toolChanged, this, [this](viewer::Tool tool) {
    placement_->setLayOnFace(tool == viewer::Tool::LayFlat);
    for (QAction* action : tools_->actions())
      action->setChecked(action->data().toInt() == static_cast<int>(tool));
  });
  connect(viewport_, &viewer::Viewport::clicked, this, [this](const auto& hit) {
    if (viewport_->tool() == viewer::Tool::LayFlat && hit && hit->what == scene::Hit::What::Part) {
      setTool(viewer::Tool::None);
      placeOnFace(hit->normal);
    } else if (page() == Page::Simulate && hit && hit->what == scene::Hit::What::Path &&
               presenter_->clock()) {
      if (const auto time = presenter_->clock()->timeOfWaypoint(hit->waypoint))
        setTime(*time);
    }
  });
  connect(viewport_, &viewer::Viewport::hovered, this, [this](const auto& hit) {
    if (page() == Page::Layers)
      showLayerMeasures(hit && hit->layer >= 0 ? hit->layer : layers_->last());
  });

  // Layers
  connect(options_, &ViewOptions::changed, this, &MainWindow::showView);
  connect(options_, &ViewOptions::dragging, viewport_, &viewer::Viewport::setDragging);
  connect(layers_, &timeline::LayerRangeSlider::rangeChanged, this, [this] {
    showMoves();
    showView();
    showLayerMeasures(layers_->last());
  });
  connect(layers_, &timeline::LayerRangeSlider::dragging, viewport_,
          &viewer::Viewport::setDragging);
  connect(timeline_, &timeline::TimelineBar::dragging, viewport_, &viewer::Viewport::setDragging);
  connect(timeline_, &timeline::TimelineBar::playingChanged, viewport_,
          &viewer::Viewport::setDragging);
  connect(timeline_, &timeline::TimelineBar::moveChanged, this, &MainWindow::showView);
  connect(timeline_, &timeline::TimelineBar::layerStepRequested, this, [this](int step) {
    const int last = std::clamp(layers_->last() + step, 0, std::max(0, layers_->layerCount() - 1));
    layers_->setRange(layers_->single() ? last : std::min(layers_->first(), last), last);
  });

  // Simulate and Export
  connect(timeline_, &timeline::TimelineBar::timeChanged, this, &MainWindow::setTime);
  connect(plots_, &timeline::JointPlots::timeClicked, this, &MainWindow::setTime);
  connect(export_, &panels::ExportPanel::exportRequested, this, &MainWindow::exportPrograms);
  connect(export_, &panels::ExportPanel::formatsChanged, this, [this](const QStringList& ids) {
    pipeline::Choices c = document_.choices();
    c.formats.clear();
    for (const QString& id : ids)
      c.formats.push_back(id.toStdString());
    document_.setChoices(c, tr("program formats"));
  });
  connect(export_, &panels::ExportPanel::folderChanged, this,
          [](const QString& folder) { QSettings().setValue("export/folder", folder); });
  connect(export_, &panels::ExportPanel::previewFormatChanged, this, [this] { showPreview(); });
  connect(export_, &panels::ExportPanel::lineClicked, this, [this](int file, qulonglong line) {
    if (!presenter_->clock())
      return;
    if (const auto time = preview_->timeOf(*presenter_->clock(), static_cast<std::uint32_t>(file),
                                           static_cast<std::uint32_t>(line)))
      setTime(*time);
  });
  connect(preview_, &ProgramPreview::linesReady, this, [this] { setTime(timeline_->timeS()); });

  // Findings
  connect(findings_, &panels::FindingsPanel::activated, this, &MainWindow::goTo);

  // What the presenter has prepared
  connect(presenter_, &Presenter::partDrawn, this, [this](bool another) {
    viewport_->scene().setPartPreview(Eigen::Affine3d::Identity());
    if (!presenter_->partBox().isEmpty())
      viewport_->setGizmoCentre(presenter_->partBox().center());
    showPart();
    showView();
    if (another)
      viewport_->frameAll();
  });
  const auto layersThere = [this] {
    options_->setAvailable(presenter_->hasVoxels(), presenter_->hasLayers(),
                           presenter_->hasPaths());
    const auto facts = presenter_->facts();
    layers_->setLayers(presenter_->layerCount(),
                       facts && static_cast<int>(facts->topsMm.size()) == presenter_->layerCount()
                           ? facts->topsMm
                           : std::vector<double>{});
    showMoves();
    showView();
    showLayerMeasures(layers_->last());
  };
  connect(presenter_, &Presenter::voxelsDrawn, this, layersThere);
  connect(presenter_, &Presenter::layersDrawn, this, layersThere);
  connect(presenter_, &Presenter::pathsDrawn, this, layersThere);
  connect(presenter_, &Presenter::factsReady, this, layersThere);
  connect(presenter_, &Presenter::motionReady, this, [this] {
    timeline_->setClock(presenter_->clock());
    const auto& clock = presenter_->clock();
    std::vector<robot::JointLimits> limits;
    if (const auto motion = document_.result(Stage::Motion); motion && motion->cell)
      limits = motion->cell->limits();
    plots_->setTrajectory(clock ? clock->trajectory() : nullptr, std::move(limits));
    showView();
  });
}

// ---- opening and closing

void MainWindow::open(const QString& path) {
  const auto start = [this, path] {
    planning_.cancel();
    opening_.open(path);
  };
  // Another part is an edit, which undo takes back; another project is not.
  if (path.endsWith(".voluta", Qt::CaseInsensitive))
    afterSaved(start);
  else
    start();
}

void MainWindow::offerRecovered() {
  const std::vector<document::Recovered> left = document::recoverable();
  if (left.empty())
    return;
  const document::Recovered& latest = left.front();
  QMessageBox box(QMessageBox::Question, tr("Recover unsaved work"),
                  tr("Voluta ended unexpectedly. “%1” was kept on %2.")
                      .arg(latest.name, QLocale().toString(latest.time, QLocale::ShortFormat)),
                  QMessageBox::NoButton, this);
  box.setObjectName("recoverBox");
  QPushButton* recover = box.addButton(tr("Recover"), QMessageBox::AcceptRole);
  QPushButton* discard = box.addButton(tr("Discard"), QMessageBox::DestructiveRole);
  box.addButton(tr("Later"), QMessageBox::RejectRole);
  box.exec();
  if (box.clickedButton() == recover) {
    // The copy stays until the document holds it.
    connect(
        &opening_, &document::Opening::opened, autosave_.get(),
        [this, latest] { autosave_->adopt(latest); }, Qt::SingleShotConnection);
    opening_.openRecovered(latest);
  } else if (box.clickedButton() == discard) {
    document::discardRecovered(latest);
  }
}

void MainWindow::afterSaved(std::function<void()> then) {
  if (!document_.dirty()) {
    then();
    return;
  }
  QMessageBox box(QMessageBox::Warning, tr("Unsaved changes"),
                  tr("“%1” has changes that are not saved.").arg(document_.name()),
                  QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  box.setObjectName("unsavedBox");
  box.setDefaultButton(QMessageBox::Save);
  const int answer = box.exec();
  if (answer == QMessageBox::Discard) {
    then();
  } else if (answer == QMessageBox::Save) {
    afterSave_ = std::move(then);
    save();
  }
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls())
    event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  for (const QUrl& url : event->mimeData()->urls())
    if (url.isLocalFile()) {
      event->acceptProposedAction();
      open(url.toLocalFile());
      return;
    }
}

void MainWindow::tell(const QString& title, const QString& message) {
  auto* box = new QMessageBox(QMessageBox::Warning, title, message, QMessageBox::Ok, this);
  box->setObjectName("messageBox");
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->open();
}

// ---- running

void MainWindow::plan() {
  if (!document_.source()) {
    chooseFile();
    return;
  }
  if (page() == Page::Prepare)
    setPage(Page::Layers);
  planning_.plan(Stage::Replay);
}

void MainWindow::cancel() {
  if (planning_.running())
    planning_.cancel();
  else if (opening_.running())
    opening_.cancel();
}

QString MainWindow::summaryText() const {
  const auto result = document_.lastResult();
  if (!result || !result->job.reached || *result->job.reached == Stage::Load)
    return document_.source() ? tr("Ready. Press Plan.") : QString();
  const pipeline::Report& r = result->job.report;
  const QLocale locale;
  QStringList parts;
  if (r.decomposition.voxels > 0)
    parts << tr("%1 voxels, %2 missed")
                 .arg(locale.toString(static_cast<qulonglong>(r.decomposition.voxels)),
                      locale.toString(static_cast<qulonglong>(r.decomposition.missedVoxels)));
  if (r.layers.count > 0)
    parts << tr("%1 layers").arg(r.layers.count);
  if (r.toolpath.waypoints > 0)
    parts << tr("%1 waypoints").arg(locale.toString(static_cast<qulonglong>(r.toolpath.waypoints)));
  if (r.toolpath.materialMm3 > 0)
    parts << tr("%1 cm³").arg(locale.toString(r.toolpath.materialMm3 / 1000.0, 'f', 1));
  if (r.motion.durationS > 0)
    parts << durationText(r.motion.durationS);
  if (*result->job.reached == Stage::Replay)
    parts << (r.replay.passed ? tr("replay passed") : tr("replay not passed"));
  return parts.join(", ");
}

void MainWindow::showStates() {
  if (!flow_)
    return;
  flow_->setState(Page::Prepare,
                  opening_.running() ? PageState::Running : pageState(document_, {Stage::Load}));
  flow_->setState(Page::Layers,
                  pageState(document_, {Stage::Decompose, Stage::Layers, Stage::Toolpath}));
  flow_->setState(Page::Simulate, pageState(document_, {Stage::Motion}));
  flow_->setState(Page::Export, pageState(document_, {Stage::Replay}));
  const bool busy = planning_.running() || opening_.running();
  cancel_->setEnabled(busy);
  plan_->setEnabled(static_cast<bool>(document_.source()));
  if (QAction* layers = findChild<QAction*>("planLayers"))
    layers->setEnabled(plan_->isEnabled());
  tools_->setEnabled(page() == Page::Prepare && document_.source());
  for (const char* id : {"dropToPlate", "centrePart"})
    findChild<QAction*>(id)->setEnabled(static_cast<bool>(document_.source()));
  QString text = summaryText();
  const auto result = document_.lastResult();
  if (result && result->job.reached && !document_.upToDate(*result->job.reached))
    text = tr("Out of date: %1").arg(text);
  summary_->setText(text);
}

// ---- what is shown of the document

void MainWindow::showChoices() {
  const pipeline::Choices& c = document_.choices();
  choices_->setTexts({QString::fromStdString(c.mode), QString::fromStdString(c.growth),
                      QString::fromStdString(c.platform), QString::fromStdString(c.cell),
                      QString::fromStdString(c.process), c.seed});
  parameters_->setValues(c.parameters);
  placement_->setPlacement(c.placement);
  mesh_->setRepair(c.repair);
  tree_->setText(panels::SceneItem::Platform, {}, QString::fromStdString(c.platform));
  tree_->setText(panels::SceneItem::Cell, {}, QString::fromStdString(c.cell));
  status_->setCell(QString::fromStdString(c.cell));
  showPart();
}

void MainWindow::showPart() {
  const auto source = document_.source();
  welcome_->setVisible(!source);
  const auto placed = document_.result(Stage::Load);
  const bool current = placed && document_.upToDate(Stage::Load);
  placement_->setEnabled(static_cast<bool>(source));
  placement_->setScale(QString::fromStdString(document_.choices().scale),
                       current ? placed->job.scale : 0.0);
  if (!source) {
    mesh_->setSummary(std::nullopt);
    tree_->setText(panels::SceneItem::Part, {}, {});
    status_->setPart({});
    return;
  }
  Eigen::Vector3d size = Eigen::Vector3d::Zero();
  if (!presenter_->partBox().isEmpty())
    size = presenter_->partBox().sizes();
  placement_->setSizeMm(size);
  tree_->setText(panels::SceneItem::Part, QString::fromStdString(source->name), vectorText(size));
  status_->setPart(vectorText(size));
  mesh_->setSummary(meshSummary(*source));
}

void MainWindow::showFindings() {
  const auto result = document_.lastResult();
  findings_->setPlanned(result && result->job.reached && *result->job.reached > Stage::Load);
  findings_->setFindings(result ? result->job.report.findings : plan::Findings{});
  std::vector<timeline::Mark> marks;
  if (result)
    for (const plan::Finding& finding : result->job.report.findings)
      if (finding.whenS)
        marks.push_back({*finding.whenS, finding.blocking, QString::fromStdString(finding.reason)});
  timeline_->setMarks(std::move(marks));
}

void MainWindow::showExport() {
  if (page() != Page::Export)
    return;
  const auto result = document_.result(Stage::Replay);
  const auto motion = document_.result(Stage::Motion);
  const auto cell = motion ? motion->cell : nullptr;
  std::vector<panels::ExportFormat> formats;
  QStringList checked;
  for (const std::string& id : document_.choices().formats)
    checked << QString::fromStdString(id);
  for (const program::Dialect& dialect : program::dialects()) {
    panels::ExportFormat format;
    format.id = QString::fromUtf8(dialect.id.data(), static_cast<qsizetype>(dialect.id.size()));
    format.label =
        QString::fromUtf8(dialect.label.data(), static_cast<qsizetype>(dialect.label.size()));
    format.foreign = cell && program::isForeign(dialect, *cell);
    if (result)
      for (const auto& program : result->checked)
        if (program->program.format == dialect.id) {
          format.state =
              program->passed ? panels::VerdictState::Passed : panels::VerdictState::Refused;
          if (!program->passed)
            format.whyRefused = QString::fromStdString(program->failed);
          format.verdict = program->verdict;
          format.files = exportFiles(program);
          if (document_.choices().formats.empty())
            checked << format.id;
        }
    formats.push_back(std::move(format));
  }
  export_->setFormats(std::move(formats));
  export_->setChecked(checked);
  QString reason;
  if (!document_.source())
    reason = tr("Open a part first.");
  else if (planning_.running())
    reason = tr("Planning is under way.");
  else if (!result || result->checked.empty())
    reason = tr("Nothing is planned yet. Press Plan.");
  else if (!document_.upToDate(Stage::Replay))
    reason = tr("The programs are out of date. Press Plan.");
  export_->setBlockedReason(reason);
  showPreview();
}

void MainWindow::showPreview() {
  const auto result = document_.result(Stage::Replay);
  std::shared_ptr<const pipeline::CheckedProgram> shown;
  if (result)
    for (const auto& program : result->checked)
      if (QString::fromStdString(program->program.format) == export_->previewFormat())
        shown = program;
  preview_->setProgram(shown, result ? result->job.trajectory : nullptr);
}

void MainWindow::showLayerMeasures(int layer) {
  const auto facts = presenter_->facts();
  if (facts && layer >= 0 && layer < static_cast<int>(facts->measures.size()))
    layerInfo_->setMeasures(facts->measures[static_cast<std::size_t>(layer)]);
  else
    layerInfo_->setMeasures(std::nullopt);
}

// ---- the picture

bool MainWindow::shows(panels::SceneItem item) const {
  return tree_->isShown(item);
}

scene::ViewState MainWindow::viewState() const {
  using panels::SceneItem;
  scene::ViewState v;
  const ViewChoices& chosen = options_->choices();
  v.platform = shows(SceneItem::Platform);
  v.marker = marker_;
  v.colourBy = chosen.colourBy;
  v.beads = chosen.beads;
  v.sectionOn = chosen.section && !presenter_->partBox().isEmpty();
  if (v.sectionOn) {
    const Eigen::AlignedBox3d& box = presenter_->partBox();
    v.sectionNormal =
        (chosen.sectionFlipped ? -1.0 : 1.0) * Eigen::Vector3d::Unit(chosen.sectionAxis);
    v.sectionOrigin = box.min() + chosen.sectionPlace * box.sizes();
  }
  switch (page()) {
  case Page::Prepare:
    v.part = shows(SceneItem::Part);
    v.cell = false;
    break;
  case Page::Layers: {
    LayerSubject subject = chosen.subject;
    if (subject == LayerSubject::Furthest)
      subject = presenter_->hasPaths()    ? LayerSubject::Paths
                : presenter_->hasLayers() ? LayerSubject::Layers
                                          : LayerSubject::Voxels;
    v.voxels = subject == LayerSubject::Voxels && presenter_->hasVoxels();
    v.layers = subject == LayerSubject::Layers && presenter_->hasLayers();
    v.paths = subject == LayerSubject::Paths && presenter_->hasPaths();
    v.part = (chosen.part && shows(SceneItem::Part)) || (!v.voxels && !v.layers && !v.paths);
    v.partOpacity = v.voxels || v.layers || v.paths ? 0.25 : 1.0;
    v.travels = chosen.travels;
    v.firstLayer = layers_->first();
    v.lastLayer = layers_->layerCount() > 0 ? layers_->last() : scene::kAllLayers;
    if (v.paths && timeline_->move() < presenter_->movesOf(layers_->last()))
      v.moves = static_cast<std::size_t>(timeline_->move());
    break;
  }
  case Page::Simulate:
  case Page::Export:
    v.part = false;
    v.sectionOn = false;
    v.paths = presenter_->hasPaths() && shows(SceneItem::Part);
    v.materialColour = true;
    if (const auto& clock = presenter_->clock(); clock && !clock->empty()) {
      v.world = scene::World::Base;
      v.cell = shows(SceneItem::Cell);
      const auto role = [&](robot::BodyRole r) -> bool& {
        return v.roles[static_cast<std::size_t>(r)];
      };
      role(robot::BodyRole::Link) = shows(SceneItem::Robot);
      role(robot::BodyRole::Head) = role(robot::BodyRole::Holder) = shows(SceneItem::Nozzle);
      role(robot::BodyRole::Platform) = shows(SceneItem::Plate);
      v.joints = clock->jointsAt(timeline_->timeS());
      v.printedWaypoints = clock->printedWaypoints(timeline_->timeS());
    } else {
      v.part = shows(SceneItem::Part) && !v.paths;
    }
    break;
  }
  return v;
}

void MainWindow::showView() {
  viewport_->setView(viewState());
  legend_->setLegend(page() == Page::Layers ? viewport_->scene().legend() : scene::Legend{});
}

void MainWindow::showMoves() {
  if (page() == Page::Layers)
    timeline_->setMoveCount(presenter_->movesOf(layers_->last()));
}

void MainWindow::setTime(double timeS) {
  timeline_->setTimeS(timeS);
  plots_->setTimeS(timeS);
  if (page() == Page::Export && presenter_->clock())
    if (const auto line = preview_->lineAt(*presenter_->clock(), timeS))
      export_->showLine(line->file, line->line);
  if (page() == Page::Simulate || page() == Page::Export)
    showView();
}

void MainWindow::goTo(const plan::Finding& finding) {
  marker_ = finding.where;
  const auto& clock = presenter_->clock();
  const bool motion = finding.stage == "motion" || finding.stage == "replay";
  if (finding.whenS && clock) {
    setPage(Page::Simulate);
    setTime(*finding.whenS);
  } else if (motion && clock) {
    setPage(Page::Simulate);
  } else if (finding.stage == "load") {
    setPage(Page::Prepare);
  } else {
    setPage(Page::Layers);
  }
  if (finding.where && page() == Page::Layers)
    if (const auto plan = document_.result(Stage::Toolpath);
        plan && plan->job.toolPlan && presenter_->hasPaths()) {
      // The layer whose bead passes nearest.
      double best = std::numeric_limits<double>::infinity();
      int layer = 0;
      for (const plan::ToolPath& path : plan->job.toolPlan->paths)
        for (std::size_t i = path.first; i < path.first + path.count; ++i)
          if (const double d = (plan->job.toolPlan->position[i] - *finding.where).squaredNorm();
              d < best) {
            best = d;
            layer = path.layer;
          }
      layers_->setRange(0, layer);
    }
  showView();
  if (finding.where)
    viewport_->lookAt(*finding.where, kFindingRadiusMm);
}

// ---- placing by hand

void MainWindow::setTool(viewer::Tool tool) {
  viewport_->setTool(document_.source() ? tool : viewer::Tool::None);
}

void MainWindow::applyGizmo(const viewer::GizmoChange& change, bool finished) {
  const Eigen::Vector3d centre = presenter_->partBox().isEmpty() ? Eigen::Vector3d::Zero().eval()
                                                                 : presenter_->partBox().center();
  Eigen::Affine3d preview = Eigen::Affine3d::Identity();
  preview.translate(centre + change.moveMm).rotate(change.turn).scale(change.scale);
  preview.translate(-centre);
  viewport_->scene().setPartPreview(preview);
  viewport_->requestFrame();
  if (!finished)
    return;
  geometry::Placement placement = beforeGizmo_.placement;
  placement.centreMm += change.moveMm.head<2>();
  placement.liftMm = std::max(0.0, placement.liftMm + change.moveMm.z());
  placement.rotation = (change.turn * placement.rotation).normalized();
  switch (viewport_->tool()) {
  case viewer::Tool::Move:
    document_.place(placement, tr("move"));
    break;
  case viewer::Tool::Turn:
    document_.place(placement, tr("turn"));
    break;
  case viewer::Tool::Scale:
    if (change.scale != 1.0)
      document_.setScale(QString::number(scaleBeforeGizmo_ * change.scale, 'g', 6));
    break;
  default:
    break;
  }
  // A drag that came to nothing leaves no new drawing that would take the preview's place.
  if (document_.upToDate(Stage::Load))
    viewport_->scene().setPartPreview(Eigen::Affine3d::Identity());
}

void MainWindow::placeOnFace(const Eigen::Vector3d& normal) {
  if (normal.norm() < 0.5)
    return;
  geometry::Placement placement = document_.choices().placement;
  placement.rotation = geometry::rotationLayingFlat(normal) * placement.rotation;
  placement.liftMm = 0.0;
  document_.place(placement, tr("lay on face"));
}

// ---- export

void MainWindow::exportPrograms(const QString& folder, const QStringList& formats,
                                bool includeRefused) {
  const auto result = document_.result(Stage::Replay);
  const auto there = [&](const QString& id) {
    return result &&
           std::any_of(result->checked.begin(), result->checked.end(), [&](const auto& program) {
             return QString::fromStdString(program->program.format) == id;
           });
  };
  if (std::all_of(formats.begin(), formats.end(), there) && document_.upToDate(Stage::Replay)) {
    writePrograms(folder, formats, includeRefused);
    return;
  }
  pendingExport_ = PendingExport{folder, formats, includeRefused};
  planning_.plan(Stage::Replay);
}

void MainWindow::writePrograms(const QString& folder, const QStringList& formats,
                               bool includeRefused) {
  const auto result = document_.result(Stage::Replay);
  if (!result)
    return;
  std::vector<std::shared_ptr<const pipeline::CheckedProgram>> chosen;
  QStringList refused;
  for (const auto& program : result->checked)
    if (formats.contains(QString::fromStdString(program->program.format))) {
      if (program->passed || includeRefused)
        chosen.push_back(program);
      else
        refused << QString::fromStdString(program->program.format);
    }
  exporting_.run(
      [chosen, folder = folder.toStdString()](const base::RunContext& ctx) {
        base::StagedFolder staged(folder);
        int files = 0;
        for (const auto& program : chosen)
          for (const plan::ProgramFile& file : program->program.files) {
            ctx.checkpoint();
            base::writeFile(staged.path() / pipeline::writtenName(*program, file), file.text);
            ++files;
          }
        staged.commit();
        return files;
      },
      [this, folder, refused](base::Outcome<int> outcome) {
        if (const int* files = std::get_if<int>(&outcome)) {
          QString text = tr("%n file(s) written to %1", nullptr, *files).arg(folder);
          if (!refused.isEmpty())
            text += tr("; refused and not written: %1").arg(refused.join(", "));
          status_->showIdle(text);
        } else if (const auto* error = std::get_if<base::Error>(&outcome)) {
          tell(tr("Nothing is exported"), QString::fromStdString(error->what()));
        }
      },
      1);
}

} // namespace voluta::window
