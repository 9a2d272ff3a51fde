#include "window/pages/piece_cuts.h"

#include "document/document.h"
#include "geometry/least_turn.h"
#include "geometry/measures.h"
#include "modes/mode_stages.h"
#include "modes/piece_search.h"
#include "modes/planar_modes.h"
#include "panels/pieces_panel.h"
#include "plan/finding_kinds.h"
#include "scene/camera.h"
#include "window/picture.h"
#include "window/presenters/presenter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace voluta::window {

using project::Stage;

namespace {
constexpr const char* kCuts = "cutPlanes";
constexpr const char* kRoot = "pieceRoot";
constexpr const char* kScheme = "planarScheme";
constexpr double kFaceRadiusMm = 20.0; // of the part around a face
// Minimum cosine between a face's normal and the view direction for the face to be visible well
constexpr double kMinFacing = 0.3;
// At the slider's end, as shares of the part's diagonal: between two pieces, and from the first to
// the last.
constexpr double kExplodeShare = 0.4, kExplodeAllShare = 1.0;

QColor colourOf(const scene::Colour& c) {
  return QColor::fromRgbF(static_cast<float>(c[0]), static_cast<float>(c[1]),
                          static_cast<float>(c[2]));
}

std::string chosenText(const project::Choices& choices, const char* key) {
  const auto chosen = choices.item().parameters.find(key);
  return chosen == choices.item().parameters.end() ? std::string() : chosen->second;
}

// Returns the plane of `cut` rotated and moved.
planar::GivenCut moved(const planar::GivenCut& cut, const viewer::GizmoChange& change) {
  planar::GivenCut out;
  out.point = cut.point + change.moveMm;
  out.plane.normal = (change.rotation * cut.plane.normal).normalized();
  out.plane.offsetMm = out.plane.normal.dot(out.point);
  for (const Eigen::Vector3d& p : cut.also)
    out.also.push_back(out.point + change.rotation * (p - cut.point));
  return out;
}

// Returns the outward normal of the face whose centroid is nearest.
Eigen::Vector3d faceNormal(const std::vector<planar::Piece>& pieces, const Eigen::Vector3d& place) {
  double nearest = std::numeric_limits<double>::infinity();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  for (const planar::Piece& piece : pieces) {
    const geometry::TriangleMesh& mesh = piece.solid.mesh;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const Eigen::Vector3d middle =
          (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0;
      if (const double d = (middle - place).squaredNorm(); d < nearest) {
        nearest = d;
        normal = geometry::triangleNormal(mesh, t);
      }
    }
  }
  return normal;
}

bool same(const planar::GivenCut& a, const planar::GivenCut& b) {
  return (a.plane.normal - b.plane.normal).norm() < 1e-9 &&
         std::abs(a.plane.offsetMm - b.plane.offsetMm) < 1e-6;
}
} // namespace

PieceCuts::PieceCuts(const Workspace& workspace, std::function<bool()> shown)
    : work_(workspace), shown_(std::move(shown)), panel_(new panels::PiecesPanel) {
  panel_->setObjectName("pieces");
  listen();
}

void PieceCuts::listen() {
  PiecesPresenter& pieces = work_.presenter.pieces();
  connect(&work_.document, &document::Document::choicesChanged, this, &PieceCuts::showCuts);
  connect(&pieces, &PiecesPresenter::drawn, this, &PieceCuts::showPieces);
  connect(&pieces, &PiecesPresenter::estimated, this,
          [this](double riskyMm2, bool exact, const QString& problem) {
            panel_->setEstimate({riskyMm2, exact, problem});
          });
  connect(&work_.viewport, &viewer::Viewport::toolChanged, this, &PieceCuts::changeTool);
  using panels::PiecesPanel;
  connect(panel_, &PiecesPanel::selectionChanged, this, &PieceCuts::select);
  connect(panel_, &PiecesPanel::viewChanged, this, [this] {
    Look look = work_.picture.look();
    look.pieceNumbers = panel_->numbers();
    work_.picture.setLook(look);
    work_.shell.showView();
  });
  connect(panel_, &PiecesPanel::dragging, this, [this](bool on) {
    work_.viewport.setDragging(on);
    if (!on) // bring pieces that were moved out of view back into it
      work_.viewport.frameAll();
  });
  connect(panel_, &PiecesPanel::keepCutsRequested, this, [this] {
    setCuts(QString::fromStdString(planar::givenCutsText(work_.presenter.pieces().cuts())),
            tr("keep cuts"));
  });
  connect(panel_, &PiecesPanel::searchRequested, this,
          [this] { setCuts({}, tr("search for cuts")); });
  connect(panel_, &PiecesPanel::rootPicking, this, [this](bool on) {
    if (on)
      select(-1);
    work_.viewport.setTool(on && work_.document.source() ? viewer::Tool::PickPoint
                                                         : viewer::Tool::None);
  });
}

double PieceCuts::explodeMm() const {
  const Eigen::AlignedBox3d& box = work_.presenter.partBox();
  if (box.isEmpty())
    return 0.0;
  const int storeys = work_.presenter.pieces().storeys();
  const double share = std::min(kExplodeShare, kExplodeAllShare / std::max(1, storeys - 1));
  return panel_->explodeShare() * share * box.diagonal().norm();
}

void PieceCuts::draw(scene::ViewState& view) const {
  view.explodeMm = explodeMm();
  view.basePlanes = panel_->basePlanes();
  if (panel_->selected() >= 0)
    view.piece = static_cast<std::size_t>(panel_->selected());
  view.moved_T_base = movedBase();
}

// Updates the list to the drawn pieces; the selection is identified by its cut.
void PieceCuts::showPieces() {
  const auto result = work_.document.itemResult(Stage::Decompose);
  const PiecesPresenter& drawn = work_.presenter.pieces();
  std::vector<panels::PieceRow> rows;
  double before = 0.0;
  if (result && drawn.count() > 0) {
    const project::DecompositionReport& report = result->job.report.item().decomposition;
    before = report.riskyAreaBeforeMm2;
    for (std::size_t i = 0; i < report.pieceList.size(); ++i) {
      const project::PieceReport& piece = report.pieceList[i];
      rows.push_back({piece.parent, colourOf(scene::pieceColour(static_cast<int>(i))),
                      piece.volumeMm3, piece.riskyAreaMm2, QString::fromStdString(piece.material)});
    }
  }
  const int chosen = drawn.pieceOf(chosenCut_);
  panel_->setPieces(std::move(rows), before);
  panel_->select(chosen);
  if (chosen < 0)
    chosenCut_ = -1;
  showCuts();
}

// Shows the user's cuts if their number matches the shown pieces, else those of the shown pieces.
void PieceCuts::showCuts() {
  const std::string text = chosenText(work_.document.choices(), kCuts);
  cuts_ = work_.presenter.pieces().cuts();
  if (!text.empty())
    try {
      std::vector<planar::GivenCut> own = planar::readGivenCuts(modes::planesText(text), kCuts);
      if (own.size() == cuts_.size())
        cuts_ = std::move(own);
    } catch (const base::Error&) {
      // Planning reports the error.
    }
  panel_->setOwnCuts(!text.empty());
  // Offered if the search uses the scheme with a root.
  panel_->setRootOffered(text.empty() && chosenText(work_.document.choices(), kScheme) == "greedy");
  if (work_.document.upToDate(Stage::Decompose)) {
    work_.presenter.pieces().dropEstimate();
    panel_->clearEstimate();
  }
}

void PieceCuts::select(int piece) {
  panel_->select(piece);
  chosenCut_ = work_.presenter.pieces().cutOf(piece);
  work_.shell.showView();
}

// Returns the displacement of the chosen piece's plane since the pieces were made.
std::optional<Eigen::Isometry3d> PieceCuts::movedBase() const {
  const std::vector<planar::GivenCut>& shown = work_.presenter.pieces().cuts();
  const auto cut = static_cast<std::size_t>(chosenCut_);
  if (chosenCut_ < 0 || cut >= cuts_.size() || cut >= shown.size() || same(cuts_[cut], shown[cut]))
    return std::nullopt;
  const planar::Plane& plane = cuts_[cut].plane;
  const Eigen::Vector3d from = shown[cut].point;
  const Eigen::Vector3d to = from - plane.heightOf(from) * plane.normal;
  Eigen::Isometry3d moved_T_base = Eigen::Isometry3d::Identity();
  moved_T_base.translate(to);
  moved_T_base.rotate(geometry::shortestRotation(shown[cut].plane.normal, plane.normal));
  moved_T_base.translate(-from);
  return moved_T_base;
}

void PieceCuts::showHandles() {
  if (work_.viewport.tool() != viewer::Tool::None &&
      work_.viewport.tool() != viewer::Tool::CutPlane)
    return;
  const auto cut = static_cast<std::size_t>(chosenCut_);
  const bool there = shown_() && chosenCut_ >= 0 && cut < cuts_.size();
  panel_->setHandles(there);
  if (!there) {
    if (std::exchange(handles_, false)) {
      work_.viewport.setTool(viewer::Tool::None);
      if (!work_.presenter.partBox().isEmpty())
        work_.viewport.setGizmoCentre(work_.presenter.partBox().center());
    }
    return;
  }
  const planar::Plane& plane = cuts_[cut].plane;
  const Eigen::Vector3d shown = work_.presenter.pieces().cuts()[cut].point;
  work_.viewport.setGizmoCentre(shown - plane.heightOf(shown) * plane.normal +
                                    work_.presenter.pieces().planeOffset(
                                        work_.presenter.pieces().pieceOf(chosenCut_), explodeMm()),
                                scene::baseAxes(plane.normal));
  handles_ = true;
  work_.viewport.setTool(viewer::Tool::CutPlane);
}

void PieceCuts::gizmoDragged(const viewer::GizmoChange& change, bool finished) {
  const auto placed = work_.document.itemResult(Stage::Load);
  const auto cut = static_cast<std::size_t>(chosenCut_);
  if (chosenCut_ < 0 || cut >= cuts_.size() || cutsBeforeDrag_.size() != cuts_.size())
    return;
  cuts_[cut] = moved(cutsBeforeDrag_[cut], change);
  const bool changed = !same(cuts_[cut], cutsBeforeDrag_[cut]);
  if (changed && placed)
    work_.presenter.pieces().estimate(placed->job.item().part, work_.document.choices(), cuts_,
                                      finished);
  if (finished && changed)
    setCuts(QString::fromStdString(planar::givenCutsText(cuts_)), tr("move cut"));
  work_.shell.showView();
}

void PieceCuts::setCuts(const QString& text, const QString& editName) {
  project::Choices choices = work_.document.choices();
  if (text.isEmpty())
    choices.item().parameters.erase(kCuts);
  else
    choices.item().parameters[kCuts] = text.toStdString();
  work_.document.setChoices(choices, editName);
}

void PieceCuts::pickRoot(const Eigen::Vector3d& point) {
  project::Choices choices = work_.document.choices();
  choices.item().parameters[kRoot] = modes::pieceRootText(point);
  work_.document.setChoices(choices, tr("pick root"));
}

bool PieceCuts::concerns(const plan::Finding& finding) const {
  const auto result = work_.document.itemResult(Stage::Decompose);
  return plan::stageOf(finding) == Stage::Decompose && finding.where &&
         work_.presenter.hasPieces() && result && result->job.item().pieces();
}

void PieceCuts::lookAt(const plan::Finding& finding) {
  viewer::Viewport& viewport = work_.viewport;
  panel_->setExplodeShare(0.0); // the place is on the part
  select(-1);
  const auto pieces = work_.document.itemResult(Stage::Decompose)->job.item().pieces();
  const Eigen::Vector3d normal = faceNormal(pieces->pieces, *finding.where);
  const Eigen::Vector3d eye = scene::towardsEye(viewport.scene().renderer()).normalized();
  if (normal.dot(eye) < kMinFacing) {
    // Look from about the user's present direction, as far as the face is visible from there.
    Eigen::Vector3d level(eye.x(), eye.y(), 0.0);
    if (level.norm() < 1e-3 || level.normalized().dot(normal) < -0.5)
      level = Eigen::Vector3d(normal.x(), normal.y(), 0.0);
    viewport.viewFrom(level.norm() > 1e-3 ? (normal + 1.5 * level.normalized()).eval() : normal);
  }
  viewport.lookAt(*finding.where, kFaceRadiusMm);
}

void PieceCuts::clicked(const std::optional<scene::Hit>& hit) {
  using What = scene::Hit::What;
  if (work_.viewport.tool() == viewer::Tool::PickPoint) {
    if (hit && (hit->what == What::Part || hit->what == What::Piece)) {
      work_.viewport.setTool(viewer::Tool::None);
      pickRoot(hit->point);
    }
  } else if (shown_()) {
    select(hit && hit->what == What::Piece ? static_cast<int>(hit->piece) : -1);
  }
}

void PieceCuts::changeTool(viewer::Tool tool) {
  panel_->setPickingRoot(tool == viewer::Tool::PickPoint);
  if (tool == viewer::Tool::None && shown_() && chosenCut_ >= 0) // cancelled by a key
    select(-1);
}

} // namespace voluta::window
