// Internal data of CutSearch: pieces, cuts and partial results.
#pragma once

#include "planar/search/cut_search.h"

#include <Eigen/Geometry>
#include <memory>

namespace voluta::planar {

struct CutSearch::Node {
  Piece piece;
  double risky = 0.0, base = 0.0, volume = 0.0, footCost = 0.0;
  int id = -1;
  std::vector<std::int32_t> holds; // tags of sections that other pieces are based on
  std::vector<Eigen::Vector3d> tips, body;
  // Samples of the plate for a piece on the plate; large and mostly shared.
  std::shared_ptr<const PointBlocks> plate;
  Eigen::AlignedBox3d box;            // of body and plate
  double lowestTip = 0.0;             // along its base's normal
  std::vector<Eigen::Vector3d> under; // points of the body with z <= 0
  Obstacles obstacles() const {
    Obstacles all{body};
    if (plate)
      all.insert(all.end(), plate->blocks().begin(), plate->blocks().end());
    return all;
  }
  bool searched = false;
  FaceTable faces;
  std::vector<CutCandidate> candidates;
  std::vector<std::shared_ptr<const Cutting>> cuttings; // of the candidates tried
  std::vector<bool> tried;
};

struct CutSearch::Cutting {
  CutStep step;
  NodePtr below;
  std::vector<NodePtr> above;
};

struct CutSearch::State {
  std::vector<NodePtr> nodes;
  std::vector<std::shared_ptr<const Cutting>> cuts;
  double risky = 0.0, cost = 0.0;
  std::size_t blocked = 0;
};

} // namespace voluta::planar
