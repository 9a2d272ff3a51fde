#include "window/presenters/pieces_presenter.h"

#include "base/error.h"
#include "geometry/simplify.h"
#include "language/words.h"
#include "modes/planar_modes.h"
#include "pipeline/resolved.h"
#include "pipeline/stage_options.h"
#include "window/background.h"

#include <algorithm>

namespace voluta::window {

namespace {
constexpr std::size_t kCoarseTriangles = 2500; // enough for an area estimate, and quick to cut

struct Drawn {
  std::shared_ptr<const scene::PiecesDrawing> drawing;
  std::vector<planar::GivenCut> cuts;
  std::vector<std::size_t> pieceOfCut;
};

struct Estimated {
  double riskyMm2 = 0.0;
  QString problem;
  std::shared_ptr<const geometry::TriangleMesh> coarse;
};
int storeysOf(const std::vector<planar::Piece>& pieces) {
  std::vector<int> level;
  for (const planar::Piece& piece : pieces) // a piece comes after the one it is based on
    level.push_back(piece.parent >= 0 && piece.parent < static_cast<int>(level.size())
                        ? level[static_cast<std::size_t>(piece.parent)] + 1
                        : 1);
  return level.empty() ? 0 : *std::max_element(level.begin(), level.end());
}
} // namespace

PiecesPresenter::PiecesPresenter(viewer::Viewport& viewport, QObject* parent)
    : QObject(parent), viewport_(viewport), drawingRun_(std::make_unique<jobs::JobRunner>()),
      estimating_(std::make_unique<jobs::JobRunner>()) {}

PiecesPresenter::~PiecesPresenter() = default;

void PiecesPresenter::setPieces(std::shared_ptr<const planar::PlanarDecomposition> pieces,
                                const project::Choices& choices) {
  if (pieces == pieces_)
    return;
  pieces_ = std::move(pieces);
  if (!pieces_) {
    drawingRun_->cancel();
    drawing_.reset();
    cuts_.clear();
    pieceOfCut_.clear();
    storeys_ = 0;
    viewport_.scene().setPieces(nullptr);
    viewport_.requestFrame();
    emit drawn();
    return;
  }
  inBackground(
      *drawingRun_,
      [pieces = pieces_, choices] {
        return Drawn{
            scene::drawPieces(pieces->pieces, pipeline::riskRule(pipeline::resolve(choices))),
            planar::cutsOf(pieces->pieces), planar::cutPieces(pieces->pieces)};
      },
      [this](Drawn&& made) {
        drawing_ = std::move(made.drawing);
        cuts_ = std::move(made.cuts);
        pieceOfCut_ = std::move(made.pieceOfCut);
        storeys_ = storeysOf(pieces_->pieces);
        viewport_.scene().setPieces(drawing_);
        viewport_.requestFrame();
        emit drawn();
      });
}

void PiecesPresenter::showAgain() {
  viewport_.scene().setPieces(drawing_);
  viewport_.requestFrame();
}

int PiecesPresenter::cutOf(int piece) const {
  const auto at =
      std::find(pieceOfCut_.begin(), pieceOfCut_.end(), static_cast<std::size_t>(piece));
  return piece < 0 || at == pieceOfCut_.end() ? -1 : static_cast<int>(at - pieceOfCut_.begin());
}

int PiecesPresenter::pieceOf(int cut) const {
  return cut < 0 || cut >= static_cast<int>(pieceOfCut_.size())
             ? -1
             : static_cast<int>(pieceOfCut_[static_cast<std::size_t>(cut)]);
}

Eigen::Vector3d PiecesPresenter::planeOffset(int piece, double explodeMm) const {
  return drawing_ && piece >= 0 && piece < count()
             ? scene::basePlaneOffset(*drawing_, static_cast<std::size_t>(piece), explodeMm)
             : Eigen::Vector3d::Zero().eval();
}

void PiecesPresenter::estimate(std::shared_ptr<const geometry::TriangleMesh> part,
                               const project::Choices& choices, std::vector<planar::GivenCut> cuts,
                               bool exact) {
  wanted_ = Wanted{std::move(part), choices, std::move(cuts), exact};
  if (!estimating_->running())
    startEstimate();
}

void PiecesPresenter::dropEstimate() {
  wanted_.reset();
  estimating_->cancel();
}

void PiecesPresenter::startEstimate() {
  const Wanted now = *wanted_;
  wanted_.reset();
  auto known = coarse_.of == now.part ? coarse_.mesh : nullptr;
  inBackground(
      *estimating_,
      [now, known](const base::RunContext& ctx) {
        Estimated made{0.0, {}, known};
        if (!now.exact && !made.coarse)
          made.coarse = std::make_shared<const geometry::TriangleMesh>(
              geometry::simplified(*now.part, kCoarseTriangles));
        try {
          const pipeline::Resolved resolved = pipeline::resolve(now.choices);
          const planar::RiskRule rule = pipeline::riskRule(resolved);
          const double beadMm = resolved.process().beadWidthMm;
          for (const planar::Piece& piece :
               planar::cutApart(planar::wholePart(now.exact ? *now.part : *made.coarse, rule),
                                now.cuts, rule, beadMm, ctx))
            made.riskyMm2 += planar::riskyArea(piece, rule);
        } catch (const base::Error& error) {
          made.problem = language::words(error.whole());
        }
        return made;
      },
      [this, now](Estimated&& made) {
        if (made.coarse)
          coarse_ = {now.part, made.coarse};
        emit estimated(made.riskyMm2, now.exact, made.problem);
        if (wanted_)
          startEstimate();
      });
}

bool PiecesPresenter::busy() const {
  return drawingRun_->running() || estimating_->running();
}

} // namespace voluta::window
