#include "planar/published/piece_merge.h"
#include "planar/search/cut_search_state.h"
#include "planar/search/plane_polish.h"

#include <algorithm>

namespace voluta::planar {

namespace {

constexpr double kMin = 1e-4; // of the initial risky area: minimum gain of a move

// Returns the face that reaches highest along a direction.
int highestFace(const geometry::TriangleMesh& mesh, const Eigen::Vector3d& direction) {
  int best = 0;
  double maximum = -1e300;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int k = 0; k < 3; ++k)
      if (const double h = direction.dot(mesh.corner(t, k)); h > maximum) {
        maximum = h;
        best = static_cast<int>(t);
      }
  return best;
}

template <typename Nodes, typename Node>
Nodes without(const Nodes& nodes, const Node& a, const Node& b) {
  Nodes out;
  for (const auto& n : nodes)
    if (n != a && n != b)
      out.push_back(n);
  return out;
}

} // namespace

// Returns pairs of pieces of which the second is based on the first alone, sorted by risky area,
// largest first.
std::vector<std::pair<CutSearch::NodePtr, CutSearch::NodePtr>>
CutSearch::pairsOf(const State& state) {
  std::vector<std::pair<NodePtr, NodePtr>> pairs;
  for (const NodePtr& upper : state.nodes)
    for (const NodePtr& lower : state.nodes)
      if (upper != lower && upper->piece.baseTag >= 0 &&
          std::binary_search(lower->holds.begin(), lower->holds.end(), upper->piece.baseTag))
        pairs.emplace_back(lower, upper);
  std::stable_sort(pairs.begin(), pairs.end(), [](const auto& a, const auto& b) {
    return a.first->risky + a.second->risky > b.first->risky + b.second->risky;
  });
  return pairs;
}

bool CutSearch::movePlanes(State& state) {
  const double minimum = kMin * before_;
  for (const auto& [lower, upper] : pairsOf(state)) {
    ctx_.checkpoint();
    if (lower->risky + upper->risky < minimum || !moved_.insert({lower->id, upper->id}).second)
      continue;
    auto joined = merged(lower->piece, upper->piece);
    if (!joined)
      continue;
    const NodePtr whole = node(std::move(*joined));
    whole->faces = faceTable(whole->piece, options_.rule);
    PolishOptions polish;
    polish.maxContactLossMm2 = maxContactLoss(*whole);
    polish.footPrice = footPrice(*whole);
    polish.shiftMm = options_.stepMm;
    polish.rounds = 8;
    const int top = highestFace(whole->piece.solid.mesh, upper->piece.base.normal);
    const Plane plane =
        polished(whole->piece, whole->faces, options_.rule, upper->piece.base, top, polish);
    const CutRules rules{options_.rule, minimum, options_.minVolumeMm3, maxContactLoss(*whole)};
    if (!keepsContact(*whole, plane))
      continue;
    auto cut = cutPiece(whole->piece, plane, tags_, rules);
    tags_ += kTagsPerCut;
    if (!cut)
      continue;
    State made;
    made.nodes = without(state.nodes, lower, upper);
    made.nodes.push_back(node(std::move(cut->below)));
    for (Piece& piece : cut->above)
      made.nodes.push_back(node(std::move(piece)));
    for (const NodePtr& n : made.nodes)
      if (n->id < 0)
        n->id = ids_++;
    weigh(made);
    if (made.risky > state.risky - minimum)
      continue;
    weighHead(made);
    if (!gains(made, state))
      continue;
    state = std::move(made);
    return true;
  }
  return false;
}

bool CutSearch::cutAnew(State& state) {
  constexpr std::size_t kWidth = 2, kTries = 24, kPairs = 6;
  for (const auto& [lower, upper] : pairsOf(state)) {
    ctx_.checkpoint();
    if (anew_.size() == kPairs)
      return false;
    if (lower->risky + upper->risky < minimum_ || !anew_.insert({lower->id, upper->id}).second)
      continue;
    auto joined = merged(lower->piece, upper->piece);
    if (!joined)
      continue;
    State start;
    start.nodes = without(state.nodes, lower, upper);
    start.nodes.push_back(node(std::move(*joined)));
    const int first = ids_++;
    start.nodes.back()->id = first;
    State best = bestFrom(std::move(start), kWidth, kTries, first).front();
    if (!gains(best, state))
      continue;
    state = std::move(best);
    return true;
  }
  return false;
}

// Risky area above the target counts several times, as reaching the target has priority.
bool CutSearch::gains(const State& a, const State& b) const {
  constexpr double kShort = 4.0;
  if (a.blocked != b.blocked)
    return a.blocked < b.blocked;
  const double goal = options_.target * before_;
  const auto cost = [&](const State& s) { return s.cost + kShort * std::max(0.0, s.risky - goal); };
  return cost(a) < cost(b) - kMin * before_;
}

SearchResult CutSearch::bettered() {
  constexpr int kMoves = 60;
  State state;
  state.nodes = start_;
  weighStart(state);
  const double goal = options_.target * before_;
  for (int move = 0; move < kMoves && (state.risky > goal || state.blocked > 0); ++move)
    if (!movePlanes(state) && !cutAnew(state))
      break;
  return resultOf(state);
}

} // namespace voluta::planar
