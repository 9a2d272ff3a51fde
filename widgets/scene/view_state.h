// Everything about a picture that may change from frame to frame. A value: compare, store, undo.
#pragma once

#include "robot/robot_model.h"
#include "scene/colouring.h"

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>

namespace voluta::scene {

inline constexpr std::size_t kAllMoves = std::numeric_limits<std::size_t>::max();
inline constexpr int kAllLayers = std::numeric_limits<int>::max();

// What stands still: Work for preparing and layers, Base (the robot's) for the simulation. With a
// plate on the flange part and beads ride on the arm in Base.
enum class World { Work, Base };

struct ViewState {
  bool part = true, platform = true, cell = false, voxels = false, layers = false, paths = false;
  bool pieces = false;
  bool travels = false; // of the paths shown
  bool axes = true;     // triad in the lower left corner
  double partOpacity = 1.0;
  bool reach = false;      // the map of what is reached, on the plate
  bool partBeyond = false; // the part in the colour of what is out of reach
  std::array<bool, robot::kBodyRoleCount> roles{true, true, true, true, true}; // of the cell's
                                                                               // bodies, if `cell`
  bool cellFramed = true; // frameAll() sees all of the cell that is shown; else what of it stands
                          // about what is printed
  bool collisionSolids = false; // over the cell: the solids that are checked, seen through

  World world = World::Work;
  robot::JointVector joints; // empty: the cell's home

  // Layers, voxels and paths shown: first <= layer <= last, from 0.
  int firstLayer = 0, lastLayer = kAllLayers;
  // Of the last layer shown, the first `moves` waypoints (ToolPlan paths only).
  std::size_t moves = kAllMoves;
  // Simulation: paths only up to this waypoint of the plan, of all layers in the range.
  std::size_t printedWaypoints = kAllMoves;

  // Growth: voxels laid in the first `growthStep` steps (0: none) instead of a range of layers, the
  // last step standing out; needs Scene::setGrowth.
  std::optional<int> growthStep;
  bool ghosts = false;     // with growthStep: what is still to come, faintly
  bool front = false;      // with growthStep: the convex front
  bool seeThrough = false; // all voxels but the missed ones faintly

  ColourBy colourBy = ColourBy::Layer; // of layers and paths; voxels are drawn in their colours
  bool materialColour = false; // paths in the colour of the material; the layer being laid as
                               // colourBy says
  bool beads = true;           // paths as rounded beads; false: as thin lines

  bool sectionOn = false; // cuts part, voxels, layers and paths away on the side the normal shows
  Eigen::Vector3d sectionOrigin = Eigen::Vector3d::Zero(), sectionNormal = Eigen::Vector3d::UnitX();

  double explodeMm = 0.0;           // pieces: how far each stands off the one it stands on
  bool pieceNumbers = true;         // on the pieces, in print order
  bool basePlanes = false;          // of all pieces; the chosen one's is there anyway
  std::optional<std::size_t> piece; // stands out from the others
  std::optional<Eigen::Isometry3d> moved_T_base; // its base plane, while it is dragged

  std::optional<std::size_t> path; // of the paths shown: a line along it

  std::optional<Eigen::Vector3d> marker; // place of a finding, work frame
  bool legend = false;                   // drawn into the picture (a window shows its own)
  bool dragging = false;                 // less detail, faster frames
};

} // namespace voluta::scene
