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
#include "robot/cell.h"

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <vector>

namespace voluta::scene {

struct PartDrawing;
struct PlatformDrawing;
struct VoxelDrawing;
struct LayersDrawing;
struct PathsDrawing;
struct CellDrawing;

// The part as a solid: shaded smoothly up to a feature angle of 45 degrees, edges sharper than
// that and open boundaries as lines.
std::shared_ptr<const PartDrawing> drawPart(const geometry::TriangleMesh& part);

// The polygon material starts on (convex, counter-clockwise) as a thin plate with its outline, on
// a ground grid of 10 mm that reaches `groundRadiusMm` from the origin (0: no grid).
std::shared_ptr<const PlatformDrawing> drawPlatform(const std::vector<Eigen::Vector2d>& polygon,
                                                    double groundRadiusMm);

// Solid voxels by the layer they belong to: the faces that are visible for any range of layers.
// With `layerHeightMm` > 0 and a field, layers are those that are cut from the field; else rank 1
// is layer 0. Missed voxels stand out: they shine through what is before them.
std::shared_ptr<const VoxelDrawing> drawVoxels(const curved::Decomposition& decomposition,
                                               double layerHeightMm = 0.0);
int layerCount(const VoxelDrawing& drawing);

// Patches as slabs of their thickness: bands along their boundaries, and their upper and lower
// sides.
std::shared_ptr<const LayersDrawing> drawLayers(const layers::LayerStack& stack);
int layerCount(const LayersDrawing& drawing);

// Beads with their width and height, travel moves between them. `trajectory` gives the times for
// ColourBy::Time; without it that colouring falls back on the layer.
std::shared_ptr<const PathsDrawing> drawPaths(const plan::ToolPlan& plan,
                                              const plan::Trajectory* trajectory = nullptr);
int layerCount(const PathsDrawing& drawing);
// Waypoints of one layer in print order, as ViewState::moves counts them; empty for a layer that
// is not there.
const std::vector<std::uint32_t>& waypointsOfLayer(const PathsDrawing& drawing, int layer);

// Robot, holders, head, platform and obstacles as solids.
std::shared_ptr<const CellDrawing> drawCell(const robot::Cell& cell);

} // namespace voluta::scene
