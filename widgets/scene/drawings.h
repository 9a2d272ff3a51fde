// Drawings: prepared once and then shown by a Scene. The functions take core data and may run on
// any thread (they take from milliseconds to a second or two). The results are immutable, may be
// shared by several scenes and are swapped in in less than a millisecond. All drawings except the
// cell are in the work frame [mm].
#pragma once

#include "scene/colouring.h"

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <vector>

namespace voluta::curved {
struct Decomposition;
}
namespace voluta::geometry {
struct TriangleMesh;
}
namespace voluta::layers {
struct LayerStack;
}
namespace voluta::plan {
struct ToolPlan;
struct Trajectory;
} // namespace voluta::plan
namespace voluta::planar {
struct Piece;
struct RiskRule;
} // namespace voluta::planar
namespace voluta::platform {
struct PlatformSolid;
}
namespace voluta::robot {
struct ArmLook;
class Cell;
} // namespace voluta::robot

namespace voluta::scene {

struct PartDrawing;
struct PlatformDrawing;
struct VoxelDrawing;
struct LayersDrawing;
struct PathsDrawing;
struct PiecesDrawing;
struct RegionsDrawing;
struct CellDrawing;
struct FrontDrawing;
struct ReachDrawing;

// Draws the part as a solid: smooth shading up to a feature angle of 45 degrees, sharper edges and
// open boundaries as lines.
std::shared_ptr<const PartDrawing> drawPart(const geometry::TriangleMesh& part);

// Draws the platform. A plate is thin, with its outline, on a ground grid of 10 mm that extends
// `groundRadiusMm` from the origin (0: no grid); around a rod there is no ground. A rod has a line
// along it at angle 0, which makes its rotation visible. Precondition: checkRod.
std::shared_ptr<const PlatformDrawing> drawPlatform(const platform::PlatformSolid& platform,
                                                    double groundRadiusMm);

struct VoxelLook {
  // If > 0 and there is a field, layers are those cut from the field; otherwise rank 1 is layer 0.
  double layerHeightMm = 0.0;
  // the growth step selects the visible voxels (rank 1 is layer 0), for replaying
  bool bySteps = false;
  ColourBy colourBy = ColourBy::Layer; // Layer, GrowthStep or Peeling; others count as Layer
  // For Peeling: curved::peelingField, one entry per cell. Null: as Layer.
  std::shared_ptr<const std::vector<std::int32_t>> peeling = nullptr;
};

// Draws solid voxels: the faces that are visible for any range of layers. Support has a separate
// colour. Missed voxels are highlighted by their reason, and visible through objects in front of
// them.
std::shared_ptr<const VoxelDrawing> drawVoxels(const curved::Decomposition& decomposition,
                                               const VoxelLook& look = {});
// Returns the number of layers, or of growth steps if look.bySteps.
int layerCount(const VoxelDrawing& drawing);
std::size_t missedCount(const VoxelDrawing& drawing);

// Draws the convex front as glass; its surface comes from curved::frontSurface.
std::shared_ptr<const FrontDrawing> drawFront(const geometry::TriangleMesh& front);

// Heights of a layer [mm]: nominal, and the process's limits.
struct HeightLimits {
  double nominalMm = 0.0, minMm = 0.0, maxMm = 0.0;
  bool known() const { return minMm < nominalMm && nominalMm < maxMm; }
  // Returns the position on divergingColour's map: 0 at the lower limit, 1/2 at the nominal height,
  // 1 at the upper limit; less than 0 or more than 1 beyond the limits.
  double shareOf(double heightMm) const {
    return heightMm < nominalMm ? 0.5 * (heightMm - minMm) / (nominalMm - minMm)
                                : 0.5 + 0.5 * (heightMm - nominalMm) / (maxMm - nominalMm);
  }
};

// Draws patches as slabs of their thickness: bands along their boundaries, and their upper and
// lower sides. `heights` are for ColourBy::Spacing, which falls back to the layer if they are
// unknown.
std::shared_ptr<const LayersDrawing> drawLayers(const layers::LayerStack& stack,
                                                const HeightLimits& heights = {});
int layerCount(const LayersDrawing& drawing);

// Draws beads with their width and height, and the travel moves between them. `trajectory` gives
// the times for ColourBy::Time, which falls back to the layer without it. `layerTimeS`: per
// waypoint for ColourBy::LayerTime, negative where there is no bead below; empty: not known.
std::shared_ptr<const PathsDrawing> drawPaths(const plan::ToolPlan& plan,
                                              const plan::Trajectory* trajectory = nullptr,
                                              std::vector<float> layerTimeS = {});
int layerCount(const PathsDrawing& drawing);
// Returns the waypoints of one layer in print order, as counted by ViewState::moves; empty for an
// unknown layer.
const std::vector<std::uint32_t>& waypointsOfLayer(const PathsDrawing& drawing, int layer);

// Draws pieces of planar mode in print order: one colour each, the faces that need support, base
// planes.
std::shared_ptr<const PiecesDrawing> drawPieces(const std::vector<planar::Piece>& pieces,
                                                const planar::RiskRule& rule);
int pieceCount(const PiecesDrawing& drawing);
// Returns the axes of a base plane, unit vectors in columns: horizontal, upwards within the plane,
// and its normal.
Eigen::Matrix3d baseAxes(const Eigen::Vector3d& normal);
// Returns the displacement of each piece when each is moved by that distance from its supporting
// piece, along its direction.
std::vector<Eigen::Vector3d> pieceOffsets(const PiecesDrawing& drawing, double explodeMm);
// Returns that of its base plane, which stays on the piece that is cut.
Eigen::Vector3d basePlaneOffset(const PiecesDrawing& drawing, std::size_t piece, double explodeMm);

// Use of a region, from which its colour follows.
enum class RegionLook { Settings, Layers, Cut, Load };
inline constexpr std::size_t kRegionLooks = 4;
struct RegionBody {
  std::shared_ptr<const geometry::TriangleMesh> body; // null: not shown
  RegionLook look = RegionLook::Settings;
};
// Draws the bodies of a part's regions as glass, with their edges.
std::shared_ptr<const RegionsDrawing> drawRegions(const std::vector<RegionBody>& bodies);
// Returns the drawing with another body of one region.
std::shared_ptr<const RegionsDrawing> withRegion(const RegionsDrawing& drawing, std::size_t region,
                                                 const RegionBody& body);
Colour colourOf(RegionLook look, const Theme& theme);

// Reached share of the poses over a point of the plate, in [0, 1].
struct ReachPoint {
  Eigen::Vector2d at;
  double share;
};
// Draws a map on the plate: squares of `spacingMm` about points of a lattice, cut off at its edge.
// Precondition: `plate` is convex and counter-clockwise.
std::shared_ptr<const ReachDrawing> drawReach(const std::vector<ReachPoint>& points,
                                              double spacingMm,
                                              const std::vector<Eigen::Vector2d>& plate);

// Draws the arm with its visual shape, head, holder, platform and obstacles, and the collision
// solids (ViewState::collisionSolids).
std::shared_ptr<const CellDrawing> drawCell(const robot::Cell& cell, const robot::ArmLook& look);
// The same for a cell with the same arm, whose links are reused from the previous drawing.
std::shared_ptr<const CellDrawing> drawCell(const robot::Cell& cell, const CellDrawing& before);

} // namespace voluta::scene
