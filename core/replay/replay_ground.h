// What is not printed: the plate, rod or body of a job, and bodies that are put into the part. They
// carry beads, and head and arm must keep clear of them. Work frame, mm.
#pragma once

#include "geometry/mesh_query.h"
#include "platform/platform_solid.h"
#include "replay/printed_part.h"
#include "robot/cell.h"

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::replay {

struct PlacedShape {
  Eigen::Isometry3d work_T_shape;
  robot::Shape shape;
};

// A body that is put into the part before a piece is printed.
struct InsertedBody {
  std::shared_ptr<const geometry::TriangleMesh> body; // closed; never null
  std::uint32_t firstPiece = 0;
};

// A body as grid cells: those that are mostly inside it.
class GroundCells {
public:
  // Throws Cancelled.
  GroundCells(const geometry::TriangleMesh& mesh, double pitchMm, const base::RunContext& ctx);
  GroundCells(const GroundCells&) = delete;
  GroundCells& operator=(const GroundCells&) = delete;
  const PrintedPart& part() const { return *part_; }
  // Returns a moment after which the whole body exists.
  static PrintState always() { return {.before = 1}; }

private:
  BeadGrid cells_;
  std::vector<BeadPiece> piece_;
  std::optional<PrintedPart> part_; // of the two members above
};

// Checks for ground below a bead. Platform and bodies must outlive it.
class GroundProbe {
public:
  explicit GroundProbe(const platform::PlatformSolid& platform,
                       std::span<const InsertedBody> inserted = {});

  // Returns whether the point is in or on the plate, rod or body, or in a body that is there when
  // the piece `before` is printed. A plate extends infinitely downwards; points up to `slackMm`
  // beyond the edge of a plate or the end of a rod count as on it.
  bool holds(const Eigen::Vector3d& point, double slackMm, std::uint32_t before = 0) const;

private:
  bool onPlate(const Eigen::Vector3d& point, double slackMm) const;
  bool inRod(const Eigen::Vector3d& point, double slackMm) const;

  const platform::PlatformSolid& platform_;
  std::optional<geometry::MeshQuery> body_;
  struct Inserted {
    geometry::MeshQuery body;
    Eigen::AlignedBox3d box;
    std::uint32_t firstPiece;
  };
  std::vector<Inserted> inserted_;
};

// Solids that head and arm may collide with.
class GroundSolids {
public:
  // The plate includes the cell's body that carries it. `pitchMm`: width of a body's cells,
  // increased for large bodies. Throws Cancelled.
  GroundSolids(const platform::PlatformSolid& platform, const robot::Cell& cell, double pitchMm,
               const base::RunContext& ctx, std::span<const InsertedBody> inserted = {});

  // Returns plate or rod as convex solids; a tapering prism is replaced by the cone inside it.
  const std::vector<PlacedShape>& solids() const { return solids_; }
  // outward(): a unit vector out of plate or rod for a nozzle with axis `direction`. reachMm(): the
  // maximum coordinate of solids() along it; a head entirely beyond it touches none of them.
  Eigen::Vector3d outward(const Eigen::Vector3d& direction) const;
  double reachMm() const { return reachMm_; }

  struct Body {
    std::unique_ptr<const GroundCells> cells;
    std::uint32_t firstPiece = 0; // exists from this piece on
    bool isPlatform = false;
  };
  const std::vector<Body>& bodies() const { return bodies_; }

private:
  std::vector<PlacedShape> solids_;
  bool rod_ = false;
  double reachMm_ = -1e9;
  std::vector<Body> bodies_;
};

} // namespace voluta::replay
