// The places where the replay's figures are worst.
#pragma once

#include <Eigen/Core>
#include <optional>

namespace voluta::replay {

// Positions in the work frame [mm]. Empty if the figure has its best value or was not measured.
struct WorstPlaces {
  std::optional<Eigen::Vector3d> gap;                // most material missing
  std::optional<Eigen::Vector3d> thin;               // most open volume narrower than a bead
  std::optional<Eigen::Vector3d> overfill;           // most material without room
  std::optional<Eigen::Vector3d> unsupported;        // start of the longest unsupported run
  std::optional<Eigen::Vector3d> halfCarried;        // start of the longest half-carried run
  std::optional<Eigen::Vector3d> longestUnsupported; // start of longestUnsupportedMm
  std::optional<Eigen::Vector3d> deviation;          // farthest from the planned path
  std::optional<Eigen::Vector3d> flowError;          // largest section error
  std::optional<Eigen::Vector3d> layerTime;          // covered after the shortest time
};

} // namespace voluta::replay
