// Checks that the head reaches pieces past each other, for many partial results of the same pieces.
#pragma once

#include "planar/head_reach.h"
#include "planar/planar_decomposition.h"
#include "planar/point_blocks.h"

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace voluta::planar {

class PieceWays {
public:
  // `spacingMm`: of the points that represent a piece. Precondition: `options` outlives this.
  PieceWays(const PlanarOptions& options, double spacingMm);

  // Adds a piece and returns its number.
  std::size_t add(const Piece& piece);
  // Numbers are not used again.
  void remove(std::size_t number) { known_.erase(number); }

  // Returns how many of the pieces with these numbers, in their best order, come after a piece that
  // blocks the head (see orderOf). 0 if there is no head.
  std::size_t blocked(const std::vector<std::size_t>& pieces);

private:
  struct Known {
    std::int32_t baseTag = 0;
    std::vector<std::int32_t> holds;
    Eigen::Vector3d direction;
    double firstTipMm = 0.0;
    std::vector<Eigen::Vector3d> tips;
    std::unique_ptr<PointBlocks> obstacles; // with the plate and the bodies that carry it
  };
  bool isBlocking(std::size_t of, std::size_t what);

  const PlanarOptions& options_;
  double spacingMm_;
  HeadReach head_;
  std::map<std::size_t, Known> known_;
  std::size_t added_ = 0;
  std::map<std::pair<std::size_t, std::size_t>, bool> ways_; // of, what: cached results
};

} // namespace voluta::planar
