#include "window/pages/cut_tool.h"

#include "base/error.h"
#include "base/units.h"
#include "document/planning.h"
#include "geometry/measures.h"
#include "geometry/placement.h"
#include "language/translated.h"
#include "language/words.h"
#include "pipeline/part_ways.h"
#include "planar/pieces.h"
#include "planar/plane_cut.h"
#include "project/loaded_part.h"
#include "window/presenters/presenter.h"

#include <QFileInfo>
#include <QLocale>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <utility>

namespace voluta::window {

using document::Document;
using Eigen::Vector3d;
using geometry::TriangleMesh;
using panels::CutChoices;
using planar::Joint;
using project::Stage;
using viewer::Tool;

struct CutTool::Preview {
  std::shared_ptr<const scene::PiecesDrawing> halves; // null: the plane does not cut the part
  QString problem;                                    // empty: the cut can be made
  double belowMm3 = 0.0, aboveMm3 = 0.0;
  std::size_t pins = 0;
};

namespace {

constexpr double kApartShare = 0.12; // of the part's diagonal
constexpr std::size_t kMaxBodies = 100;
constexpr double kMm3PerCm3 = 1000.0;

// Without faces that need support: the halves are shown in colours of their own.
std::shared_ptr<const scene::PiecesDrawing> drawingOf(planar::PartHalves halves,
                                                      const planar::Plane& plane) {
  constexpr double kOnPlaneMm = 1e-3;
  std::vector<planar::Piece> pieces(2);
  pieces[0].solid = planar::tagged(halves.below);
  pieces[1].solid = planar::tagged(halves.above);
  pieces[1].base = plane;
  for (planar::Piece& half : pieces)
    half.base.normal *= 1.0 - 1e-9; // so that rounding makes no face need support
  pieces[1].baseTag = 0;
  pieces[1].parent = 0;
  planar::TaggedMesh& upper = pieces[1].solid;
  for (std::size_t t = 0; t < upper.tag.size(); ++t) {
    bool isOn = true;
    for (int k = 0; k < 3; ++k)
      isOn = isOn && std::abs(plane.heightOf(upper.mesh.corner(t, k))) < kOnPlaneMm;
    upper.tag[t] = isOn ? 0 : planar::kSkin;
  }
  for (TriangleMesh& dowel : halves.dowels) {
    planar::Piece loose;
    loose.solid = planar::tagged(dowel);
    loose.base.normal = 0.5 * plane.normal; // halfway between the halves when they are apart
    loose.parent = 0;
    pieces.push_back(std::move(loose));
  }
  planar::RiskRule none;
  none.overhangRad = 0.5 * base::kPi;
  return scene::drawPieces(pieces, none);
}

// "bracket.stl" cut into "bracket A" and "bracket B", and A again into "bracket AA" and "AB".
std::string nameOfHalf(const std::string& name, char letter) {
  static const QRegularExpression halves(QStringLiteral(" [AB]+$"));
  QString base = QFileInfo(QString::fromStdString(name)).completeBaseName();
  if (!halves.match(base).hasMatch())
    base += ' ';
  return (base + QLatin1Char(letter)).toStdString() + ".stl";
}

std::string nameWith(const std::string& name, const QString& word) {
  return (QFileInfo(QString::fromStdString(name)).completeBaseName() + ' ' + word).toStdString() +
         ".stl";
}

Document::Successor successor(std::string name, TriangleMesh mesh, bool repair,
                              const Eigen::Quaterniond& rotation, bool keepsPlace,
                              const base::RunContext& ctx) {
  const Vector3d centre = geometry::bounds(mesh).center();
  Document::Successor out;
  out.part = project::loadedFrom(
      std::move(name), std::make_shared<const TriangleMesh>(std::move(mesh)), {}, repair, ctx);
  out.placement = {rotation, centre.head<2>(), 0.0};
  out.keepsPlace = keepsPlace;
  return out;
}

std::vector<Document::Successor> cutParts(const TriangleMesh& part, const planar::Plane& plane,
                                          const CutChoices& choices, const std::string& name,
                                          const QString& dowelWord, bool repair,
                                          const base::RunContext& ctx) {
  using Keep = CutChoices::Keep;
  planar::PartHalves halves = planar::cutPart(part, plane, choices.joint, ctx.sub(0.0, 0.5));
  const Eigen::Quaterniond asItIs = Eigen::Quaterniond::Identity();
  const bool hasTongue =
      choices.joint.kind == Joint::Kind::Pegs || choices.joint.kind == Joint::Kind::Dovetail;
  const auto layingOn = [&](const Vector3d& normal, bool can) {
    return choices.laysFlat && can ? geometry::rotationLayingFlat(normal) : asItIs;
  };
  std::vector<Document::Successor> parts;
  if (choices.keep != Keep::Upper)
    parts.push_back(successor(nameOfHalf(name, 'A'), std::move(halves.below), repair,
                              layingOn(plane.normal, !hasTongue), true, ctx.sub(0.5, 0.7)));
  if (choices.keep != Keep::Lower)
    parts.push_back(successor(nameOfHalf(name, 'B'), std::move(halves.above), repair,
                              layingOn(-plane.normal, true), parts.empty(), ctx.sub(0.7, 0.9)));
  if (halves.dowels.empty())
    return parts;
  // One part, in as many copies as there are pins.
  Document::Successor dowel =
      successor(nameWith(name, dowelWord), std::move(halves.dowels.front()), repair,
                geometry::rotationLayingFlat(-plane.normal), false, ctx.sub(0.9, 1.0));
  dowel.hasRegions = false;
  parts.insert(parts.end(), halves.dowels.size(), dowel);
  return parts;
}

QString volumeText(double mm3) {
  return QLocale().toString(mm3 / kMm3PerCm3, 'f', mm3 < 10.0 * kMm3PerCm3 ? 2 : 1);
}

} // namespace

CutTool::CutTool(const Workspace& workspace, const Page& page, QObject* parent)
    : QObject(parent), work_(workspace), page_(page), panel_(new panels::CutPanel) {
  panel_->setObjectName(QStringLiteral("cutPanel"));
  listen();
}

void CutTool::listen() {
  connect(&work_.viewport, &viewer::Viewport::toolChanged, this, &CutTool::changeTool);
  // After the window has set the handles for the part.
  connect(&work_.presenter, &Presenter::partDrawn, this, &CutTool::takePart, Qt::QueuedConnection);
  for (const auto changed : {&Document::sourceChanged, &Document::partsChanged})
    connect(&work_.document, changed, this, &CutTool::takePart);
  connect(&work_.document, &Document::resultChanged, this, &CutTool::takePart);
  connect(&work_.presenter.pieces(), &PiecesPresenter::drawn, this, [this] {
    if (open_)
      work_.viewport.scene().setPieces(halves_);
  });
  using panels::CutPanel;
  connect(panel_, &CutPanel::changed, this, &CutTool::takeNumbers);
  connect(panel_, &CutPanel::axisChosen, this, [this] {
    toMiddle();
    setNormal(Vector3d::Unit(panel_->choices().axis));
    showPlane();
    preview();
  });
  connect(panel_, &CutPanel::facePicking, this, [this](bool on) {
    picking_ = on;
    work_.viewport.setTool(on ? Tool::PickPoint : Tool::CutPlane);
  });
  connect(panel_, &CutPanel::cutRequested, this, &CutTool::cut);
  connect(panel_, &CutPanel::closeRequested, this, [this] { work_.viewport.setTool(Tool::None); });
}

std::vector<Command> CutTool::commands() {
  return {
      {"toolCut",
       "editMenu",
       1,
       QT_TRANSLATE_NOOP("Commands", "C&ut…"),
       QT_TRANSLATE_NOOP("Commands", "Cuts the part in two with a plane, with dowels, pegs or a "
                                     "dovetail"),
       {QKeySequence("K")},
       [this] { setOpen(!open_); },
       [this] { return page_.isShown() && work_.document.source(); },
       [this] { return open_; },
       "cut",
       BarGroup::Tools},
      {"splitPart",
       "editMenu",
       3,
       QT_TRANSLATE_NOOP("Commands", "Split to &parts"),
       QT_TRANSLATE_NOOP("Commands", "Makes a part of each body of the mesh"),
       {},
       [this] { split(); },
       [this] { return canCut() && placedPart() && work_.document.sourceReady(); },
       {},
       "split",
       BarGroup::Tools}};
}

CutTool::Mesh CutTool::placedPart() const {
  const auto placed = work_.document.itemResult(Stage::Load);
  return placed && work_.document.upToDate(Stage::Load) ? placed->job.item().part : nullptr;
}

// The paths of a file would not be those of the halves. A part that a mode or a body places has
// its place by the coordinates of its file, which the halves do not keep.
bool CutTool::canCut() const {
  const auto source = work_.document.source();
  const project::Choices& choices = work_.document.choices();
  const bool isPlacedByFile = choices.item().platform.isBody() || !pipeline::standsFreely(choices);
  return page_.isShown() && source && !source->toolPaths && !isPlacedByFile;
}

QString CutTool::partName() const {
  return QFileInfo(QString::fromStdString(work_.document.source()->name)).completeBaseName();
}

void CutTool::setOpen(bool open) {
  if (open && !canCut())
    return;
  if (!open) {
    work_.viewport.setTool(Tool::None);
    return;
  }
  picking_ = false;
  open_ = true;
  CutChoices choices = panel_->choices();
  choices.keep = CutChoices::Keep::Both; // the joint stays, for the next cut
  panel_->setChoices(choices);
  work_.viewport.setTool(Tool::CutPlane);
  work_.viewport.setFocus(Qt::OtherFocusReason);
  emit opened(true);
  takePart();
}

// Escape while a face is picked returns to the handles; otherwise another tool, or none, closes.
void CutTool::changeTool(Tool tool) {
  if (!open_ || tool == Tool::CutPlane || (picking_ && tool == Tool::PickPoint))
    return;
  if (std::exchange(picking_, false) && tool == Tool::None && page_.isShown()) {
    panel_->setPickingFace(false);
    QMetaObject::invokeMethod(
        this,
        [this] {
          if (open_ && page_.isShown() && work_.viewport.tool() == Tool::None)
            work_.viewport.setTool(Tool::CutPlane);
        },
        Qt::QueuedConnection);
    return;
  }
  panel_->setPickingFace(false);
  open_ = dragging_ = again_ = false;
  drawing_.cancel();
  making_.cancel();
  part_ = nullptr;
  source_ = nullptr;
  halves_ = nullptr;
  work_.presenter.pieces().showAgain();
  if (!work_.presenter.partBox().isEmpty())
    work_.viewport.setGizmoCentre(work_.presenter.partBox().center());
  emit opened(false);
  work_.shell.showStates();
  work_.shell.showView();
}

void CutTool::takePart() {
  if (!open_)
    return;
  const auto source = work_.document.source();
  if (!source || source->toolPaths) {
    work_.viewport.setTool(Tool::None);
    return;
  }
  const Mesh part = placedPart();
  if (part == part_) {
    showPlane(); // the window has set the handles for the part
    return;
  }
  part_ = part;
  halves_ = nullptr;
  work_.viewport.scene().setPieces(nullptr);
  if (!part_) {
    drawing_.cancel();
    panel_->setState({}, false, false);
    work_.shell.showView();
    return;
  }
  const Eigen::AlignedBox3d before = box_;
  box_ = geometry::bounds(*part_);
  if (source != source_) {
    source_ = source;
    toMiddle();
    setNormal(Vector3d::Unit(panel_->choices().axis));
  } else {
    pivot_ += box_.center() - before.center();
  }
  showPlane();
  preview();
}

void CutTool::toMiddle() {
  pivot_ = box_.center();
}

void CutTool::setNormal(const Vector3d& normal) {
  normal_ = normal.normalized();
}

planar::Plane CutTool::plane() const {
  return {normal_, normal_.dot(pivot_)};
}

void CutTool::takeNumbers() {
  if (!part_)
    return;
  const CutChoices& choices = panel_->choices();
  setNormal(panels::cutNormal(choices));
  pivot_[choices.axis] = box_.min()[choices.axis] + choices.positionMm;
  showPlane();
  preview();
}

// In the view and in the panel.
void CutTool::showPlane() {
  if (!part_)
    return;
  CutChoices choices = panel_->choices();
  constexpr double kMainShare = 0.5;
  if (std::abs(normal_[choices.axis]) < kMainShare)
    normal_.cwiseAbs().maxCoeff(&choices.axis);
  pivot_ = pivot_.cwiseMax(box_.min()).cwiseMin(box_.max());
  choices.tiltDeg = panels::cutTiltDeg(normal_, choices.axis);
  choices.positionMm = pivot_[choices.axis] - box_.min()[choices.axis];
  panel_->setChoices(choices);
  panel_->setPart(partName(), box_.sizes());
  work_.viewport.setGizmoCentre(pivot_, scene::baseAxes(normal_));
}

void CutTool::gizmoStarted() {
  if (!open_)
    return;
  pivotBefore_ = pivot_;
  normalBefore_ = normal_;
}

void CutTool::gizmoDragged(const viewer::GizmoChange& change, bool finished) {
  if (!open_ || !part_)
    return;
  dragging_ = !finished;
  pivot_ = pivotBefore_ + change.moveMm;
  setNormal(change.rotation * normalBefore_);
  showPlane();
  preview();
}

void CutTool::clicked(const std::optional<scene::Hit>& hit) {
  using What = scene::Hit::What;
  if (!open_ || !picking_ || !hit || (hit->what != What::Part && hit->what != What::Piece) ||
      hit->normal.norm() < 0.5)
    return;
  Eigen::Index axis = 0;
  hit->normal.cwiseAbs().maxCoeff(&axis);
  setNormal(hit->normal[axis] < 0.0 ? (-hit->normal).eval() : hit->normal);
  panel_->setPickingFace(false);
  work_.viewport.setTool(Tool::CutPlane);
  picking_ = false;
  showPlane();
  preview();
}

// While the plane is dragged, each preview is finished before the next one begins.
void CutTool::preview() {
  if (!open_ || !part_)
    return;
  if (dragging_ && drawing_.running())
    again_ = true;
  else
    startPreview();
}

void CutTool::startPreview() {
  again_ = false;
  Joint joint = panel_->choices().joint;
  if (dragging_)
    joint.kind = Joint::Kind::None;
  else
    panel_->setState(tr("Calculating…"), false, false);
  drawing_.run(
      [part = part_, plane = plane(), joint](const base::RunContext& ctx) {
        Preview made;
        planar::PartHalves halves;
        try {
          halves = planar::cutPart(*part, plane, joint, ctx);
        } catch (const base::Error& error) {
          made.problem = language::capitalized(language::words(error.whole()));
          if (joint.kind == Joint::Kind::None)
            return made;
          try {
            halves = planar::cutPart(*part, plane, {}, ctx);
          } catch (const base::Error&) { // the plane itself does not cut
            return made;
          }
        }
        made.belowMm3 = geometry::volume(halves.below);
        made.aboveMm3 = geometry::volume(halves.above);
        made.pins = halves.pins.size();
        made.halves = drawingOf(std::move(halves), plane);
        return made;
      },
      [this](const base::Outcome<Preview>& outcome) {
        if (const auto* made = std::get_if<Preview>(&outcome))
          show(*made);
        else if (const auto* error = std::get_if<base::Error>(&outcome))
          panel_->setState(language::capitalized(language::words(error->whole())), true, false);
        if (again_)
          startPreview();
      },
      1);
}

void CutTool::show(const Preview& made) {
  halves_ = made.halves;
  work_.viewport.scene().setPieces(halves_);
  if (!made.problem.isEmpty()) {
    panel_->setState(made.problem, true, false);
  } else {
    QString text = tr("Lower half %1 cm³, upper half %2 cm³.")
                       .arg(volumeText(made.belowMm3), volumeText(made.aboveMm3));
    if (made.pins > 0)
      text += ' ' + tr("Pins: %1.").arg(made.pins);
    panel_->setState(text, false, !dragging_ && !making_.running());
  }
  work_.shell.showView();
}

void CutTool::draw(scene::ViewState& view) const {
  if (!open_ || !halves_)
    return;
  view.pieces = true;
  view.part = view.voxels = false;
  view.basePlanes = true;
  view.pieceNumbers = view.partSize = false;
  const CutChoices& choices = panel_->choices();
  if (choices.showsApart)
    view.explodeMm = kApartShare * box_.diagonal().norm() +
                     (choices.joint.kind == Joint::Kind::None ? 0.0 : 2.0 * choices.joint.depthMm);
  if (choices.keep != CutChoices::Keep::Both)
    view.piece = choices.keep == CutChoices::Keep::Lower ? 0 : 1;
}

void CutTool::cut() {
  if (!part_ || !work_.document.sourceReady())
    return;
  panel_->setState(tr("Cutting…"), false, false);
  makeParts(tr("Cut"), tr("Cut %1").arg(partName()), false,
            [part = part_, plane = plane(), choices = panel_->choices(),
             name = work_.document.source()->name, dowel = tr("dowel"),
             repair = work_.document.choices().item().repair](const base::RunContext& ctx) {
              return cutParts(*part, plane, choices, name, dowel, repair, ctx);
            });
}

void CutTool::split() {
  const Mesh part = placedPart();
  if (!part)
    return;
  makeParts(tr("Split to parts"), tr("Split %1").arg(partName()), true,
            [part, name = work_.document.source()->name,
             repair = work_.document.choices().item().repair](const base::RunContext& ctx) {
              std::vector<Document::Successor> parts;
              std::vector<TriangleMesh> bodies = planar::bodiesOf(*part);
              const auto count = static_cast<double>(bodies.size());
              for (std::size_t i = 0; bodies.size() <= kMaxBodies && i < bodies.size(); ++i)
                parts.push_back(successor(
                    nameWith(name, QString::number(i + 1)), std::move(bodies[i]), repair,
                    Eigen::Quaterniond::Identity(), true,
                    ctx.sub(static_cast<double>(i) / count, static_cast<double>(i + 1) / count)));
              return parts;
            });
}

void CutTool::makeParts(
    const QString& title, const QString& editName, bool isSplit,
    std::function<std::vector<Document::Successor>(const base::RunContext&)> work) {
  using Made = std::vector<Document::Successor>;
  const std::uint64_t revision = work_.document.revision();
  const std::size_t item = work_.document.active();
  work_.shell.say(title + QStringLiteral("…"));
  making_.run(
      std::move(work),
      [this, title, editName, isSplit, revision, item](const base::Outcome<Made>& outcome) {
        work_.shell.say({});
        const auto* made = std::get_if<Made>(&outcome);
        if (const auto* error = std::get_if<base::Error>(&outcome)) {
          work_.shell.showMessage(title, language::words(error->whole()));
          preview();
          return;
        }
        if (!made || work_.document.revision() != revision) { // edited meanwhile
          preview();
          return;
        }
        if (made->empty()) {
          work_.shell.showMessage(title, tr("The mesh has more than %1 bodies.").arg(kMaxBodies));
          return;
        }
        if (isSplit && made->size() == 1) {
          work_.shell.showMessage(title, tr("The part is one body."));
          return;
        }
        if (open_)
          work_.viewport.setTool(Tool::None);
        work_.planning.cancel();
        const bool hadRegions = !work_.document.choices().item().regions.empty();
        work_.document.replacePart(item, *made, editName);
        const QString parts = tr("%n parts", nullptr, static_cast<int>(made->size()));
        work_.shell.say(hadRegions ? tr("%1. Their regions have moved with them.").arg(parts)
                                   : parts);
      },
      1);
}

} // namespace voluta::window
