// Beam search over partial results: each is a set of pieces, which are cut further where it gains
// most.
#pragma once

#include "base/run_context.h"
#include "planar/head_reach.h"
#include "planar/piece_cut.h"
#include "planar/piece_order.h"
#include "planar/planar_decomposition.h"
#include "planar/plate_contact.h"
#include "planar/search/cut_candidates.h"

#include <Eigen/Core>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

namespace voluta::planar {

inline constexpr std::int32_t kTagsPerCut = 1000;

// A cut of the search: the cut piece and the resulting pieces, by the search's own numbers.
struct CutStep {
  int piece = 0;
  Plane plane;
  Eigen::Vector3d topMm = Eigen::Vector3d::Zero(); // on the surface of the part cut off
  int below = 0;
  std::vector<int> above;
  std::vector<Eigen::Vector3d> sectionMiddles; // of each piece above
  // A clearing: gains nothing itself, but the part cut off is printed after the piece it would hide
  bool clears = false;
};

struct SearchResult {
  std::vector<Piece> pieces;
  std::vector<CutStep> steps;
  double riskyMm2 = 0.0;
};

class CutSearch {
public:
  // Starts from `pieces`, numbered from 0. `riskyBeforeMm2` and `footing` are the whole part's;
  // shares refer to them, and the required contact with the plate follows from them. The head is
  // enlarged by headMarginMm.
  CutSearch(std::vector<Piece> pieces, const PlanarOptions& options, double riskyBeforeMm2,
            const Footing& footing, double headMarginMm, const base::RunContext& ctx);
  ~CutSearch();

  // Returns the best results, best first: those that reach the target with the fewest pieces, else
  // those with the smallest risky area. At least one (the start, if no cut helps). Throws
  // Cancelled.
  std::vector<SearchResult> run();

  // Improves the pieces: moves planes between two pieces, now that the directions on both sides are
  // known, and joins pieces with their neighbours and cuts them again, worst first, as long as that
  // helps and the target is not reached. Throws Cancelled.
  SearchResult bettered();

private:
  struct Node;
  struct Cutting;
  struct State;
  using NodePtr = std::shared_ptr<Node>;
  struct Option { // a possible cut of a piece of a partial result
    const State* state = nullptr;
    NodePtr node;
    std::size_t candidate = 0;
    double estimate = 0.0;
  };

  std::shared_ptr<const PointBlocks> samplesOfPlate(const Piece& piece) const;
  NodePtr node(Piece piece);
  double maxContactLoss(const Node& node) const;
  double footPrice(const Node& node) const; // risky area that a mm² of contact is worth
  bool keepsContact(const Node& node, const Plane& plane) const;
  bool approachIsFree(const Node& node, const CutCandidate& candidate) const;
  void findCandidates(Node& node);
  // Considers the pieces numbered firstId and up.
  std::vector<Option> optionsOf(const std::vector<State>& beam, int firstId);
  void tryCuts(const std::vector<Option>& options, std::size_t begin, std::size_t end);
  State after(const Option& option);
  static void replace(State& state, const NodePtr& cut, std::shared_ptr<const Cutting> cutting);
  bool isBlocking(const Node& of, const Node& what) const;
  bool carrierBlocks(const Node& of) const;
  void askHead(const std::vector<State>& states);
  PieceOrder orderKnown(const State& state) const;
  // Cuts pieces that block others, until the head reaches all but maxBlocked pieces. Returns
  // whether that succeeds.
  bool clearWays(State& state, std::size_t maxBlocked);
  // Returns a cut of `what` that leaves nothing of it in the way of `of`; nullptr if there is none.
  std::shared_ptr<Cutting> clearing(const Node& of, Node& what);
  static PieceOrder orderIn(const State& state,
                            const std::function<bool(const Node& of, const Node& what)>& blocked);
  std::vector<State> kept(std::vector<State> states, std::size_t maxCount) const;
  bool better(const State& a, const State& b) const;
  void weigh(State& state);
  void weighHead(std::vector<State>& states);
  void weighHead(State& state);
  // Does both; if pieces are hidden from the head, clears as many as possible.
  void weighStart(State& state);
  // Beam search of this width over the pieces numbered firstId and up, with at most `tries` cuts
  // per level.
  std::vector<State> bestFrom(State start, std::size_t width, std::size_t tries, int firstId);
  static SearchResult resultOf(const State& state);
  std::vector<std::pair<NodePtr, NodePtr>> pairsOf(const State& state);
  bool gains(const State& a, const State& b) const;
  bool movePlanes(State& state);
  bool cutAnew(State& state);

  const PlanarOptions& options_;
  const base::RunContext& ctx_;
  HeadReach head_;
  std::vector<Eigen::Vector3d> normals_;
  std::vector<NodePtr> start_;
  std::vector<Eigen::Vector3d> carrier_; // points on the carrier of the plate
  // Samples of the plate; null: made for the piece on it.
  std::shared_ptr<const PointBlocks> plate_;
  double before_ = 0.0, minimum_ = 0.0;
  Footing footing_;
  int ids_ = 0;
  std::int32_t tags_ = 0;
  std::map<std::pair<int, int>, bool> ways_; // cached results of isBlocking; second -1: the carrier
  std::map<std::pair<int, int>, std::shared_ptr<Cutting>> clearings_; // tried clearings: of, what
  std::set<std::pair<int, int>> moved_, anew_; // pairs of pieces tried before, lower and upper
};

} // namespace voluta::planar
