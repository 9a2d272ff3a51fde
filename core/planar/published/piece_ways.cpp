#include "planar/published/piece_ways.h"

#include "planar/piece_order.h"
#include "planar/plate_contact.h"

namespace voluta::planar {

PieceWays::PieceWays(const PlanarOptions& options, double spacingMm)
    : options_(options), spacingMm_(spacingMm), head_(options.head) {}

std::size_t PieceWays::add(const Piece& piece) {
  Known made{
      piece.baseTag, sectionsHeld(piece), piece.base.normal, firstTipMm(piece, options_.rule), {},
      nullptr};
  if (!head_.empty()) {
    std::vector<Eigen::Vector3d> body = surfaceSamples(piece.solid.mesh, spacingMm_);
    made.tips = tipsOf(body);
    made.obstacles =
        std::make_unique<PointBlocks>(withPlate(std::move(body), piece, options_, spacingMm_));
  }
  known_.emplace(added_, std::move(made));
  return added_++;
}

bool PieceWays::isBlocking(std::size_t of, std::size_t what) {
  const auto [at, isNew] = ways_.try_emplace({of, what}, false);
  if (isNew)
    at->second = head_.blocked(known_.at(of).tips, known_.at(what).obstacles->blocks(),
                               known_.at(of).direction, known_.at(of).firstTipMm);
  return at->second;
}

std::size_t PieceWays::blocked(const std::vector<std::size_t>& pieces) {
  if (head_.empty())
    return 0;
  std::vector<std::int32_t> standsOnTag;
  std::vector<std::vector<std::int32_t>> holds;
  for (const std::size_t p : pieces) {
    standsOnTag.push_back(known_.at(p).baseTag);
    holds.push_back(known_.at(p).holds);
  }
  return orderOf(standsOnTag, holds,
                 [&](std::size_t i, std::size_t j) { return isBlocking(pieces[i], pieces[j]); })
      .blocked;
}

} // namespace voluta::planar
