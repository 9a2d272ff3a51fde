// Pieces of planar mode on the Layers page: chosen in tree or viewport, their cuts dragged.
#include "window/main_window.h"

#include "geometry/measures.h"
#include "modes/piece_search.h"
#include "modes/planar_modes.h"
#include "panels/pieces_panel.h"
#include "planar/given_cuts.h"

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
constexpr double kFaceRadiusMm = 20.0; // of the part around a face that is looked at
constexpr double kLeastFacing = 0.3;   // cosine between a face and the eye that it is seen well by
// Of the part's diagonal, at the slider's end: between two pieces, and from the first to the last.
constexpr double kExplodeShare = 0.4, kExplodeAllShare = 1.0;

QColor colourOf(const scene::Colour& c) {
  return QColor::fromRgbF(static_cast<float>(c[0]), static_cast<float>(c[1]),
                          static_cast<float>(c[2]));
}

std::string chosenText(const project::Choices& choices, const char* key) {
  const auto chosen = choices.parameters.find(key);
  return chosen == choices.parameters.end() ? std::string() : chosen->second;
}

// The plane of `cut` turned and moved.
planar::GivenCut moved(const planar::GivenCut& cut, const viewer::GizmoChange& change) {
  planar::GivenCut out;
  out.point = cut.point + change.moveMm;
  out.plane.normal = (change.turn * cut.plane.normal).normalized();
  out.plane.offsetMm = out.plane.normal.dot(out.point);
  return out;
}

// Outward, of the face whose middle is nearest.
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

void MainWindow::connectPieces() {
  connect(&presenter_->pieces(), &PiecesPresenter::drawn, this, &MainWindow::showPieces);
  connect(&presenter_->pieces(), &PiecesPresenter::estimated, this,
          [this](double riskyMm2, bool exact, const QString& problem) {
            piecesPanel_->setEstimate({riskyMm2, exact, problem});
          });
  connect(piecesPanel_, &panels::PiecesPanel::selectionChanged, this, &MainWindow::selectPiece);
  connect(piecesPanel_, &panels::PiecesPanel::viewChanged, this, &MainWindow::showView);
  connect(piecesPanel_, &panels::PiecesPanel::dragging, this, [this](bool on) {
    viewport_->setDragging(on);
    if (!on) // what was moved out of the picture is in it again
      viewport_->frameAll();
  });
  connect(piecesPanel_, &panels::PiecesPanel::keepCutsRequested, this, [this] {
    setCuts(QString::fromStdString(planar::givenCutsText(presenter_->pieces().cuts())),
            tr("keep cuts"));
  });
  connect(piecesPanel_, &panels::PiecesPanel::searchRequested, this,
          [this] { setCuts({}, tr("search for cuts")); });
  connect(piecesPanel_, &panels::PiecesPanel::rootPicking, this, [this](bool on) {
    if (on)
      selectPiece(-1);
    setTool(on ? viewer::Tool::PickPoint : viewer::Tool::None);
  });
}

bool MainWindow::piecesShown() const {
  return page() == Page::Layers && shownSubject() == LayerSubject::Pieces;
}

double MainWindow::explodeMm() const {
  const Eigen::AlignedBox3d& box = presenter_->partBox();
  if (box.isEmpty())
    return 0.0;
  const double share =
      std::min(kExplodeShare, kExplodeAllShare / std::max(1, presenter_->pieces().storeys() - 1));
  return piecesPanel_->explodeShare() * share * box.diagonal().norm();
}

// The list follows what is drawn; the piece that was chosen is so by its cut.
void MainWindow::showPieces() {
  const auto result = document_.result(Stage::Decompose);
  std::vector<panels::PieceRow> rows;
  double before = 0.0;
  if (result && presenter_->pieces().count() > 0) {
    const project::DecompositionReport& report = result->job.report.decomposition;
    before = report.riskyAreaBeforeMm2;
    for (std::size_t i = 0; i < report.pieceList.size(); ++i) {
      const project::PieceReport& piece = report.pieceList[i];
      rows.push_back({piece.parent, colourOf(scene::pieceColour(static_cast<int>(i))),
                      piece.volumeMm3, piece.riskyAreaMm2, QString::fromStdString(piece.material)});
    }
  }
  const int chosen = presenter_->pieces().pieceOf(chosenCut_);
  piecesPanel_->setPieces(std::move(rows), before);
  piecesPanel_->select(chosen);
  if (chosen < 0)
    chosenCut_ = -1;
  showCuts();
  showLayerCount();
}

// The user's cuts where there are as many as pieces on show were cut off, else those on show.
void MainWindow::showCuts() {
  const std::string text = chosenText(document_.choices(), kCuts);
  cuts_ = presenter_->pieces().cuts();
  if (!text.empty())
    try {
      std::vector<planar::GivenCut> own = planar::readGivenCuts(modes::planesText(text), kCuts);
      if (own.size() == cuts_.size())
        cuts_ = std::move(own);
    } catch (const base::Error&) {
      // The run that meets it says what is wrong with it.
    }
  piecesPanel_->setOwnCuts(!text.empty());
  // The scheme that asks for a root, where it is asked at all.
  piecesPanel_->setRootOffered(text.empty() &&
                               chosenText(document_.choices(), kScheme) == "greedy");
  if (document_.upToDate(Stage::Decompose)) {
    presenter_->pieces().dropEstimate();
    piecesPanel_->clearEstimate();
  }
}

void MainWindow::selectPiece(int piece) {
  piecesPanel_->select(piece);
  chosenCut_ = presenter_->pieces().cutOf(piece);
  showView();
}

// Where the chosen piece's plane is now, off where it was when the pieces were made.
std::optional<Eigen::Isometry3d> MainWindow::movedBase() const {
  const std::vector<planar::GivenCut>& shown = presenter_->pieces().cuts();
  const auto cut = static_cast<std::size_t>(chosenCut_);
  if (chosenCut_ < 0 || cut >= cuts_.size() || cut >= shown.size() || same(cuts_[cut], shown[cut]))
    return std::nullopt;
  const planar::Plane& plane = cuts_[cut].plane;
  const Eigen::Vector3d from = shown[cut].point;
  const Eigen::Vector3d to = from - plane.heightOf(from) * plane.normal;
  Eigen::Isometry3d moved_T_base = Eigen::Isometry3d::Identity();
  moved_T_base.translate(to);
  moved_T_base.rotate(Eigen::Quaterniond::FromTwoVectors(shown[cut].plane.normal, plane.normal));
  moved_T_base.translate(-from);
  return moved_T_base;
}

// Handles on the chosen piece's base plane; elsewhere the tools are those of the part.
void MainWindow::showCutHandles() {
  if (viewport_->tool() != viewer::Tool::None && viewport_->tool() != viewer::Tool::CutPlane)
    return;
  const auto cut = static_cast<std::size_t>(chosenCut_);
  const bool there = piecesShown() && chosenCut_ >= 0 && cut < cuts_.size();
  piecesPanel_->setHandles(there);
  if (!there) {
    if (std::exchange(cutHandles_, false)) {
      viewport_->setTool(viewer::Tool::None);
      if (!presenter_->partBox().isEmpty())
        viewport_->setGizmoCentre(presenter_->partBox().center());
    }
    return;
  }
  const planar::Plane& plane = cuts_[cut].plane;
  const Eigen::Vector3d shown = presenter_->pieces().cuts()[cut].point;
  viewport_->setGizmoCentre(
      shown - plane.heightOf(shown) * plane.normal +
          presenter_->pieces().planeOffset(presenter_->pieces().pieceOf(chosenCut_), explodeMm()),
      scene::baseAxes(plane.normal));
  cutHandles_ = true;
  viewport_->setTool(viewer::Tool::CutPlane);
}

void MainWindow::dragCut(const viewer::GizmoChange& change, bool finished) {
  const auto placed = document_.result(Stage::Load);
  const auto cut = static_cast<std::size_t>(chosenCut_);
  if (chosenCut_ < 0 || cut >= cuts_.size() || cutsBeforeDrag_.size() != cuts_.size())
    return;
  cuts_[cut] = moved(cutsBeforeDrag_[cut], change);
  const bool changed = !same(cuts_[cut], cutsBeforeDrag_[cut]);
  if (changed && placed)
    presenter_->pieces().estimate(placed->job.part, document_.choices(), cuts_, finished);
  if (finished && changed)
    setCuts(QString::fromStdString(planar::givenCutsText(cuts_)), tr("move cut"));
  showView();
}

void MainWindow::setCuts(const QString& text, const QString& editName) {
  project::Choices choices = document_.choices();
  if (text.isEmpty())
    choices.parameters.erase(kCuts);
  else
    choices.parameters[kCuts] = text.toStdString();
  document_.setChoices(choices, editName);
}

void MainWindow::pickRoot(const Eigen::Vector3d& point) {
  project::Choices choices = document_.choices();
  choices.parameters[kRoot] = modes::pieceRootText(point);
  document_.setChoices(choices, tr("pick root"));
}

bool MainWindow::lookAtPieces(const plan::Finding& finding) {
  const auto result = document_.result(Stage::Decompose);
  if (finding.stage != "decompose" || !finding.where || !presenter_->hasPieces() || !result ||
      !result->job.pieces)
    return false;
  ViewChoices choices = options_->choices();
  choices.subject = LayerSubject::Pieces;
  options_->setChoices(choices);
  piecesPanel_->setExplodeShare(0.0); // the place is on the part
  selectPiece(-1);
  const Eigen::Vector3d normal = faceNormal(result->job.pieces->pieces, *finding.where);
  const Eigen::Vector3d eye = scene::towardsEye(viewport_->scene().renderer()).normalized();
  if (normal.dot(eye) < kLeastFacing) {
    // About from where the user looks, as far as that side goes.
    Eigen::Vector3d level(eye.x(), eye.y(), 0.0);
    if (level.norm() < 1e-3 || level.normalized().dot(normal) < -0.5)
      level = Eigen::Vector3d(normal.x(), normal.y(), 0.0);
    viewport_->viewFrom(level.norm() > 1e-3 ? (normal + 1.5 * level.normalized()).eval() : normal);
  }
  viewport_->lookAt(*finding.where, kFaceRadiusMm);
  return true;
}

} // namespace voluta::window
