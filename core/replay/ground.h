// What the first beads are laid on, and what head and arm must keep clear of: the plate, rod or
// body of a job. Work frame, mm.
#pragma once

#include "geometry/mesh_query.h"
#include "platform/platform_solid.h"
#include "replay/printed_part.h"
#include "robot/cell.h"

#include <Eigen/Geometry>
#include <memory>
#include <optional>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::replay {

struct PlacedShape {
  Eigen::Isometry3d work_T_shape;
  robot::Shape shape;
};

// A body as the cells of a grid whose greater part is in it.
class GroundCells {
public:
  // Throws Cancelled.
  GroundCells(const geometry::TriangleMesh& mesh, double pitchMm, const base::RunContext& ctx);
  const PrintedPart& part() const { return *part_; }
  // The moment from which on all of it is there.
  static PrintState always() { return {.before = 1}; }

private:
  BeadGrid cells_;
  std::vector<BeadPiece> piece_;
  std::optional<PrintedPart> part_; // of the two above
};

// What lies beneath a first bead. The platform outlives it.
class GroundProbe {
public:
  explicit GroundProbe(const platform::PlatformSolid& platform);

  // Is the point in the plate, rod or body or on it? A plate goes down without end; over the edge
  // of a plate or the end of a rod `slackMm` count as on it.
  bool holds(const Eigen::Vector3d& point, double slackMm) const;

private:
  bool onPlate(const Eigen::Vector3d& point, double slackMm) const;
  bool inRod(const Eigen::Vector3d& point, double slackMm) const;

  const platform::PlatformSolid& platform_;
  std::optional<geometry::MeshQuery> body_;
};

// What head and arm may run into.
class GroundSolids {
public:
  // The plate is the cell's own body, with what carries it. `pitchMm`: of a body's cells, more
  // where it is large. Throws Cancelled.
  GroundSolids(const platform::PlatformSolid& platform, const robot::Cell& cell, double pitchMm,
               const base::RunContext& ctx);

  // Plate or rod as convex solids. Of a prism that tapers, the cone within it.
  const std::vector<PlacedShape>& solids() const { return solids_; }
  // A unit vector out of plate or rod for a nozzle whose axis is `direction`, and the greatest
  // coordinate of solids() along it: a head wholly beyond touches none of them.
  Eigen::Vector3d outward(const Eigen::Vector3d& direction) const;
  double reachMm() const { return reachMm_; }

  // nullptr: no body.
  const GroundCells* cells() const { return cells_.get(); }

private:
  std::vector<PlacedShape> solids_;
  bool rod_ = false;
  double reachMm_ = -1e9;
  std::unique_ptr<const GroundCells> cells_;
};

} // namespace voluta::replay
