#include "window/pages/regions_tool.h"

#include "base/error.h"
#include "document/mode_switch.h"
#include "forms/file_patterns.h"
#include "geometry/measures.h"
#include "language/translated.h"
#include "language/words.h"
#include "layers/tool_assignment.h"
#include "modes/level_choices.h"
#include "modes/mode_table.h"
#include "modes/platform_body.h"
#include "panels/paint_form.h"
#include "pipeline/region_check.h"
#include "pipeline/resolved.h"
#include "pipeline/stage_options.h"
#include "project/loaded_part.h"
#include "regions/part_regions.h"
#include "regions/region_kinds.h"
#include "regions/region_text.h"
#include "window/pages/new_region.h"
#include "window/pages/region_bodies.h"
#include "window/picture_area.h"
#include "window/presenters/presenter.h"

#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QSettings>
#include <algorithm>
#include <cmath>
#include <utility>

namespace voluta::window {

using document::Document;
using Eigen::Vector3d;
using project::Region;
using project::Stage;
using viewer::Tool;

struct RegionsTool::Made {
  std::shared_ptr<const scene::RegionsDrawing> bodies;
  std::vector<Kept> kept;
  Eigen::Isometry3d work_T_file = Eigen::Isometry3d::Identity();
  QString problem; // empty: every region has a body
};

namespace {
constexpr double kGlass = 0.38; // opacity of the part around its regions

bool samePlace(const geometry::Placement& a, const geometry::Placement& b) {
  return a.centreMm == b.centreMm && a.liftMm == b.liftMm &&
         a.rotation.coeffs() == b.rotation.coeffs();
}

QString sentence(const base::Error& error) {
  return language::capitalized(language::words(error.whole()));
}

std::array<QColor, scene::kRegionLooks> regionColours(const QPalette& palette) {
  const scene::Theme theme = sceneTheme(palette);
  std::array<QColor, scene::kRegionLooks> colours;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const scene::Colour c = scene::colourOf(static_cast<scene::RegionLook>(i), theme);
    colours[i] = QColor::fromRgbF(static_cast<float>(c[0]), static_cast<float>(c[1]),
                                  static_cast<float>(c[2]));
  }
  return colours;
}
} // namespace

RegionsTool::RegionsTool(const Workspace& workspace, const Page& page, QObject* parent)
    : QObject(parent), work_(workspace), page_(page), panel_(new panels::RegionsPanel) {
  panel_->setObjectName(QStringLiteral("regionsPanel"));
  rest_.setSingleShot(true);
  listen();
}

// The list has the colours of the view.
bool RegionsTool::eventFilter(QObject* watched, QEvent* event) {
  if (watched == panel_ && event->type() == QEvent::PaletteChange)
    panel_->setColours(regionColours(panel_->palette()));
  return QObject::eventFilter(watched, event);
}

void RegionsTool::listen() {
  panel_->installEventFilter(this);
  connect(&work_.viewport, &viewer::Viewport::toolChanged, this, &RegionsTool::changeTool);
  // After the window has set the handles for the part.
  connect(&work_.presenter, &Presenter::partDrawn, this, &RegionsTool::showHandles,
          Qt::QueuedConnection);
  for (const auto changed :
       {&Document::sourceChanged, &Document::partsChanged, &Document::choicesChanged})
    connect(&work_.document, changed, this, &RegionsTool::takeDocument);
  connect(&work_.document, &Document::resultChanged, this, &RegionsTool::takePlaced);
  connect(&rest_, &QTimer::timeout, this, &RegionsTool::growLayers);
  using panels::RegionsPanel;
  connect(panel_, &RegionsPanel::addRequested, this, &RegionsTool::add);
  connect(panel_, &RegionsPanel::edited, this, &RegionsTool::set);
  connect(panel_, &RegionsPanel::selectionChanged, this, [this] {
    movedMm_.setZero();
    showProblem();
    showHandles();
    work_.shell.showView();
  });
  connect(panel_, &RegionsPanel::paintChanged, this, [this] {
    work_.viewport.setPaintsRectangles(panel_->paint().with ==
                                       panels::PaintChoices::With::Rectangle);
    work_.viewport.setFocus(Qt::OtherFocusReason);
  });
  connect(&work_.viewport, &viewer::Viewport::rectanglePainted, this, &RegionsTool::paintRectangle);
  connect(panel_, &RegionsPanel::closeRequested, this,
          [this] { work_.viewport.setTool(Tool::None); });
}

std::vector<Command> RegionsTool::commands() {
  const auto enabled = [this] { return page_.isShown() && work_.document.source() != nullptr; };
  return {{"toolRegions",
           "editMenu",
           1,
           QT_TRANSLATE_NOOP("Commands", "Re&gions…"),
           QT_TRANSLATE_NOOP("Commands", "Places in the part with settings, or layers, of their "
                                         "own"),
           {QKeySequence("G")},
           [this] { setOpen(!open_); },
           enabled,
           [this] { return open_; },
           "regions",
           BarGroup::Tools},
          {"addRegion",
           "editMenu",
           1,
           QT_TRANSLATE_NOOP("Commands", "Add &region…"),
           QT_TRANSLATE_NOOP("Commands", "Adds a place with settings, or layers, of its own"),
           {},
           [this] {
             setOpen(true);
             // Once the panel has its place.
             QMetaObject::invokeMethod(panel_, &panels::RegionsPanel::openAddMenu,
                                       Qt::QueuedConnection);
           },
           enabled}};
}

QString RegionsTool::partName() const {
  const auto source = work_.document.source();
  return source ? QFileInfo(QString::fromStdString(source->name)).completeBaseName() : QString();
}

void RegionsTool::setOpen(bool open) {
  if (!open) {
    work_.viewport.setTool(Tool::None);
    return;
  }
  if (open_)
    return;
  open_ = true;
  work_.viewport.setTool(Tool::Regions);
  work_.viewport.setFocus(Qt::OtherFocusReason);
  emit opened(true);
  takeDocument();
  if (!panel_->selected() && !panel_->regions().empty())
    panel_->select(0);
  makeBodies();
  showHandles();
  work_.shell.showView();
}

// Another tool, or none, closes.
void RegionsTool::changeTool(Tool tool) {
  if (!open_ || tool == Tool::Regions || tool == Tool::MoveRegion || tool == Tool::Paint)
    return;
  open_ = dragging_ = false;
  dropStroke();
  movedMm_.setZero();
  if (!work_.presenter.partBox().isEmpty())
    work_.viewport.setGizmoCentre(work_.presenter.partBox().center());
  emit opened(false);
  work_.shell.showStates();
  work_.shell.showView();
}

// ---- what is shown

void RegionsTool::takeDocument() {
  const auto source = work_.document.source();
  if (open_ && !source) {
    work_.viewport.setTool(Tool::None);
    return;
  }
  const project::Choices& choices = work_.document.choices();
  panel_->setColours(regionColours(panel_->palette()));
  panel_->setPart(partName());
  panel_->setRegions(choices.item().regions);
  if (open_) {
    base::ParameterTable table = document::parametersFor(choices);
    const auto given = pipeline::givenParameters(choices);
    std::vector<base::ParameterSpec> specs = table.specs();
    std::set<std::string> applying;
    for (base::ParameterSpec& spec : specs) {
      if (spec.scope == base::ParameterScope::Region &&
          modes::takesParameter(modes::findMode(choices.item().mode), spec.key) &&
          (choices.tools.size() > 1 || !layers::toolParameters().find(spec.key)))
        applying.insert(spec.key);
      if (const auto own = given.find(spec.key); own != given.end())
        try {
          spec.defaultValue = base::parseParameter(spec, own->second);
        } catch (const base::Error&) { // the form of the part's settings says so
        }
    }
    panel_->setPartValues(base::ParameterTable(std::move(specs)), applying);
  }
  takePlaced();
  showProblem();
  makeBodies();
  showHandles();
}

// While the choices cannot be planned, the part stays where it was.
void RegionsTool::takePlaced() {
  const auto source = work_.document.source();
  const auto result = work_.document.itemResult(Stage::Load);
  if (!source || placed_.source != source) {
    placed_ = {};
    bodies_ = nullptr;
    isPosed_ = false;
    work_.viewport.scene().setRegions(nullptr);
  }
  if (!source || !result || !work_.document.upToDate(Stage::Load))
    return;
  const project::JobItem& item = result->job.item();
  if (!item.part || !item.placement || placed_.part == item.part)
    return;
  const double scale = item.scale * pipeline::unitMm(*source, work_.document.choices());
  if (!samePlace(placed_.placement, *item.placement) || placed_.scale != scale) {
    isPosed_ = false;
    bodies_ = nullptr;
    work_.viewport.scene().setRegions(nullptr);
  }
  placed_ = {source, item.part, *item.placement, scale};
  makeBodies();
}

void RegionsTool::showProblem() {
  if (work_.document.choices().item().regions.empty()) {
    panel_->setProblem({});
    return;
  }
  try {
    pipeline::checkRegions(work_.document.choices().item(), pipeline::allParameters());
    const auto at = panel_->selected();
    const bool lacksPaint = isPainted() && !panel_->regions()[*at].mesh;
    panel_->setProblem(lacksPaint && bodyProblem_.isEmpty()
                           ? tr("Nothing is painted yet: the region has no effect.")
                           : bodyProblem_);
  } catch (const base::Error& error) {
    panel_->setProblem(sentence(error));
  }
}

// Bodies that follow the part's surface take a second; as outlines they are not worth it.
void RegionsTool::makeBodies() {
  const std::vector<Region>& all = work_.document.choices().item().regions;
  if (all.empty() || !placed_.part) {
    drawing_.cancel();
    bodies_ = nullptr;
    bodyProblem_.clear();
    movedMm_.setZero();
    work_.viewport.scene().setRegions(nullptr);
    showProblem();
    return;
  }
  drawing_.run(
      [placed = placed_, all, kept = kept_, choices = work_.document.choices(),
       withSurfaces = open_](const base::RunContext& ctx) {
        Made made;
        made.work_T_file = modes::motionOf(*placed.source->mesh, placed.scale, placed.placement);
        const regions::PlacedPart part{*placed.part, made.work_T_file, placed.scale};
        std::vector<scene::RegionBody> bodies;
        for (const Region& region : all) {
          scene::RegionBody& body = bodies.emplace_back();
          try {
            const regions::Shape shape = regions::parsedShape(region.shape);
            body.look = lookOf(region);
            if (shape.kind->mesh == regions::ShapeMesh::Painted) {
              if (region.mesh)
                body.body = std::make_shared<const geometry::TriangleMesh>(
                    overPart(*region.mesh, made.work_T_file, placed.scale));
              continue;
            }
            const bool isOwn = shape.kind->body || shape.kind->mesh == regions::ShapeMesh::File;
            if (!isOwn && !withSurfaces)
              continue;
            Kept own{region.shape, region.mesh, placed.part, nullptr};
            const auto before = std::ranges::find_if(kept, [&](const Kept& one) {
              return one.shape == own.shape && one.surface == own.surface && one.part == own.part;
            });
            if (before != kept.end())
              own.body = before->body;
            else
              own.body = std::make_shared<const geometry::TriangleMesh>(regions::bodyOf(
                  region, part, modes::levelOptions(pipeline::resolve(choices).modeChoices()),
                  ctx));
            body.body = own.body;
            made.kept.push_back(std::move(own));
          } catch (const base::Error& error) {
            if (made.problem.isEmpty())
              made.problem = sentence(error);
          }
        }
        made.bodies = scene::drawRegions(bodies);
        return made;
      },
      [this](const base::Outcome<Made>& outcome) {
        if (const auto* made = std::get_if<Made>(&outcome))
          takeBodies(*made);
      },
      1);
}

void RegionsTool::takeBodies(const Made& made) {
  kept_ = made.kept;
  work_T_file_ = made.work_T_file;
  isPosed_ = true;
  bodies_ = made.bodies;
  bodyProblem_ = made.problem;
  if (!dragging_)
    movedMm_.setZero();
  work_.viewport.scene().setRegions(bodies_);
  showProblem();
  showHandles();
  work_.shell.showView();
}

void RegionsTool::draw(scene::ViewState& view) const {
  const Tool tool = work_.viewport.tool();
  if (!bodies_ || !view.part || (!open_ && tool != Tool::None))
    return;
  view.regions = true;
  view.regionOutlines = !open_;
  if (!open_)
    return;
  if (!isPainted())
    view.partOpacity = kGlass;
  view.region = panel_->selected();
  view.regionMovedMm = movedMm_;
}

// ---- handles

std::optional<Vector3d> RegionsTool::middle() const {
  const auto at = panel_->selected();
  if (!at)
    return std::nullopt;
  try {
    const regions::Shape shape = regions::parsedShape(panel_->regions()[*at].shape);
    if (shape.kind->frame == regions::ShapeFrame::File && shape.numbers.size() > 3)
      return Vector3d(shape.numbers[0], shape.numbers[1], shape.numbers[2]);
  } catch (const base::Error&) { // shown as a problem
  }
  return std::nullopt;
}

void RegionsTool::showHandles() {
  if (!open_ || dragging_)
    return;
  if (isPainted()) {
    work_.viewport.setTool(Tool::Paint);
    return;
  }
  const auto place = middle();
  if (!place || !isPosed_) {
    work_.viewport.setTool(Tool::Regions);
    return;
  }
  work_.viewport.setGizmoCentre(work_T_file_ * (placed_.scale * *place) + movedMm_);
  work_.viewport.setTool(Tool::MoveRegion);
}

void RegionsTool::gizmoStarted() {
  if (!open_)
    return;
  dragging_ = true;
  movedMm_.setZero();
}

void RegionsTool::gizmoDragged(const viewer::GizmoChange& change, bool finished) {
  if (!open_ || !dragging_)
    return;
  movedMm_ = change.moveMm;
  dragging_ = !finished;
  work_.shell.showView();
  const auto at = panel_->selected();
  const auto place = middle();
  if (!finished || !at || !place)
    return;
  constexpr double kStillMm = 1e-9;
  if (movedMm_.norm() < kStillMm) {
    showHandles();
    return;
  }
  std::vector<Region> all = panel_->regions();
  regions::Shape shape = regions::parsedShape(all[*at].shape);
  const Vector3d to = *place + work_T_file_.linear().transpose() * movedMm_ / placed_.scale;
  for (std::size_t k = 0; k < 3; ++k)
    shape.numbers[k] = std::clamp(std::round(1e3 * to[static_cast<Eigen::Index>(k)]) / 1e3,
                                  shape.kind->fields[k].minimum, shape.kind->fields[k].maximum);
  all[*at].shape = shapeText(shape.kind->word, shape.numbers);
  set(all, tr("Move region"));
}

// ---- edits

void RegionsTool::set(const std::vector<Region>& regions, const QString& editName) {
  project::Choices choices = work_.document.choices();
  choices.item().regions = regions;
  work_.document.setChoices(choices, editName);
}

void RegionsTool::append(Region region) {
  std::vector<Region> all = work_.document.choices().item().regions;
  all.push_back(std::move(region));
  set(all, tr("Add region"));
  panel_->select(all.size() - 1);
  showProblem();
  showHandles();
  work_.shell.showView();
}

void RegionsTool::add(const QString& kind) {
  if (!work_.document.source())
    return;
  if (kind == QLatin1String("mesh"))
    addFromFile();
  else
    append(
        newRegion(kind.toStdString(), geometry::bounds(*work_.document.source()->mesh),
                  geometry::bounds(placed_.part ? *placed_.part : *work_.document.source()->mesh)));
}

void RegionsTool::addFromFile() {
  const QString key = QStringLiteral("open/folder");
  const QString file = QFileDialog::getOpenFileName(
      panel_, tr("Body of a region"), QSettings().value(key).toString(),
      tr("Meshes (%1);;All files (*)").arg(forms::filePatterns(project::NamedFiles::AllMeshes)));
  if (file.isEmpty())
    return;
  QSettings().setValue(key, QFileInfo(file).absolutePath());
  work_.shell.say(tr("Reading %1…").arg(QFileInfo(file).fileName()));
  reading_.run([text = "mesh:" + file.toStdString()](
                   const base::RunContext& ctx) { return regions::parsedRegion(text, ctx); },
               [this, source = work_.document.source()](const base::Outcome<Region>& outcome) {
                 work_.shell.say({});
                 if (const auto* error = std::get_if<base::Error>(&outcome))
                   work_.shell.showMessage(tr("Body of a region"), language::words(error->whole()));
                 else if (const auto* region = std::get_if<Region>(&outcome);
                          region && source == work_.document.source())
                   append(*region);
               },
               1);
}

} // namespace voluta::window
