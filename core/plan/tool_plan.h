// Beads to lay, independent of any robot: flat arrays, a million waypoints and more.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace voluta::plan {

// Projects keep their numbers: add new kinds at the end.
enum class PathKind : std::uint8_t { Wall, Infill, GapFill, Skirt, Support, Prime };
inline constexpr std::size_t kPathKinds = 6;

// Is it thrown away, and no part of what is printed? Nothing has to hold it.
constexpr bool isWaste(PathKind kind) {
  return kind == PathKind::Skirt || kind == PathKind::Prime;
}

// One bead laid without lifting: waypoints [first, first + count), count >= 2.
// A closed path repeats its first waypoint at its end.
struct ToolPath {
  std::size_t first = 0, count = 0;
  PathKind kind = PathKind::Wall;
  int layer = 0, patch = 0, group = 0;
  bool closed = false;
  int item = 0; // index in the job's items
  int tool = 0; // index in the job's tooling (process/tooling.h)
};

// All in the work frame: origin at the centre of the platform's top, z out of it. mm.
struct ToolPlan {
  std::vector<Eigen::Vector3d> position;  // the nozzle's tip: top of the bead
  std::vector<Eigen::Vector3d> direction; // unit, from the bead into the nozzle
  std::vector<float> widthMm, heightMm;   // the bead's section there (process/bead_model.h)
  std::vector<float> speedMmPerS;         // wanted on the segment that arrives here
  std::vector<ToolPath> paths;            // in print order; together they cover all waypoints once

  std::size_t waypointCount() const { return position.size(); }
  // Does a bead that is waste fill the nozzle before the part begins?
  bool primes() const { return !paths.empty() && isWaste(paths.front().kind); }
  // Is that bead laid in the air over the plate? Nothing is there yet that could hold it: it falls,
  // and is no part of what grows.
  bool isPrimeInAir() const {
    constexpr double kOnMm = 0.01;
    return primes() && position[paths.front().first].z() >
                           static_cast<double>(heightMm[paths.front().first]) + kOnMm;
  }
};

} // namespace voluta::plan
