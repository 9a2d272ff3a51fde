// Contents of the drawings. Private to the module.
#pragma once

#include "geometry/triangle_mesh.h"
#include "robot/cell.h"
#include "scene/colouring.h"
#include "scene/drawings.h"
#include "scene/layered_faces.h"
#include "voxel/voxel_grid.h"

#include <array>
#include <cstdint>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace voluta::scene {

// The part is on z = 0; the top of a plate is drawn slightly below, so that it does not flicker
// through the part's underside.
inline constexpr double kPlateTopMm = -0.05;

struct PartDrawing {
  geometry::TriangleMesh mesh;
  vtkSmartPointer<vtkPolyData> surface, edges;
  Eigen::AlignedBox3d box;
};

struct PlatformDrawing {
  std::vector<Eigen::Vector2d> polygon;
  vtkSmartPointer<vtkPolyData> plate, outline, grid;
  vtkSmartPointer<vtkPolyData> ruling, axisX, axisY; // on the plate; empty around a rod
  std::shared_ptr<const PartDrawing> rod, body;      // null: none
  Eigen::AlignedBox3d box;                           // of the plate and the body
};

// Reasons why a voxel is missed, curved::Loss without None, in its order.
inline constexpr std::size_t kLossCount = 3;

struct VoxelDrawing {
  voxel::VoxelGrid grid;
  std::vector<std::int32_t> rank; // display order, from 1; -1 missed
  int layers = 0;
  bool bySteps = false;
  // Faces on the outside, and those between ranks, which are needed only while some layers are
  // hidden.
  vtkSmartPointer<vtkPolyData> outside, inside, missed;
  LayeredFaces outer, upper, lower;
  std::array<Stretch, kLossCount> missedFaces; // of `missed`, by reason
  std::array<std::size_t, kLossCount> lost{};  // voxels, by reason
  std::size_t support = 0;                     // voxels
  ColourBy colouredBy = ColourBy::Layer;
  int highest = 0; // last value of the scale, which begins at 1
  Eigen::AlignedBox3d box;
  // Faces of blocks for fast frames, without cells of its own; null: the voxels are few enough.
  std::shared_ptr<const VoxelDrawing> coarse;
};

struct FrontDrawing {
  vtkSmartPointer<vtkPolyData> surface, edges;
};

struct ReachDrawing {
  vtkSmartPointer<vtkPolyData> surface; // one colour per point
};
Legend reachLegend();

// Values of the colourings, one per item.
struct ColourValues {
  std::vector<std::int32_t> layer, group, kind, item, tool, region; // empty: no such colouring
  std::vector<float> height, width, speed, minutes, layerTimeS, tiltDeg;
  HeightLimits heights; // if known, height is offered as spacing too
};

struct Slabs {
  LayeredFaces bands, upper, lower;

  std::size_t size() const { return bands.size() + upper.size() + lower.size(); }
};

struct LayersDrawing {
  vtkSmartPointer<vtkPolyData> surface;
  Slabs slabs, coarse; // coarse: for fast frames; empty: `slabs` are few enough
  ColourValues values; // per point
  std::vector<std::uint32_t> patchOfTriangle;
  Eigen::AlignedBox3d box;
  int layers = 0;
};

// A stretch of beads that is hidden as a whole once all its surroundings are printed.
struct BeadChunk {
  std::size_t first = 0, count = 0; // segments, in drawn order
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Vector3d half = Eigen::Vector3d::Zero(); // of its bounding box
  int layer = 0, hidingLayer = 0;
  std::uint32_t hidingWaypoint = 0;
};

struct PieceShape {
  std::shared_ptr<const PartDrawing> solid;
  vtkSmartPointer<vtkPolyData> safe, risky;   // the solid's faces
  vtkSmartPointer<vtkPolyData> base, baseRim; // null: on the plate
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ();
  int parent = -1;
};

struct PiecesDrawing {
  std::vector<PieceShape> pieces;
  bool anyRisky = false;
  Eigen::AlignedBox3d box;
};

struct RegionsDrawing {
  struct One {
    vtkSmartPointer<vtkPolyData> surface, edges;
    RegionLook look = RegionLook::Settings;
  };
  std::vector<One> regions;
};

// Where a segment of a bead ends up: beside air that reaches the outside, beside air inside the
// finished print, or between other beads.
enum class BeadSight : std::uint8_t { Open, Enclosed, Buried };
inline constexpr std::size_t kBeadSights = 3;
inline constexpr std::size_t kBeadLevels = 3; // of less detail

// A body that is put into the part before a layer, and the first waypoint after it.
struct InsertDrawing {
  vtkSmartPointer<vtkPolyData> surface, edges;
  int layer = 0;
  std::size_t first = 0;
};

struct PathsDrawing {
  // Points 2 i and 2 i + 1 are the two sides of waypoint i's bead; a segment is two triangles.
  vtkSmartPointer<vtkPolyData> beads;
  vtkSmartPointer<vtkPolyData> travels; // one line per travel move
  // Segments in drawn order: by layer, within it in print order; first the permanently visible
  // ones, then the others in chunks. One index counts two triangles.
  std::vector<std::uint32_t> arrival; // waypoint at a segment's end
  std::vector<std::size_t> outerStart;
  // Behind all of them, for fast frames: all segments again with fewer and fewer waypoints. Those
  // of layer l and sight s are [start[n], start[n + 1]), n = kBeadSights l + s.
  std::array<std::vector<std::size_t>, kBeadLevels> coarse;
  std::vector<BeadChunk> chunks;
  std::vector<std::size_t> chunkStart; // of a layer, in chunks
  std::vector<std::uint32_t> travelArrival;
  std::vector<std::size_t> travelStart;
  std::vector<std::vector<std::uint32_t>> waypointsOfLayer;
  std::vector<std::uint32_t> pathOf; // per waypoint
  std::vector<int> layerOfPath;
  ColourValues values; // per waypoint
  std::vector<InsertDrawing> inserts;
  Eigen::AlignedBox3d box;
};

// Returns a line along the tops of the beads of a path; empty for an unknown path.
vtkSmartPointer<vtkPolyData> pathLine(const PathsDrawing& paths, std::size_t path);

// Visible part of a body of a cell.
struct CellPiece {
  std::size_t body = 0;                 // index in Cell::bodies()
  int frame = 0;                        // the frame that moves it
  vtkSmartPointer<vtkPolyData> surface; // if coloured, one colour per point, otherwise the theme's
  bool coloured = false;
};

struct CellDrawing {
  robot::Cell cell;
  std::vector<CellPiece> pieces;                    // links first
  std::vector<vtkSmartPointer<vtkPolyData>> solids; // collision solids, one per body
  // A pin whose tip is the place for purges, in the world; null: the cell has none.
  vtkSmartPointer<vtkPolyData> purgePlace;
};

} // namespace voluta::scene
