// Who hears of what: every signal of the document, the pages and the viewport.
#include "window/main_window.h"

#include "forms/choices_form.h"
#include "forms/parameter_form.h"
#include "panels/export_panel.h"
#include "panels/findings_panel.h"
#include "panels/mesh_panel.h"
#include "panels/pieces_panel.h"
#include "panels/placement_panel.h"
#include "timeline/joint_plots.h"
#include "timeline/layer_range_slider.h"
#include "timeline/timeline_bar.h"
#include "window/program_preview.h"
#include "window/spacing_view.h"
#include "window/status_line.h"
#include "window/welcome.h"

#include <QActionGroup>
#include <QFileInfo>
#include <QSettings>
#include <algorithm>

namespace voluta::window {

using project::Stage;

namespace {
// What undo says of a choice.
QString editNameOf(const QString& field) {
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
} // namespace

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
  const auto layPart = [this] {
    if (!planning_.running() && document_.source() && document_.sourceReady())
      planning_.plan(Stage::Load);
  };
  connect(&document_, &document::Document::edited, this, layPart);
  // An edit may have come when a run was as good as done. Queued: it is still at telling its end.
  connect(
      &planning_, &document::Planning::finished, this,
      [this, layPart] {
        if (!document_.key(Stage::Load).empty() && !document_.upToDate(Stage::Load))
          layPart();
      },
      Qt::QueuedConnection);

  connect(&document_, &document::Document::previewChanged, this, &MainWindow::showFindings);
  connect(&document_, &document::Document::stateChanged, this, [this] {
    const std::array<bool, 3> now{document_.voxelsAhead(), document_.voxelsInPlace(),
                                  document_.ahead(Stage::Layers)};
    if (std::exchange(newest_, now) != now)
      showLayerCount();
  });

  connect(&live_, &document::LivePreview::started, this, &MainWindow::showStates);
  connect(&live_, &document::LivePreview::progressed, status_, &StatusLine::showProgress);
  connect(&live_, &document::LivePreview::finished, this, [this] {
    const auto result = document_.result(Stage::Decompose);
    status_->showIdle(result && result->job.pieces
                          ? tr("The pieces follow the settings. Press Plan for layers and paths.")
                      : result && result->job.decomposition
                          ? tr("The voxels follow the settings. Press Plan for layers and paths.")
                          : tr("Press Plan for layers and paths."));
    showStates();
  });
  connect(&live_, &document::LivePreview::cancelled, this, [this] {
    status_->showIdle(tr("Cancelled. The last results stay on show."));
    showStates();
  });
  connect(&live_, &document::LivePreview::failed, this, [this](const QString& message) {
    status_->showIdle(message);
    showStates();
    showFindings();
  });

  connect(&planning_, &document::Planning::started, this, &MainWindow::showStates);
  connect(&planning_, &document::Planning::progressed, status_, &StatusLine::showProgress);
  connect(&planning_, &document::Planning::finished, this, [this] {
    status_->showIdle(endText());
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
    showFindings();
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
      status_->showIdle(tr("Opened %1").arg(QFileInfo(path).fileName()));
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

  // Queued: while they tell how it ended they are still at it.
  const auto states = [this] { showStates(); };
  connect(&opening_, &document::Opening::opened, this, states, Qt::QueuedConnection);
  connect(&opening_, &document::Opening::repaired, this, states, Qt::QueuedConnection);
  connect(&opening_, &document::Opening::cancelled, this, states, Qt::QueuedConnection);
  connect(&opening_, &document::Opening::failed, this, states, Qt::QueuedConnection);

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
    project::Choices choices = document_.choices();
    choices.repair = repair;
    document_.setChoices(choices, repair ? tr("repair the mesh") : tr("mesh as read"));
  });
  connect(choices_, &forms::ChoicesForm::changed, this,
          [this](const QString& field, const QString& text) {
            project::Choices c = document_.choices();
            const std::string value = text.toStdString();
            if (field == "mode") {
              switchMode(value);
              return;
            }
            if (field == "growth")
              c.growth = curved::GrowthScheme(value);
            else if (field == "platform")
              c.platform = project::Platform(value);
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
    placedBeforeGizmo_ = placed();
    cutsBeforeDrag_ = cuts_;
    const auto placed = document_.result(Stage::Load);
    scaleBeforeGizmo_ = placed ? placed->job.scale : 1.0;
  });
  connect(viewport_, &viewer::Viewport::gizmoDragged, this,
          [this](const viewer::GizmoChange& change, bool finished) {
            if (viewport_->tool() == viewer::Tool::CutPlane)
              dragCut(change, finished);
            else
              applyGizmo(change, finished);
          });
  connect(viewport_, &viewer::Viewport::toolChanged, this, [this](viewer::Tool tool) {
    piecesPanel_->setPickingRoot(tool == viewer::Tool::PickPoint);
    if (tool == viewer::Tool::None && piecesShown() && chosenCut_ >= 0) // given up by a key
      selectPiece(-1);
    showView();
    placement_->setLayOnFace(tool == viewer::Tool::LayFlat);
    for (QAction* action : tools_->actions())
      action->setChecked(action->data().toInt() == static_cast<int>(tool));
  });
  connect(viewport_, &viewer::Viewport::clicked, this, [this](const auto& hit) {
    if (viewport_->tool() == viewer::Tool::PickPoint) {
      if (hit && (hit->what == scene::Hit::What::Part || hit->what == scene::Hit::What::Piece)) {
        setTool(viewer::Tool::None);
        pickRoot(hit->point);
      }
    } else if (piecesShown()) {
      selectPiece(hit && hit->what == scene::Hit::What::Piece ? static_cast<int>(hit->piece) : -1);
    } else if (viewport_->tool() == viewer::Tool::LayFlat && hit &&
               hit->what == scene::Hit::What::Part) {
      setTool(viewer::Tool::None);
      placeOnFace(hit->normal);
    } else if (page() == Page::Simulate && hit && hit->what == scene::Hit::What::Path &&
               presenter_->clock()) {
      if (const auto time = presenter_->clock()->timeOfWaypoint(hit->waypoint))
        setTime(*time);
      if (unrolledDock_->isVisible())
        chooseWaypoint(hit->waypoint);
    } else if (page() == Page::Layers && unrolledDock_->isVisible()) {
      chooseWaypoint(hit && hit->what == scene::Hit::What::Path ? std::optional(hit->waypoint)
                                                                : std::nullopt);
    }
  });
  connect(viewport_, &viewer::Viewport::hovered, this, [this](const auto& hit) {
    if (page() == Page::Layers)
      showLayerMeasures(hit && hit->layer >= 0 ? hit->layer : layers_->last());
  });

  // Layers
  connect(options_, &ViewOptions::changed, this, [this] {
    lookingAtMissed_ = false;
    showView();
  });
  connect(options_, &ViewOptions::dragging, viewport_, &viewer::Viewport::setDragging);
  connect(layers_, &timeline::LayerRangeSlider::rangeChanged, this, [this] {
    lookingAtMissed_ = false;
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
    project::Choices c = document_.choices();
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
  findings_->setRemedies([this](const plan::Finding& finding) { return remediesOf(finding); });
  connect(findings_, &panels::FindingsPanel::remedyChosen, this, &MainWindow::applyRemedy);
  connect(findings_, &panels::FindingsPanel::activated, this, &MainWindow::goTo);

  // What the presenter has prepared
  connect(presenter_, &Presenter::partDrawn, this, [this](bool another) {
    viewport_->scene().setPartPreview(Eigen::Affine3d::Identity());
    if (!presenter_->partBox().isEmpty())
      viewport_->setGizmoCentre(presenter_->partBox().center());
    placement_->setPlacement(placed());
    showPart();
    showView();
    if (another)
      viewport_->frameAll();
  });
  connect(presenter_, &Presenter::voxelsDrawn, this, &MainWindow::showLayerCount);
  connect(presenter_, &Presenter::layersDrawn, this, &MainWindow::showLayerCount);
  connect(presenter_, &Presenter::pathsDrawn, this, &MainWindow::showLayerCount);
  connect(presenter_, &Presenter::factsReady, this, &MainWindow::showLayerCount);
  connect(presenter_, &Presenter::motionReady, this, [this] {
    timeline_->setClock(presenter_->clock());
    const auto& clock = presenter_->clock();
    std::vector<robot::JointLimits> limits;
    std::vector<robot::ExternalAxis> externalAxes;
    if (const auto motion = document_.result(Stage::Motion); motion && motion->cell) {
      limits = motion->cell->limits();
      externalAxes = motion->cell->externalAxes();
    }
    plots_->setTrajectory(clock ? clock->trajectory() : nullptr, std::move(limits),
                          std::move(externalAxes));
    showView();
  });
}

void MainWindow::showLayerCount() {
  spacing_->setSpacing(presenter_->facts() ? presenter_->facts()->spacing : LayerSpacing{});
  options_->setAvailable(presenter_->hasVoxels(), presenter_->hasPieces(), presenter_->hasLayers(),
                         presenter_->hasPaths());
  const auto facts = presenter_->facts();
  layers_->setLayers(presenter_->layerCount(),
                     facts && static_cast<int>(facts->topsMm.size()) == presenter_->layerCount()
                         ? facts->topsMm
                         : std::vector<double>{},
                     facts && facts->radii);
  showMoves();
  showView();
  showLayerMeasures(layers_->last());
}

} // namespace voluta::window
