#include "planar/search/beam_search.h"

#include "base/error.h"
#include "base/stopwatch.h"
#include "geometry/measures.h"
#include "geometry/simplify.h"
#include "planar/face_table.h"
#include "planar/head_reach.h"
#include "planar/piece_cut.h"
#include "planar/plate_contact.h"
#include "planar/published/fine_cuts.h"
#include "planar/search/cut_search.h"
#include "planar/search/plane_polish.h"

#include <algorithm>
#include <map>
#include <optional>

namespace voluta::planar {

using Eigen::Vector3d;

namespace {

// Returns the face whose centroid is nearest to a point.
int faceAt(const geometry::TriangleMesh& mesh, const Vector3d& p) {
  int best = 0;
  double minimum = 1e300;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const double d =
        ((mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0 - p).squaredNorm();
    if (d < minimum) {
      minimum = d;
      best = static_cast<int>(t);
    }
  }
  return best;
}

struct Pieces {
  std::vector<Piece> pieces;
  bool stand = true;
};

// Repeats the steps of a search on the original part. If a plane separates other pieces than in the
// search, on which later steps depend, it is polished again. A step that the part's finer shape
// does not allow is skipped, together with the steps that build on it.
Pieces onThePart(const Piece& part, const std::vector<CutStep>& steps, const PlanarOptions& options,
                 double minGainMm2) {
  std::map<int, Piece> pieces; // by the numbers of the search
  pieces[0] = part;
  Pieces out;
  std::int32_t tag = 0;
  int unusedId = -1; // ids of pieces that the search does not know
  for (const CutStep& step : steps) {
    const auto at = pieces.find(step.piece);
    if (at == pieces.end())
      continue;
    const Piece& piece = at->second;
    auto cut = cutOffAt(piece, step.plane, tag, step.sectionMiddles, options.rule);
    if (!step.clears && (!cut || cut->above.size() != step.above.size())) {
      const FaceTable faces = faceTable(piece, options.rule);
      PolishOptions polish;
      polish.shiftMm = options.stepMm;
      // The search has already weighed the loss of contact; allow only the additional loss due to
      // the finer shape.
      const int top = faceAt(piece.solid.mesh, step.topMm);
      const PlaneGain planned = planeGain(piece, faces, options.rule, step.plane, top, 1e300);
      polish.maxContactLossMm2 =
          std::min(planned.footMm2 + 0.02 * faces.standsMm2, 0.9 * faces.standsMm2);
      polish.footPrice = 1e-3;
      const Plane plane = polished(piece, faces, options.rule, step.plane, top, polish);
      const CutRules rules{options.rule, minGainMm2, options.minVolumeMm3,
                           polish.maxContactLossMm2};
      cut = cutPiece(piece, plane, tag, rules);
      CutRules any = rules;
      any.minGainMm2 = 0.0;
      any.maxContactLossMm2 = std::max(polish.maxContactLossMm2, 0.5 * faces.standsMm2);
      for (const double shift : {0.0, 0.4, -0.4, 0.8, -0.8, 1.6, -1.6})
        if (!cut || cut->above.size() != step.above.size())
          if (auto near =
                  cutPiece(piece, {step.plane.normal, step.plane.offsetMm + shift}, tag, any);
              near && (!cut || near->above.size() == step.above.size()))
            cut = std::move(near);
    }
    tag += kTagsPerCut;
    if (!cut) {
      pieces[step.below] = std::move(at->second);
      pieces.erase(step.piece);
      continue;
    }
    pieces.erase(at);
    pieces[step.below] = std::move(cut->below);
    std::vector<bool> selected(cut->above.size(), false);
    for (std::size_t s = 0; s < step.above.size(); ++s) {
      std::size_t best = selected.size();
      for (std::size_t m = 0; m < selected.size(); ++m)
        if (!selected[m] && (best == selected.size() ||
                             (cut->sectionMiddles[m] - step.sectionMiddles[s]).norm() <
                                 (cut->sectionMiddles[best] - step.sectionMiddles[s]).norm()))
          best = m;
      if (best == selected.size())
        continue;
      selected[best] = true;
      pieces[step.above[s]] = std::move(cut->above[best]);
    }
    for (std::size_t m = 0; m < selected.size(); ++m)
      if (!selected[m])
        pieces[unusedId--] = std::move(cut->above[m]);
  }
  for (auto& [id, piece] : pieces) {
    out.stand = out.stand && allStands(piece, options.rule);
    out.pieces.push_back(std::move(piece));
  }
  return out;
}

constexpr double kAbout = 1.25; // times the target: a further search is not worth its time
constexpr std::size_t kTriedOnThePart = 2; // results of a search

// Pieces in print order and their score.
struct Tried {
  std::vector<Piece> pieces;
  std::size_t blocked = 0;
  double riskyMm2 = 0.0;

  bool good(double goal) const { return blocked == 0 && riskyMm2 <= goal; }
  bool betterThan(const Tried& other, double goal) const {
    if (blocked != other.blocked)
      return blocked < other.blocked;
    if (riskyMm2 <= goal && other.riskyMm2 <= goal)
      return pieces.size() < other.pieces.size();
    return riskyMm2 < other.riskyMm2;
  }
};

Tried judged(std::vector<Piece> pieces, const PlanarOptions& options) {
  Tried tried;
  tried.pieces = printOrder(std::move(pieces), options, kReachSpacingMm, tried.blocked);
  for (const Piece& piece : tried.pieces)
    tried.riskyMm2 += riskyArea(piece, options.rule);
  return tried;
}

// Returns the options of successive searches, which run until the target is nearly reached: the
// given options; then planes that face up only (RoboFDM, constraint II) and less contact kept,
// because cuts that face down gain much at first and may leave pieces that block better cuts; and a
// finer mesh.
std::vector<PlanarOptions> searches(const PlanarOptions& options, std::size_t triangles) {
  constexpr double kFiner = 1.75;
  std::vector<PlanarOptions> out{options};
  if (options.lowestZ < 0.0) {
    out.push_back(withLessContact(options));
    out.back().lowestZ = 0.0;
  }
  if (options.keptContact < 1.0 || options.keptHull < 1.0 || triangles > options.searchTriangles) {
    out.push_back(withLessContact(options));
    out.back().searchTriangles =
        static_cast<std::size_t>(kFiner * static_cast<double>(options.searchTriangles));
  }
  return out;
}

// Cuts further by single planes, each with the largest gain: the search passes over small gains,
// because an additional piece has a price there.
std::vector<Piece> finished(std::vector<Piece> pieces, const PlanarOptions& options,
                            const Footing& footing, double minMm2, double targetMm2,
                            const base::RunContext& ctx) {
  FineCutOptions fine;
  fine.normals = options.normals;
  fine.stepMm = options.stepMm;
  fine.spacingMm = kReachSpacingMm;
  fine.minMm2 = minMm2;
  fine.targetMm2 = targetMm2;
  fine.footing = footing;
  std::int32_t tag = 0;
  for (const Piece& piece : pieces)
    for (const std::int32_t t : piece.solid.tag)
      tag = std::max(tag, t + 1);
  return fineCuts(std::move(pieces), options, fine, tag, ctx);
}

} // namespace

PlanarDecomposition beamDecompose(const geometry::TriangleMesh& part, const PlanarOptions& options,
                                  const base::RunContext& ctx) {
  if (part.empty() || !isClosed(part))
    throw base::Error(base::ErrorCode::UnusableInput, "the mesh is not closed"_text, {},
                      "repair it, or use curved mode, which takes any mesh"_text);
  PlanarDecomposition out;
  base::Stopwatch watch;
  const Piece whole = wholePart(part, options.rule);
  out.riskyBeforeMm2 = riskyArea(whole, options.rule);
  const Footing footing = footingOf(whole, options.rule);
  const double goal = options.target * out.riskyBeforeMm2;
  const double minimum = 5e-4 * out.riskyBeforeMm2;
  Tried best = judged({whole}, options);
  double share = 0.0;
  const std::vector<PlanarOptions> steps = searches(options, part.triangles.size());
  Piece coarse;
  std::size_t coarseTriangles = 0; // its requested number of triangles
  for (const PlanarOptions& step : steps) {
    if (best.good(kAbout * goal))
      break;
    const double next = share + 1.0 / static_cast<double>(steps.size());
    const base::RunContext searching = ctx.sub(share, next);
    share = next;
    searching.report(0.0, "pieces"_text);
    if (step.searchTriangles != coarseTriangles) {
      coarseTriangles = step.searchTriangles;
      coarse = wholePart(geometry::simplified(part, coarseTriangles), options.rule);
    }
    const double coarseBefore = riskyArea(coarse, options.rule);
    const bool asIs = part.triangles.size() <= step.searchTriangles;
    const double began = watch.seconds();
    const std::vector<SearchResult> found =
        CutSearch({coarse}, step, coarseBefore, footingOf(coarse, options.rule),
                  asIs ? kHeadMarginMm : kCoarseHeadMarginMm, searching)
            .run();
    out.seconds.search += watch.seconds() - began;
    // The best result whose pieces the head can build on the original part.
    std::optional<Tried> here;
    for (std::size_t i = 0; i < std::min(found.size(), kTriedOnThePart); ++i) {
      ctx.checkpoint();
      Pieces made =
          asIs ? Pieces{found[i].pieces, true} : onThePart(whole, found[i].steps, step, minimum);
      if (!made.stand)
        continue;
      Tried tried = judged(std::move(made.pieces), options);
      if (!here || tried.betterThan(*here, goal))
        here = std::move(tried);
      if (here->blocked == 0)
        break;
    }
    if (!here)
      continue;
    // Search again for improvements that the coarse mesh did not show.
    PlanarOptions last = step;
    last.beam = 2;
    const auto again = [&] {
      return CutSearch(here->pieces, last, out.riskyBeforeMm2, footing, kHeadMarginMm, searching);
    };
    const auto take = [&](std::vector<Piece> pieces) {
      Tried tried = judged(std::move(pieces), options);
      if (tried.betterThan(*here, goal))
        here = std::move(tried);
    };
    if (!here->good(goal) && !asIs)
      take(again().run().front().pieces);
    if (!here->good(goal))
      take(again().bettered().pieces);
    if (here->betterThan(best, goal))
      best = std::move(*here);
  }
  if (!best.good(kAbout * goal)) {
    Tried tried =
        judged(finished(best.pieces, options, footing, minimum, goal, ctx.quiet()), options);
    if (tried.betterThan(best, goal))
      best = std::move(tried);
  }
  out.pieces = std::move(best.pieces);
  out.blockedPieces = best.blocked;
  out.riskyMm2 = best.riskyMm2;
  for (const Piece& piece : out.pieces)
    out.sectionMm2 += piece.baseTag == kPlate ? 0.0 : baseArea(piece, options.rule);
  out.seconds.cut = watch.seconds() - out.seconds.search;
  ctx.report(1.0, "pieces"_text);
  return out;
}

} // namespace voluta::planar
