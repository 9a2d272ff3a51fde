// What material starts on, in a picture.
#pragma once

#include "scene/actors.h"
#include "scene/drawing_data.h"
#include "scene/theme.h"
#include "scene/view_state.h"

#include <Eigen/Geometry>

namespace voluta::scene {

class PlatformActors {
public:
  explicit PlatformActors(vtkRenderer* renderer);

  // Null: none. The drawing outlives its being shown.
  void setDrawing(const PlatformDrawing* drawing);
  void setReach(const ReachDrawing* reach);
  void setTheme(const Theme& theme);
  void pose(const Eigen::Isometry3d& world_T_work);
  // `byCell`: the plate is there as a body of the cell.
  void show(const ViewState& view, bool byCell);
  bool showsRod() const { return rod_->GetVisibility() != 0; }
  // From below the plate is glass: what stands on it is looked at through it. The eye in the work
  // frame.
  void lookFrom(const Eigen::Vector3d& eye);

  // Of the rod, what lies at what is shown, or all of it. Both in the work frame. Precondition: a
  // rod.
  Eigen::AlignedBox3d rodBeside(const Eigen::AlignedBox3d& shown) const;

private:
  const PlatformDrawing* drawing_ = nullptr;
  const ReachDrawing* reachDrawing_ = nullptr;
  vtkSmartPointer<vtkActor> plate_, rod_, base_, grid_, outline_, reach_;
};

} // namespace voluta::scene
