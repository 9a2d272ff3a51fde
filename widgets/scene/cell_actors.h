// Bodies of a cell in a scene.
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

  // Null shows nothing. Precondition: the drawing outlives its use here.
  void setDrawing(const CellDrawing* drawing);
  void setTheme(const Theme& theme);
  // Sets the poses of the cell's frames.
  void pose(const std::vector<Eigen::Isometry3d>& world_T_frame);
  // `byPlatform`: another drawing shows the cell's platform.
  void show(const ViewState& view, bool byPlatform);
  // Makes the part's base and obstacles transparent for views from below.
  void setSeenThrough(bool on);

  // Returns the box of the visible bodies except obstacles, in world coordinates.
  Eigen::AlignedBox3d box() const;

private:
  const Colour& colourOf(const robot::Body& body) const;
  bool shows(const ViewState& view, std::size_t body, bool byPlatform) const;
  void colour();

  vtkRenderer* renderer_;
  Theme theme_;
  const CellDrawing* drawing_ = nullptr;
  bool dimmed_ = false;
  std::vector<vtkSmartPointer<vtkActor>> pieces_;
  std::vector<vtkSmartPointer<vtkActor>> solids_; // one per body
  vtkSmartPointer<vtkActor> purgePlace_;          // null: none
};

} // namespace voluta::scene
