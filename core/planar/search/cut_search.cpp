#include "planar/search/cut_search.h"

#include "base/parallel.h"
#include "geometry/append_mesh.h"
#include "geometry/measures.h"
#include "planar/face_table.h"
#include "planar/head_reach.h"
#include "planar/piece_order.h"
#include "planar/search/cut_search_state.h"
#include "planar/search/plane_polish.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace voluta::planar {

using Eigen::Vector3d;

namespace {

constexpr std::size_t kPiecesTried = 6, kCutsTried = 24; // per partial result, per piece
// Similar cuts: cosine of normals, distance of offsets
constexpr double kAlike = 0.95, kAlikeMm = 5.0;
constexpr double kPieceCost = 0.002; // of the initial risky area, per additional piece
constexpr double kMinGain = 0.0005;  // of the initial risky area, per cut
// Of a piece's base: share that may be lost, price
constexpr double kBaseLoss = 0.4, kBaseWeight = 0.02;
constexpr double kBlockedCost =
    0.02;                    // of the initial risky area, per piece that the head does not reach
constexpr int kCarrier = -1; // in place of a piece's number
constexpr std::size_t kResults = 4;
// Beam levels after which the beam is half as wide, since late cuts gain little
constexpr int kWideLevels = 8;
constexpr std::size_t kCheckedAtOnce = 16; // candidates
constexpr std::size_t kBehindTried = 6;    // blocked candidates
constexpr std::size_t kTries = 240;        // cuts tried per level

} // namespace

CutSearch::CutSearch(std::vector<Piece> pieces, const PlanarOptions& options, double riskyBeforeMm2,
                     const Footing& footing, double headMarginMm, const base::RunContext& ctx)
    : options_(options), ctx_(ctx), head_(options.head, headMarginMm),
      normals_(evenDirections(options.normals, options.lowestZ)),
      carrier_(carrierSamples(options.platform, kReachSpacingMm)), before_(riskyBeforeMm2),
      minimum_(kMinGain * riskyBeforeMm2), footing_(footing) {
  constexpr double kFlatShare = 0.004;
  geometry::TriangleMesh all;
  for (const Piece& piece : pieces) {
    geometry::appendMesh(all, piece.solid.mesh);
    for (const std::int32_t tag : piece.solid.tag)
      tags_ = std::max(tags_, tag + kTagsPerCut);
  }
  const std::vector<Vector3d> flat = flatDirections(all, kFlatShare, 24, options.lowestZ);
  normals_.insert(normals_.begin(), flat.begin(), flat.end());
  if (!options.platform.polygon.empty() && !head_.empty() && !pieces.empty())
    plate_ = samplesOfPlate(pieces.front());
  for (Piece& piece : pieces) {
    start_.push_back(node(std::move(piece)));
    start_.back()->id = ids_++;
  }
}

CutSearch::~CutSearch() = default;

std::shared_ptr<const PointBlocks> CutSearch::samplesOfPlate(const Piece& piece) const {
  return std::make_shared<PointBlocks>(
      plateSamples(plateUnder(piece, options_), options_.platform.thicknessMm, kReachSpacingMm));
}

CutSearch::NodePtr CutSearch::node(Piece piece) {
  auto made = std::make_shared<Node>();
  made->piece = std::move(piece);
  made->risky = riskyArea(made->piece, options_.rule);
  made->base = baseArea(made->piece, options_.rule);
  made->volume = geometry::volume(made->piece.solid.mesh);
  if (made->piece.baseTag == kPlate && footing_.contactMm2 > 0.0) {
    const Footing remaining = footingOf(made->piece, options_.rule);
    made->footCost =
        before_ *
        (options_.contactWeight * (1.0 - remaining.contactMm2 / footing_.contactMm2) +
         options_.hullWeight * (1.0 - remaining.hullMm2 / std::max(1e-9, footing_.hullMm2)));
  }
  made->holds = sectionsHeld(made->piece);
  if (!head_.empty()) {
    made->body = surfaceSamples(made->piece.solid.mesh, kReachSpacingMm);
    made->tips = tipsOf(made->body);
    if (made->piece.baseTag == kPlate) // the carrier of the plate is checked separately
      made->plate = plate_ ? plate_ : samplesOfPlate(made->piece);
    made->lowestTip = 1e300;
    for (const Vector3d& p : made->tips)
      made->lowestTip = std::min(made->lowestTip, made->piece.base.normal.dot(p));
    made->lowestTip = std::max(made->lowestTip, firstTipMm(made->piece, options_.rule));
    for (const Vector3d& p : made->body) {
      made->box.extend(p);
      if (p.z() <= 0.0)
        made->under.push_back(p);
    }
    if (made->plate)
      made->box.extend(made->plate->box());
  }
  return made;
}

double CutSearch::maxContactLoss(const Node& n) const {
  if (n.piece.baseTag != kPlate)
    return kBaseLoss * n.base;
  return std::max(0.0, n.base - options_.keptContact * footing_.contactMm2);
}

double CutSearch::footPrice(const Node& n) const {
  if (n.piece.baseTag != kPlate)
    return kBaseWeight;
  return footing_.contactMm2 > 0.0 ? options_.contactWeight * before_ / footing_.contactMm2 : 0.0;
}

// Returns whether the remaining foot on the plate is wide enough.
bool CutSearch::keepsContact(const Node& n, const Plane& plane) const {
  return n.piece.baseTag != kPlate || footingBelow(n.piece, n.faces.stands, plane).hullMm2 >=
                                          options_.keptHull * footing_.hullMm2 - 1e-9;
}

// Returns whether the head clears plate and carrier while printing all that is above the plane,
// which may be more than the candidate cuts off. The remainder of the piece is below.
bool CutSearch::approachIsFree(const Node& n, const CutCandidate& c) const {
  if (head_.empty())
    return true;
  std::vector<Vector3d> tips, obstacles;
  Obstacles under{n.under, carrier_};
  if (n.plate)
    under.insert(under.end(), n.plate->blocks().begin(), n.plate->blocks().end());
  for (const PointBlock& block : under)
    if (!block.liesBelow(c.plane.normal, c.plane.offsetMm))
      for (const Vector3d& p : block.points)
        if (c.plane.heightOf(p) > 0.0)
          obstacles.push_back(p);
  if (obstacles.empty())
    return true;
  for (const Vector3d& p : n.tips)
    if (c.plane.heightOf(p) > 0.0)
      tips.push_back(p);
  return !head_.blocked(tips, {obstacles}, c.plane.normal,
                        c.plane.offsetMm + 2.0 * options_.rule.contactMm);
}

// Keeps the best dissimilar candidates; those come first that the head can print with the piece as
// it is.
void CutSearch::findCandidates(Node& n) {
  if (n.searched)
    return;
  n.searched = true;
  n.faces = faceTable(n.piece, options_.rule);
  CandidateOptions options;
  options.stepMm = options_.stepMm;
  options.minMm2 = minimum_;
  options.maxContactLossMm2 = maxContactLoss(n);
  options.footPrice = footPrice(n);
  std::vector<CutCandidate> found =
      cutCandidates(n.piece, n.faces, options_.rule, normals_, options, ctx_);
  const auto alike = [](const CutCandidate& o, const CutCandidate& c) {
    return o.plane.normal.dot(c.plane.normal) > kAlike &&
           std::abs(o.plane.heightOf(c.topMm) - c.plane.heightOf(c.topMm)) < kAlikeMm &&
           std::abs(o.plane.heightOf(o.topMm) - c.plane.heightOf(o.topMm)) < kAlikeMm;
  };
  const auto isNew = [&](const CutCandidate& c, const std::vector<CutCandidate>& among) {
    return std::none_of(among.begin(), among.end(),
                        [&](const CutCandidate& o) { return alike(o, c); });
  };
  std::vector<CutCandidate> behind; // blocked by an obstacle
  for (std::size_t at = 0; at < found.size() && n.candidates.size() < kCutsTried;) {
    std::vector<CutCandidate> checked;
    for (; at < found.size() && checked.size() < kCheckedAtOnce; ++at)
      if (isNew(found[at], n.candidates) && keepsContact(n, found[at].plane))
        checked.push_back(found[at]);
    std::vector<char> free(checked.size(), 0);
    base::parallelChunks(ctx_, free.size(), 1, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
        free[i] = approachIsFree(n, checked[i]);
    });
    for (std::size_t i = 0; i < free.size() && n.candidates.size() < kCutsTried; ++i) {
      std::vector<CutCandidate>& to = free[i] != 0 ? n.candidates : behind;
      if ((free[i] != 0 || to.size() < kBehindTried) && isNew(checked[i], to))
        to.push_back(checked[i]);
    }
  }
  n.candidates.insert(n.candidates.end(), behind.begin(), behind.end());
  n.cuttings.resize(n.candidates.size());
  n.tried.assign(n.candidates.size(), false);
}

std::vector<CutSearch::Option> CutSearch::optionsOf(const std::vector<State>& beam, int firstId) {
  std::vector<Option> out;
  for (const State& state : beam) {
    std::vector<NodePtr> worst = state.nodes;
    std::stable_sort(worst.begin(), worst.end(),
                     [](const NodePtr& a, const NodePtr& b) { return a->risky > b->risky; });
    std::size_t pieces = 0;
    for (const NodePtr& n : worst) {
      if (n->risky < minimum_ || pieces == kPiecesTried)
        break;
      if (n->id < firstId)
        continue;
      findCandidates(*n);
      bool any = false;
      for (std::size_t c = 0; c < n->candidates.size(); ++c) {
        if (n->tried[c] && !n->cuttings[c])
          continue;
        any = true;
        out.push_back({&state, n, c, state.cost - n->candidates[c].gainMm2});
      }
      pieces += any;
    }
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Option& a, const Option& b) { return a.estimate < b.estimate; });
  return out;
}

void CutSearch::tryCuts(const std::vector<Option>& options, std::size_t begin, std::size_t end) {
  struct Task {
    Node* node = nullptr;
    std::size_t candidate = 0;
    std::shared_ptr<Cutting> made;
  };
  std::vector<Task> tasks;
  for (std::size_t i = begin; i < end; ++i) {
    Node& n = *options[i].node;
    if (n.tried[options[i].candidate])
      continue;
    n.tried[options[i].candidate] = true;
    tasks.push_back({&n, options[i].candidate, nullptr});
  }
  base::parallelChunks(ctx_, tasks.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
      const Node& n = *tasks[i].node;
      const CutCandidate& c = n.candidates[tasks[i].candidate];
      PolishOptions polish;
      polish.maxContactLossMm2 = maxContactLoss(n);
      polish.footPrice = footPrice(n);
      polish.shiftMm = options_.stepMm;
      const Plane plane = polished(n.piece, n.faces, options_.rule, c.plane, c.top, polish);
      const CutRules rules{options_.rule, minimum_, options_.minVolumeMm3, maxContactLoss(n)};
      auto cut =
          cutPiece(n.piece, plane, tags_ + static_cast<std::int32_t>(i) * kTagsPerCut, rules);
      if (!cut)
        continue;
      auto made = std::make_shared<Cutting>();
      made->step.piece = n.id;
      made->step.plane = plane;
      made->step.topMm = c.topMm;
      made->step.sectionMiddles = cut->sectionMiddles;
      made->below = node(std::move(cut->below));
      for (Piece& piece : cut->above)
        made->above.push_back(node(std::move(piece)));
      tasks[i].made = std::move(made);
    }
  });
  tags_ += static_cast<std::int32_t>(tasks.size()) * kTagsPerCut;
  for (Task& task : tasks) {
    if (!task.made)
      continue;
    task.made->below->id = ids_++;
    task.made->step.below = task.made->below->id;
    for (const NodePtr& a : task.made->above) {
      a->id = ids_++;
      task.made->step.above.push_back(a->id);
    }
    task.node->cuttings[task.candidate] = std::move(task.made);
  }
}

void CutSearch::replace(State& state, const NodePtr& cut, std::shared_ptr<const Cutting> cutting) {
  std::erase(state.nodes, cut);
  state.nodes.push_back(cutting->below);
  state.nodes.insert(state.nodes.end(), cutting->above.begin(), cutting->above.end());
  state.cuts.push_back(std::move(cutting));
}

CutSearch::State CutSearch::after(const Option& option) {
  State made;
  made.nodes = option.state->nodes;
  made.cuts = option.state->cuts;
  replace(made, option.node, option.node->cuttings[option.candidate]);
  return made;
}

void CutSearch::weigh(State& state) {
  state.risky = 0.0;
  state.cost = kPieceCost * before_ * static_cast<double>(state.nodes.size());
  for (const NodePtr& n : state.nodes) {
    state.risky += n->risky;
    state.cost += n->risky + n->footCost;
  }
}

void CutSearch::weighHead(std::vector<State>& states) {
  if (head_.empty())
    return;
  askHead(states);
  for (State& state : states) {
    state.blocked = orderKnown(state).blocked;
    state.cost += kBlockedCost * before_ * static_cast<double>(state.blocked);
  }
}

PieceOrder CutSearch::orderKnown(const State& state) const {
  return orderIn(state, [&](const Node& of, const Node& what) {
    return ways_.at({of.id, what.id}) ||
           (what.piece.baseTag == kPlate && ways_.at({of.id, kCarrier}));
  });
}

void CutSearch::weighHead(State& state) {
  std::vector<State> one{std::move(state)};
  weighHead(one);
  state = std::move(one.front());
}

void CutSearch::weighStart(State& state) {
  weigh(state);
  weighHead(state);
  if (state.blocked > 0)
    if (State free = state; clearWays(free, state.blocked - 1))
      state = std::move(free);
}

bool CutSearch::isBlocking(const Node& of, const Node& what) const {
  const Vector3d& up = of.piece.base.normal;
  const Eigen::AlignedBox3d& box = what.box;
  const double highest = up.dot(box.center()) + 0.5 * up.cwiseAbs().dot(box.sizes());
  return highest > of.lowestTip &&
         head_.blocked(of.tips, what.obstacles(), up, firstTipMm(of.piece, options_.rule));
}

bool CutSearch::carrierBlocks(const Node& of) const {
  return head_.blocked(of.tips, {carrier_}, of.piece.base.normal,
                       firstTipMm(of.piece, options_.rule));
}

// Computes the head checks that the states need and that are not cached yet.
void CutSearch::askHead(const std::vector<State>& states) {
  struct Check {
    const Node *of = nullptr, *what = nullptr; // nullptr: the carrier
    char blocked = 0;
  };
  std::vector<Check> ways;
  for (const State& state : states)
    orderIn(state, [&](const Node& of, const Node& what) {
      if (ways_.try_emplace({of.id, what.id}, false).second)
        ways.push_back({&of, &what, 0});
      if (what.piece.baseTag == kPlate && ways_.try_emplace({of.id, kCarrier}, false).second)
        ways.push_back({&of, nullptr, 0});
      return false;
    });
  base::parallelChunks(ctx_, ways.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      ways[i].blocked =
          ways[i].what ? isBlocking(*ways[i].of, *ways[i].what) : carrierBlocks(*ways[i].of);
  });
  for (const Check& check : ways)
    ways_[{check.of->id, check.what ? check.what->id : kCarrier}] = check.blocked != 0;
}

PieceOrder
CutSearch::orderIn(const State& state,
                   const std::function<bool(const Node& of, const Node& what)>& blocked) {
  std::vector<std::int32_t> standsOnTag;
  std::vector<std::vector<std::int32_t>> holds;
  for (const NodePtr& n : state.nodes) {
    standsOnTag.push_back(n->piece.baseTag);
    holds.push_back(n->holds);
  }
  return orderOf(standsOnTag, holds, [&](std::size_t i, std::size_t j) {
    return blocked(*state.nodes[i], *state.nodes[j]);
  });
}

// Returns the first dissimilar states: the same cuts in another order give about the same risky
// area.
std::vector<CutSearch::State> CutSearch::kept(std::vector<State> states,
                                              std::size_t maxCount) const {
  constexpr double kAlikeRisk = 5e-4; // of the risky area before
  std::vector<State> out;
  std::set<std::array<long, 3>> seen;
  for (State& state : states) {
    if (out.size() == maxCount)
      break;
    double foot = 0.0;
    for (const NodePtr& n : state.nodes)
      foot += n->piece.baseTag == kPlate ? n->volume : 0.0;
    if (seen.insert({static_cast<long>(state.nodes.size()),
                     std::lround(state.risky / (kAlikeRisk * before_)),
                     std::lround(10.0 * std::log(1.0 + foot))})
            .second)
      out.push_back(std::move(state));
  }
  return out;
}

bool CutSearch::better(const State& a, const State& b) const {
  if (a.blocked != b.blocked)
    return a.blocked < b.blocked;
  const double goal = options_.target * before_;
  if ((a.risky <= goal) != (b.risky <= goal))
    return a.risky <= goal;
  // Above the goal, compare the risky area first, in steps of half a per cent of the initial one.
  const auto step = [&](const State& s) { return std::floor(s.risky / (0.005 * before_)); };
  if (a.risky > goal && step(a) != step(b))
    return step(a) < step(b);
  return a.cost < b.cost - 1e-9;
}

std::vector<CutSearch::State> CutSearch::bestFrom(State start, std::size_t width, std::size_t tries,
                                                  int firstId) {
  constexpr std::size_t kBatch = 8;
  weighStart(start);
  const std::size_t blockedBefore = start.blocked;
  std::vector<State> beam{start}, best{start};
  const double goal = options_.target * before_;
  for (int level = 0; level < options_.maxCuts && best.front().risky > goal; ++level) {
    if (level == kWideLevels)
      width = (width + 1) / 2;
    const std::vector<Option> options = optionsOf(beam, firstId);
    std::vector<State> next, hidden; // the head does not reach all of the latter
    for (std::size_t at = 0; at < options.size() && next.size() < 2 * width && at < tries;
         at += kBatch) {
      const std::size_t end = std::min(at + kBatch, options.size());
      tryCuts(options, at, end);
      std::vector<State> made;
      for (std::size_t i = at; i < end; ++i)
        if (options[i].node->cuttings[options[i].candidate]) {
          made.push_back(after(options[i]));
          weigh(made.back());
          if (made.back().risky >= options[i].state->risky - 0.5 * minimum_)
            made.pop_back();
        }
      weighHead(made);
      for (State& state : made)
        (state.blocked <= blockedBefore ? next : hidden).push_back(std::move(state));
    }
    std::stable_sort(hidden.begin(), hidden.end(),
                     [](const State& a, const State& b) { return a.cost < b.cost; });
    for (State& state : kept(std::move(hidden), width)) {
      const double asItWas = state.risky;
      if (clearWays(state, blockedBefore) && state.risky <= asItWas + 0.5 * minimum_)
        next.push_back(std::move(state));
    }
    if (next.empty())
      break;
    std::stable_sort(next.begin(), next.end(),
                     [](const State& a, const State& b) { return a.cost < b.cost; });
    beam = kept(std::move(next), width);
    best.insert(best.end(), beam.begin(), beam.end());
    std::stable_sort(best.begin(), best.end(),
                     [&](const State& a, const State& b) { return better(a, b); });
    best = kept(std::move(best), kResults);
  }
  return best;
}

SearchResult CutSearch::resultOf(const State& state) {
  SearchResult result;
  for (const NodePtr& n : state.nodes)
    result.pieces.push_back(n->piece);
  for (const auto& cutting : state.cuts)
    result.steps.push_back(cutting->step);
  result.riskyMm2 = state.risky;
  return result;
}

std::vector<SearchResult> CutSearch::run() {
  State start;
  start.nodes = start_;
  std::vector<SearchResult> out;
  for (const State& state : bestFrom(std::move(start), options_.beam, kTries, 0))
    out.push_back(resultOf(state));
  return out;
}

} // namespace voluta::planar
