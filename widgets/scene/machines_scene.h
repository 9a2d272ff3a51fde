// Several machines in one cell as a VTK renderer: their arms, plates and beads, at one moment. Not
// thread-safe; needs a rendering context only while its renderer draws.
#pragma once

#include "robot/robot_model.h"
#include "scene/colouring.h"
#include "scene/drawings.h"
#include "scene/theme.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

class vtkRenderer;

namespace voluta::scene {

struct MachineDrawing {
  std::shared_ptr<const CellDrawing> cell;   // never null
  std::shared_ptr<const PathsDrawing> paths; // null: none
  Eigen::Isometry3d shared_T_world = Eigen::Isometry3d::Identity();
};

struct MachineMoment {
  robot::JointVector joints; // empty: the cell's home
  std::size_t printedWaypoints = 0;
};

class MachinesScene {
public:
  explicit MachinesScene(const Theme& theme);
  ~MachinesScene();
  MachinesScene(const MachinesScene&) = delete;
  MachinesScene& operator=(const MachinesScene&) = delete;

  // For one render window. Owned by the scene.
  vtkRenderer* renderer();

  // Replaces all machines, at their homes and with all beads. Beads and number of each machine have
  // a colour of its own (colourOf).
  void setMachines(std::vector<MachineDrawing> machines);
  std::size_t machineCount() const;
  // Precondition: one moment per machine.
  void setMoments(const std::vector<MachineMoment>& moments);
  // Marks a place of the shared frame with a ball; nullopt: none.
  void setMarker(const std::optional<Eigen::Vector3d>& place);

  void frameAll();
  // Returns a point above the base of a machine, for its number. Shared frame [mm].
  Eigen::Vector3d placeOfNumber(std::size_t machine) const;

  static Colour colourOf(std::size_t machine) {
    return categoricalColour(static_cast<int>(machine));
  }

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

} // namespace voluta::scene
