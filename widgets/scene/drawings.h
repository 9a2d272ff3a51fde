// What can be drawn, prepared once and then shown by a Scene. The functions take core data and may
// run on any thread (they take from milliseconds to a second or two); what they return is
// immutable, may be shared by several scenes and is swapped in in less than a millisecond.
// All but the cell is in the work frame, mm.
#pragma once

#include "curved/decomposition.h"
#include "geometry/triangle_mesh.h"
#include "layers/layer_stack.h"
#include "plan/tool_plan.h"
#include "plan/trajectory.h"
#include "planar/pieces.h"
#include "platform/platform_solid.h"
#include "robot/cell.h"
#include "scene/colouring.h"

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <vector>

namespace voluta::robot {
struct ArmLook;
}

namespace voluta::scene {

struct PartDrawing;
struct PlatformDrawing;
struct VoxelDrawing;
struct LayersDrawing;
struct PathsDrawing;
struct PiecesDrawing;
struct CellDrawing;
struct FrontDrawing;
struct ReachDrawing;

// The part as a solid: shaded smoothly up to a feature angle of 45 degrees, edges sharper than
// that and open boundaries as lines.
std::shared_ptr<const PartDrawing> drawPart(const geometry::TriangleMesh& part);

// What material starts on. A plate is thin, with its outline, on a ground grid of 10 mm that
// reaches `groundRadiusMm` from the origin (0: no grid); around a rod there is no ground. A rod has
// a line along it at angle 0, by which it is seen to turn. Precondition: checkRod.
std::shared_ptr<const PlatformDrawing> drawPlatform(const platform::PlatformSolid& platform,
                                                    double groundRadiusMm);

struct VoxelLook {
  // > 0 and there is a field: layers are those that are cut from the field; else rank 1 is layer 0.
  double layerHeightMm = 0.0;
  bool bySteps = false; // what is shown is chosen by growth step (rank 1 is layer 0), for replaying
  ColourBy colourBy = ColourBy::Layer; // Layer, GrowthStep or Peeling; others count as Layer
  // For Peeling: curved::peelingField, an entry a cell. Null: as Layer.
  std::shared_ptr<const std::vector<std::int32_t>> peeling = nullptr;
};

// Solid voxels: the faces that are visible for any range of layers. Support has a colour of its
// own. Missed voxels stand out, by the reason they are missed for: they shine through what is
// before them.
std::shared_ptr<const VoxelDrawing> drawVoxels(const curved::Decomposition& decomposition,
                                               const VoxelLook& look = {});
// Layers, or growth steps where look.bySteps.
int layerCount(const VoxelDrawing& drawing);
std::size_t missedCount(const VoxelDrawing& drawing);

// The convex front as glass; curved::frontSurface gives it.
std::shared_ptr<const FrontDrawing> drawFront(const geometry::TriangleMesh& front);

// Heights of a layer, mm: nominal, and the limits of what the process lays.
struct HeightLimits {
  double nominalMm = 0.0, minMm = 0.0, maxMm = 0.0;
  bool known() const { return minMm < nominalMm && nominalMm < maxMm; }
  // Place on divergingColour's map: 0 at the lower limit, 1/2 at the nominal height, 1 at the upper
  // limit; beyond the limits less than 0 or more than 1.
  double shareOf(double heightMm) const {
    return heightMm < nominalMm ? 0.5 * (heightMm - minMm) / (nominalMm - minMm)
                                : 0.5 + 0.5 * (heightMm - nominalMm) / (maxMm - nominalMm);
  }
};

// Patches as slabs of their thickness: bands along their boundaries, and their upper and lower
// sides. `heights` are for ColourBy::Spacing, which falls back on the layer where not known.
std::shared_ptr<const LayersDrawing> drawLayers(const layers::LayerStack& stack,
                                                const HeightLimits& heights = {});
int layerCount(const LayersDrawing& drawing);

// Beads with their width and height, travel moves between them. `trajectory` gives the times for
// ColourBy::Time; without it that colouring falls back on the layer.
std::shared_ptr<const PathsDrawing> drawPaths(const plan::ToolPlan& plan,
                                              const plan::Trajectory* trajectory = nullptr);
int layerCount(const PathsDrawing& drawing);
// Waypoints of one layer in print order, as ViewState::moves counts them; empty for a layer that
// is not there.
const std::vector<std::uint32_t>& waypointsOfLayer(const PathsDrawing& drawing, int layer);

// Pieces of planar mode in print order: a colour each, the faces that need support, base planes.
std::shared_ptr<const PiecesDrawing> drawPieces(const std::vector<planar::Piece>& pieces,
                                                const planar::RiskRule& rule);
int pieceCount(const PiecesDrawing& drawing);
// Axes of a base plane, unit vectors in columns: level across, upwards along, and its normal.
Eigen::Matrix3d baseAxes(const Eigen::Vector3d& normal);
// Where each piece goes when each is moved that far off the one it stands on, along its direction.
std::vector<Eigen::Vector3d> pieceOffsets(const PiecesDrawing& drawing, double explodeMm);
// And its base plane, which stays on the piece that is cut.
Eigen::Vector3d basePlaneOffset(const PiecesDrawing& drawing, std::size_t piece, double explodeMm);

// How much of what was asked for is reached over a point of the plate: share in [0, 1].
struct ReachPoint {
  Eigen::Vector2d at;
  double share;
};
// A map on the plate: squares of `spacingMm` about points of a lattice, cut off at its edge.
// `plate`: convex, counter-clockwise.
std::shared_ptr<const ReachDrawing> drawReach(const std::vector<ReachPoint>& points,
                                              double spacingMm,
                                              const std::vector<Eigen::Vector2d>& plate);

// The arm as it looks, head, holder, platform and obstacles, and the solids that are checked for
// collisions (ViewState::collisionSolids).
std::shared_ptr<const CellDrawing> drawCell(const robot::Cell& cell, const robot::ArmLook& look);
// The same of a cell with the same arm, whose links are taken from what was drawn before.
std::shared_ptr<const CellDrawing> drawCell(const robot::Cell& cell, const CellDrawing& before);

} // namespace voluta::scene
