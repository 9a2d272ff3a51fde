#include "planar/beam_search.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/stopwatch.h"
#include "geometry/measures.h"
#include "geometry/simplify.h"
#include "planar/cut_candidates.h"
#include "planar/head_reach.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <set>

namespace voluta::planar {

using Eigen::Vector3d;

namespace {

constexpr std::size_t kPiecesTried = 3, kCutsTried = 5; // of a partial result, of a piece
constexpr double kAlike = 0.98, kAlikeMm = 6.0;         // normals (cosine) and offsets of cuts
constexpr double kReachSpacingMm = 4.0;
constexpr double kBlockedShare = 0.002;
constexpr double kPieceCost = 0.003; // of the risky area before, for a piece more

struct Node;
using NodePtr = std::shared_ptr<Node>;

struct Cutting {
  Plane plane;
  std::int32_t tag = 0;
  std::vector<Vector3d> sections; // middle of each section cut off
  NodePtr below;
  std::vector<NodePtr> above;
};

struct Node {
  Piece piece;
  double risky = 0.0;
  int id = 0;
  std::optional<std::vector<Cutting>> cuttings; // once asked for
};

// How a partial result came about: piece `piece` of the one before, cut so.
struct Step {
  int node = 0; // Node::id that was cut
  const Cutting* cutting = nullptr;
};

struct State {
  std::vector<NodePtr> nodes;
  std::vector<Step> steps;
  double risky = 0.0;
  std::size_t blocked = 0;
  double cost = 0.0;
};

Vector3d sectionMiddle(const TaggedMesh& solid, std::int32_t tag) {
  Vector3d sum = Vector3d::Zero();
  double area = 0.0;
  for (std::size_t t = 0; t < solid.tag.size(); ++t)
    if (solid.tag[t] == tag) {
      const double a = geometry::triangleArea(solid.mesh, t);
      sum +=
          a * (solid.mesh.corner(t, 0) + solid.mesh.corner(t, 1) + solid.mesh.corner(t, 2)) / 3.0;
      area += a;
    }
  return area > 0.0 ? Vector3d(sum / area) : Vector3d::Zero();
}

class Search {
public:
  Search(const geometry::TriangleMesh& part, const PlanarOptions& options,
         const base::RunContext& ctx)
      : options_(options), ctx_(ctx), normals_(evenDirections(options.normals, options.lowestZ)),
        plate_(plateSamples(options.plate, kReachSpacingMm)) {
    Piece whole;
    whole.solid = tagged(part);
    root_ = node(std::move(whole));
    before_ = root_->risky;
    least_ = std::max(0.5, 0.002 * before_);
  }

  State run() {
    State start;
    start.nodes = {root_};
    start.risky = root_->risky;
    start.cost = start.risky;
    std::vector<State> beam{start};
    State best = start;
    const double goal = options_.target * before_;
    for (int level = 0; level < options_.mostCuts && best.risky > goal; ++level) {
      ctx_.report(static_cast<double>(level) / options_.mostCuts, "pieces");
      std::vector<State> next;
      for (const State& state : beam)
        expand(state, next);
      if (next.empty())
        break;
      std::stable_sort(next.begin(), next.end(),
                       [](const State& a, const State& b) { return a.cost < b.cost; });
      beam = diverse(next);
      for (const State& state : beam)
        if (better(state, best))
          best = state;
    }
    return best;
  }

  double before() const { return before_; }
  int rootId() const { return root_->id; }

private:
  NodePtr node(Piece piece) {
    auto made = std::make_shared<Node>();
    made->piece = std::move(piece);
    made->risky = riskyArea(made->piece, options_.rule);
    made->id = ids_++;
    return made;
  }

  bool better(const State& a, const State& b) const {
    const double goal = options_.target * before_;
    if ((a.risky <= goal) != (b.risky <= goal))
      return a.risky <= goal;
    return a.cost < b.cost - 1e-9;
  }

  std::vector<State> diverse(const std::vector<State>& sorted) const {
    std::vector<State> kept;
    std::set<std::vector<long>> seen;
    for (const State& state : sorted) {
      if (kept.size() == options_.beam)
        break;
      // Two results are alike when their pieces have the same volumes, to a per cent.
      std::vector<long> sizes;
      for (const NodePtr& n : state.nodes)
        sizes.push_back(std::lround(50.0 * std::log(1.0 + geometry::volume(n->piece.solid.mesh))));
      std::sort(sizes.begin(), sizes.end());
      if (seen.insert(sizes).second)
        kept.push_back(state);
    }
    return kept;
  }

  void expand(const State& state, std::vector<State>& next) {
    std::vector<NodePtr> worst = state.nodes;
    std::stable_sort(worst.begin(), worst.end(),
                     [](const NodePtr& a, const NodePtr& b) { return a->risky > b->risky; });
    for (std::size_t w = 0; w < std::min(kPiecesTried, worst.size()); ++w) {
      if (worst[w]->risky < least_)
        break;
      for (const Cutting& cutting : cuttingsOf(*worst[w])) {
        State made;
        made.steps = state.steps;
        made.steps.push_back({worst[w]->id, &cutting});
        for (const NodePtr& n : state.nodes)
          if (n != worst[w])
            made.nodes.push_back(n);
        made.nodes.push_back(cutting.below);
        made.nodes.insert(made.nodes.end(), cutting.above.begin(), cutting.above.end());
        for (const NodePtr& n : made.nodes)
          made.risky += n->risky;
        made.blocked = blockedIn(made);
        made.cost = made.risky + kPieceCost * before_ * static_cast<double>(made.nodes.size()) +
                    0.1 * before_ * static_cast<double>(made.blocked);
        next.push_back(std::move(made));
      }
    }
  }

  std::size_t blockedIn(const State& state) const {
    if (options_.head.sections.empty())
      return 0;
    std::vector<Piece> pieces;
    for (const NodePtr& n : state.nodes)
      pieces.push_back(n->piece);
    std::size_t blocked = 0;
    printOrder(std::move(pieces), options_, 1.5 * kReachSpacingMm, blocked);
    return blocked;
  }

  // Of many candidates some that are not alike, cut.
  const std::vector<Cutting>& cuttingsOf(Node& n) {
    if (n.cuttings)
      return *n.cuttings;
    CandidateOptions candidateOptions;
    candidateOptions.stepMm = options_.stepMm;
    candidateOptions.leastMm2 = least_;
    const std::vector<CutCandidate> candidates =
        cutCandidates(n.piece, options_.rule, normals_, candidateOptions, ctx_);
    std::vector<CutCandidate> chosen;
    std::vector<Cutting> made;
    for (const CutCandidate& c : candidates) {
      if (made.size() == kCutsTried || chosen.size() == 4 * kCutsTried)
        break;
      const bool alike = std::any_of(chosen.begin(), chosen.end(), [&](const CutCandidate& o) {
        return o.plane.normal.dot(c.plane.normal) > kAlike &&
               std::abs(o.plane.heightOf(c.plane.normal * c.plane.offsetMm)) < kAlikeMm &&
               (o.top - c.top).norm() < kAlikeMm;
      });
      if (alike)
        continue;
      chosen.push_back(c);
      if (auto cutting = cut(n, c.plane))
        made.push_back(std::move(*cutting));
    }
    n.cuttings = std::move(made);
    return *n.cuttings;
  }

  std::optional<Cutting> cut(const Node& n, const Plane& plane) {
    Cutting out;
    out.plane = plane;
    out.tag = tags_;
    const auto pieceOf = [&](const TaggedMesh& solid, std::int32_t tag) {
      Piece piece;
      piece.solid = solid;
      piece.base = plane;
      piece.baseTag = tag;
      return piece;
    };
    const auto wanted = [&](const TaggedMesh& solid) {
      if (geometry::volume(solid.mesh) < options_.leastVolumeMm3)
        return false;
      Piece as = pieceOf(solid, tags_);
      const double after = riskyArea(as, options_.rule);
      as.base = n.piece.base;
      as.baseTag = n.piece.baseTag;
      const std::vector<std::uint8_t> stands = standsOn(as, options_.rule);
      if (std::find(stands.begin(), stands.end(), 1) != stands.end())
        return false;
      // Its new section is no risk to it as it was.
      double before = 0.0;
      for (std::size_t t = 0; t < solid.tag.size(); ++t)
        if (solid.tag[t] != tags_ &&
            isRisky(geometry::triangleNormal(solid.mesh, t), n.piece.base.normal, options_.rule))
          before += geometry::triangleArea(solid.mesh, t);
      return before - after >= least_;
    };
    PlaneCut sides;
    try {
      sides = cutByPlane(n.piece.solid, plane, tags_, wanted);
    } catch (const base::Error&) {
      return std::nullopt;
    }
    if (sides.above.empty() || sides.below.mesh.empty())
      return std::nullopt;
    Piece below = n.piece;
    below.solid = sides.below;
    // All that stays must stand on what the piece stood on; what stands on it must not be cut.
    std::map<std::int32_t, int> holder;
    const std::vector<TaggedMesh> left = solids(sides.below);
    for (const TaggedMesh& solid : left) {
      Piece as = below;
      as.solid = solid;
      const std::vector<std::uint8_t> stands = standsOn(as, options_.rule);
      if (std::find(stands.begin(), stands.end(), 1) == stands.end())
        return std::nullopt;
    }
    bool torn = false;
    const auto hold = [&](const TaggedMesh& solid, int who) {
      for (const std::int32_t tag : solid.tag)
        if (tag >= 0 && tag < tags_ && holder.try_emplace(tag, who).first->second != who)
          torn = true;
    };
    hold(sides.below, 0);
    for (std::size_t i = 0; i < sides.above.size(); ++i)
      hold(sides.above[i], static_cast<int>(i) + 1);
    if (torn)
      return std::nullopt;
    std::vector<Vector3d> around = surfaceSamples(sides.below.mesh, kReachSpacingMm);
    around.insert(around.end(), plate_.begin(), plate_.end());
    for (std::size_t i = 0; i < sides.above.size(); ++i) {
      const std::int32_t tag = tags_ + static_cast<std::int32_t>(i);
      if (blockedShare(surfaceSamples(sides.above[i].mesh, kReachSpacingMm), around, plane.normal,
                       options_.head) > kBlockedShare)
        return std::nullopt;
      out.sections.push_back(sectionMiddle(sides.above[i], tag));
      Piece piece = pieceOf(sides.above[i], tag);
      piece.base.offsetMm = sides.offsetMm;
      out.above.push_back(node(std::move(piece)));
    }
    out.below = node(std::move(below));
    tags_ += static_cast<std::int32_t>(sides.above.size());
    return out;
  }

  const PlanarOptions& options_;
  const base::RunContext& ctx_;
  std::vector<Vector3d> normals_;
  std::vector<Vector3d> plate_;
  NodePtr root_;
  double before_ = 0.0, least_ = 0.0;
  int ids_ = 0;
  std::int32_t tags_ = 0;
};

// The steps of a search, done on the part itself. Pieces by Node::id of the search.
std::vector<Piece> replay(const geometry::TriangleMesh& part, const std::vector<Step>& steps,
                          int rootId, double& sectionMm2) {
  std::map<int, Piece> pieces;
  pieces[rootId].solid = tagged(part);
  for (const Step& step : steps) {
    const Cutting& cutting = *step.cutting;
    const auto at = pieces.find(step.node);
    base::require(at != pieces.end(), "beam search: the steps belong together");
    Piece below = std::move(at->second);
    pieces.erase(at);
    // Each section found in the search is the nearest of those that the part has.
    std::vector<Vector3d> middles;
    cutByPlane(below.solid, cutting.plane, cutting.tag, [&](const TaggedMesh& solid) {
      middles.push_back(sectionMiddle(solid, cutting.tag));
      return false;
    });
    std::vector<int> role(middles.size(), -1);
    for (std::size_t s = 0; s < cutting.sections.size(); ++s) {
      std::size_t best = middles.size();
      for (std::size_t m = 0; m < middles.size(); ++m)
        if (role[m] < 0 &&
            (best == middles.size() || (middles[m] - cutting.sections[s]).norm() <
                                           (middles[best] - cutting.sections[s]).norm()))
          best = m;
      if (best < middles.size())
        role[best] = static_cast<int>(s);
    }
    std::size_t asked = 0;
    PlaneCut sides = cutByPlane(below.solid, cutting.plane, cutting.tag,
                                [&](const TaggedMesh&) { return role[asked++] >= 0; });
    std::size_t taken = 0;
    for (const int r : role) {
      if (r < 0)
        continue;
      Piece& piece = pieces[cutting.above[static_cast<std::size_t>(r)]->id];
      piece.solid = std::move(sides.above[taken]);
      piece.base = {cutting.plane.normal, sides.offsetMm};
      piece.baseTag = cutting.tag + static_cast<std::int32_t>(taken);
      ++taken;
    }
    sectionMm2 += sides.sectionMm2;
    below.solid = std::move(sides.below);
    pieces[cutting.below->id] = std::move(below);
  }
  std::vector<Piece> out;
  for (auto& [id, piece] : pieces)
    out.push_back(std::move(piece));
  return out;
}

} // namespace

PlanarDecomposition beamDecompose(const geometry::TriangleMesh& part, const PlanarOptions& options,
                                  const base::RunContext& ctx) {
  if (part.empty() || !isClosed(part))
    throw base::Error(base::ErrorCode::UnusableInput, "the mesh is not closed", {},
                      "repair it, or use curved mode, which takes any mesh");
  PlanarDecomposition out;
  base::Stopwatch watch;
  Search search(geometry::simplified(part, options.searchTriangles), options, ctx.sub(0.0, 0.9));
  const State found = search.run();
  out.seconds.search = watch.seconds();
  Piece whole;
  whole.solid = tagged(part);
  out.riskyBeforeMm2 = riskyArea(whole, options.rule);
  std::vector<Piece> pieces = replay(part, found.steps, search.rootId(), out.sectionMm2);
  out.pieces = printOrder(std::move(pieces), options, 2.0, out.blockedPieces);
  for (const Piece& piece : out.pieces)
    out.riskyMm2 += riskyArea(piece, options.rule);
  out.seconds.cut = watch.seconds() - out.seconds.search;
  ctx.report(1.0, "pieces");
  return out;
}

} // namespace voluta::planar
