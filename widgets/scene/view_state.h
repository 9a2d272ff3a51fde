// The state of a picture that may change between frames. A value type: can be compared, stored,
// undone.
#pragma once

#include "robot/robot_model.h"
#include "scene/colouring.h"

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

namespace voluta::scene {

inline constexpr std::size_t kAllMoves = std::numeric_limits<std::size_t>::max();
inline constexpr int kAllLayers = std::numeric_limits<int>::max();

// The frame that does not move: Work for preparation and layers, Base (the robot's) for the
// simulation. With a plate on the flange, part and beads move with the arm in Base.
enum class World { Work, Base };

struct ViewState {
  bool part = true, platform = true, cell = false, voxels = false, layers = false, paths = false;
  bool pieces = false;
  bool travels = false;    // of the paths shown
  bool axes = true;        // triad in the lower left corner
  bool plateRuled = false; // grid, size and origin on the plate
  bool partSize = false;   // the box of the active part, with its edges in mm
  double partOpacity = 1.0;
  bool otherParts = false; // the parts of the job beside the active one
  double otherPartsOpacity = 1.0;
  bool reach = false;      // map of reached poses on the plate
  bool partBeyond = false; // draws the part in the colour for parts out of reach
  // of the cell's bodies, if `cell`
  std::array<bool, robot::kBodyRoleCount> roles{true, true, true, true, true};
  // frameAll() includes the whole visible cell; otherwise only the bodies around the printed part
  bool cellFramed = true;
  // draws the cell faintly behind the part; frameAll() and picks leave it out
  bool cellDimmed = false;
  // draws the solids of the collision check translucently over the cell
  bool collisionSolids = false;

  World world = World::Work;
  robot::JointVector joints; // empty: the cell's home

  // Range of layers, voxels and paths shown: first <= layer <= last, from 0.
  int firstLayer = 0, lastLayer = kAllLayers;
  // Number of waypoints shown of the last layer (ToolPlan paths only).
  std::size_t moves = kAllMoves;
  // Simulation: shows paths only up to this waypoint of the plan, in all layers of the range.
  std::size_t printedWaypoints = kAllMoves;

  // Growth: shows voxels of the first `growthStep` steps (0: none) instead of a range of layers,
  // with the last step highlighted; requires Scene::setGrowth.
  std::optional<int> growthStep;
  bool ghosts = false;     // with growthStep: later steps, faintly
  bool front = false;      // with growthStep: the convex front
  bool seeThrough = false; // draws all voxels but the missed ones faintly

  ColourBy colourBy = ColourBy::Layer; // of layers and paths; voxels have their own colours
  // draws paths in the colour of the material, except the current layer, which follows colourBy
  bool materialColour = false;
  std::uint32_t hiddenKinds = 0; // of beads: bit k hides plan::PathKind k
  bool beads = true;             // draws paths as rounded beads; false: as thin lines

  bool sectionOn = false; // cuts part, voxels, layers and paths on the side of the normal
  Eigen::Vector3d sectionOrigin = Eigen::Vector3d::Zero(), sectionNormal = Eigen::Vector3d::UnitX();

  double explodeMm = 0.0;           // pieces: distance of each from the one it is printed on
  bool pieceNumbers = true;         // on the pieces, in print order
  bool basePlanes = false;          // of all pieces; the chosen piece's is always shown
  std::optional<std::size_t> piece; // highlighted
  std::optional<Eigen::Isometry3d> moved_T_base; // its base plane while it is dragged

  bool regions = false;                                    // of the active part
  bool regionOutlines = false;                             // draws only their edges
  std::optional<std::size_t> region;                       // highlighted
  Eigen::Vector3d regionMovedMm = Eigen::Vector3d::Zero(); // the highlighted one, while dragged

  std::optional<std::size_t> path; // of the paths shown: draws a line along it

  std::optional<Eigen::Vector3d> marker; // place of a finding, work frame
  bool legend = false;                   // drawn in the picture (windows show their own)
  bool dragging = false;                 // less detail, faster frames
  // While dragging, about the number drawn of the print at most; the default is for processors.
  std::size_t draggedTriangles = 70'000;
  bool ambientOcclusion = false; // darkens corners and gaps
};

} // namespace voluta::scene
