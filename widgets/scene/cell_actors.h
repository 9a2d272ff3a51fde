// Bodies of a cell in a picture.
#pragma once

#include "scene/actors.h"
#include "scene/drawing_data.h"
#include "scene/theme.h"
#include "scene/view_state.h"

#include <Eigen/Geometry>
#include <vector>

namespace voluta::scene {

class CellActors {
public:
  explicit CellActors(vtkRenderer* renderer) : renderer_(renderer) {}

  // Null: none. The drawing outlives its being shown.
  void setDrawing(const CellDrawing* drawing);
  void setTheme(const Theme& theme);
  // Poses of the cell's frames.
  void pose(const std::vector<Eigen::Isometry3d>& world_T_frame);
  // `byPlatform`: the cell's platform is drawn otherwise.
  void show(const ViewState& view, bool byPlatform);
  // What a part stands on, and obstacles: seen through from below.
  void setSeenThrough(bool on);

  // In the world; of all but obstacles.
  Eigen::AlignedBox3d box() const;

private:
  const Colour& colourOf(const robot::Body& body) const;
  bool shows(const ViewState& view, std::size_t body, bool byPlatform) const;
  void colour();

  vtkRenderer* renderer_;
  Theme theme_;
  const CellDrawing* drawing_ = nullptr;
  std::vector<vtkSmartPointer<vtkActor>> pieces_;
  std::vector<vtkSmartPointer<vtkActor>> solids_; // one a body
};

} // namespace voluta::scene
