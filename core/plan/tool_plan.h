// The planned beads, independent of any robot: flat arrays for a million waypoints and more.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace voluta::geometry {
struct TriangleMesh;
}

namespace voluta::plan {

// Project files store these numbers: add new kinds at the end.
enum class PathKind : std::uint8_t {
  Wall,
  Infill, // Solid
  GapFill,
  Skirt,
  Support,
  Prime,
  SparseInfill,
  Bridge, // Solid infill over gaps or sparse infill
  Tape,   // Continuous fibre, ironed onto a layer
  Shot    // Fills a pocket of the part from one place (ToolPlan::shotMm3)
};
inline constexpr std::size_t kPathKinds = 10;

// Returns whether the bead is discarded and not part of the printed object, so that it needs no
// support.
constexpr bool isWaste(PathKind kind) {
  return kind == PathKind::Skirt || kind == PathKind::Prime;
}

// Returns whether the bead may span gaps of sparse infill inside the part.
constexpr bool spansInterior(PathKind kind) {
  return kind == PathKind::SparseInfill || kind == PathKind::Bridge;
}

// One bead printed without lifting: waypoints [first, first + count), count >= 2. A closed path
// repeats its first waypoint at its end.
struct ToolPath {
  std::size_t first = 0, count = 0;
  PathKind kind = PathKind::Wall;
  int layer = 0, patch = 0, group = 0;
  bool closed = false;
  int item = 0; // index in the job's items
  int tool = 0; // index in the job's tooling (process/tooling.h)
  int ring = 0; // Walls: 0 is the outermost
};

// How much of an item's volume is meant to be material.
struct FillIntent {
  // The part is solid up to this distance from its surface [mm]; infinite: everywhere.
  double shellMm = std::numeric_limits<double>::infinity();
  double openMm3 = 0.0; // Volume inside the part that sparse infill leaves open

  bool isSolid() const { return std::isinf(shellMm); }
};

// A body that the operator puts into the part before the first path of its item in this layer or a
// later one.
struct Insert {
  std::string name;                                   // as the operator reads it
  int item = 0, layer = 0;                            // as those of the paths
  std::shared_ptr<const geometry::TriangleMesh> body; // closed; work frame [mm]; never null
};

// All in the work frame [mm]: origin at the centre of the platform's top, z up from it.
struct ToolPlan {
  std::vector<Eigen::Vector3d> position;  // The nozzle's tip: top of the bead
  std::vector<Eigen::Vector3d> direction; // Unit vector, from the bead into the nozzle
  std::vector<float> widthMm, heightMm;   // The bead's cross-section there (process/bead_model.h)
  std::vector<float> speedMmPerS;         // Desired speed on the segment that ends here
  std::vector<ToolPath> paths;  // In print order; together they cover every waypoint exactly once
  std::vector<FillIntent> fill; // Per item; empty: all items are solid
  std::vector<Insert> inserts;

  // Precondition: the item is one of the job's.
  FillIntent fillOf(std::size_t item) const {
    return item < fill.size() ? fill[item] : FillIntent{};
  }
  bool isSolid() const;

  std::size_t waypointCount() const { return position.size(); }
  // Returns the volume of a shot [mm3]: the nozzle moves down to shotAt(), where the material flows
  // out at rest, and back up. It equals that of a cylinder with the waypoint's width as diameter
  // and its height. Precondition: path.kind is Shot.
  double shotMm3(const ToolPath& path) const;
  // Returns the waypoint from which a shot flows: the lowest one along its direction.
  std::size_t shotAt(const ToolPath& path) const;

  // Returns the first waypoint after a body is put in; waypointCount() if nothing is printed then.
  std::size_t firstAfter(const Insert& insert) const;

  // Returns whether a waste bead primes the nozzle before the part begins.
  bool primes() const { return !paths.empty() && isWaste(paths.front().kind); }
  // Returns whether the priming bead is printed in the air above the plate. Nothing supports it
  // there, so it falls and does not count as printed material.
  bool isPrimeInAir() const;
};

} // namespace voluta::plan
