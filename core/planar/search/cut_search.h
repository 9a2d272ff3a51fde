// Several partial results side by side, each a set of pieces, cut further where it pays most.
#pragma once

#include "base/run_context.h"
#include "planar/decomposition.h"
#include "planar/head_reach.h"
#include "planar/piece_cut.h"
#include "planar/plate.h"
#include "planar/print_order.h"
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

// A cut of the search: which piece, and which pieces came of it, by numbers of the search's own.
struct CutStep {
  int piece = 0;
  Plane plane;
  Eigen::Vector3d topMm = Eigen::Vector3d::Zero(); // of what is cut off, on its surface
  int below = 0;
  std::vector<int> above;
  std::vector<Eigen::Vector3d> sectionMiddles; // of each above
  bool clears = false; // gains nothing itself: what is cut off is printed after what it would hide
};

struct SearchResult {
  std::vector<Piece> pieces;
  std::vector<CutStep> steps;
  double riskyMm2 = 0.0;
};

class CutSearch {
public:
  // Starts from `pieces`, numbered 0 and up. `riskyBeforeMm2` and `footing` are the whole
  // part's: what shares of it are counted by, and what of it must stay on the plate. The head is
  // taken headMarginMm wider.
  CutSearch(std::vector<Piece> pieces, const PlanarOptions& options, double riskyBeforeMm2,
            const Footing& footing, double headMarginMm, const base::RunContext& ctx);
  ~CutSearch();

  // The best results found, best first: those that reach the target with the fewest pieces, else
  // those with the least risky area. At least one (the start, where no cut helps). Throws
  // Cancelled.
  std::vector<SearchResult> run();

  // The pieces bettered as they are: planes between two pieces are moved now that the directions on
  // both sides are known, and pieces are joined with their neighbours and cut anew, the worst
  // first, as long as that helps and the target is not reached. Throws Cancelled.
  SearchResult bettered();

private:
  struct Node;
  struct Cutting;
  struct State;
  using NodePtr = std::shared_ptr<Node>;
  struct Option { // to cut a piece of a partial result
    const State* state = nullptr;
    NodePtr node;
    std::size_t candidate = 0;
    double estimate = 0.0;
  };

  std::shared_ptr<const PointBlocks> samplesOfPlate(const Piece& piece) const;
  NodePtr node(Piece piece);
  double maxContactLoss(const Node& node) const;
  double footPrice(const Node& node) const; // risky area that a mm2 of contact is worth
  bool keepsContact(const Node& node, const Plane& plane) const;
  bool wayIsFree(const Node& node, const CutCandidate& candidate) const;
  void findCandidates(Node& node);
  // Of pieces numbered firstId and up.
  std::vector<Option> optionsOf(const std::vector<State>& beam, int firstId);
  void tryCuts(const std::vector<Option>& options, std::size_t begin, std::size_t end);
  State after(const Option& option);
  static void replace(State& state, const NodePtr& cut, std::shared_ptr<const Cutting> cutting);
  bool inTheWay(const Node& of, const Node& what) const;
  bool carrierInTheWay(const Node& of) const;
  void askHead(const std::vector<State>& states);
  PieceOrder orderKnown(const State& state) const;
  // Where pieces are in others' way: these are cut too, so that the head reaches all but so many.
  bool clearWays(State& state, std::size_t mostBlocked);
  // A cut of `what` that leaves nothing of it in the way of `of`; none: nullptr.
  std::shared_ptr<Cutting> clearing(const Node& of, Node& what);
  static PieceOrder orderIn(const State& state,
                            const std::function<bool(const Node& of, const Node& what)>& blocked);
  std::vector<State> kept(std::vector<State> states, std::size_t most) const;
  bool better(const State& a, const State& b) const;
  void weigh(State& state);
  void weighHead(std::vector<State>& states);
  void weighHead(State& state);
  // Both; where pieces are hidden from the head, so many fewer as can be cleared.
  void weighStart(State& state);
  // Beam search of that width over the pieces numbered firstId and up; so many cuts are tried at a
  // level.
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
  std::vector<Eigen::Vector3d> carrier_; // points of what carries the plate
  // Of the plate; null: it is made for the piece that stands on it.
  std::shared_ptr<const PointBlocks> plate_;
  double before_ = 0.0, least_ = 0.0;
  Footing footing_;
  int ids_ = 0;
  std::int32_t tags_ = 0;
  std::map<std::pair<int, int>, bool> ways_; // known answers of inTheWay; second -1: of the carrier
  std::map<std::pair<int, int>, std::shared_ptr<Cutting>> clearings_; // tried: of, what
  std::set<std::pair<int, int>> moved_, anew_; // pairs of pieces tried before, lower and upper
};

} // namespace voluta::planar
