// Actors of the platform that material starts on.
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

  // Null: none. The drawing must outlive its display.
  void setDrawing(const PlatformDrawing* drawing);
  void setReach(const ReachDrawing* reach);
  void setTheme(const Theme& theme);
  void pose(const Eigen::Isometry3d& world_T_work);
  // `byCell`: the cell's bodies already include the plate.
  void show(const ViewState& view, bool byCell);
  bool showsRod() const { return rod_->GetVisibility() != 0; }
  // Makes the plate transparent if it is seen from below, so that the part remains visible. The eye
  // in the work frame.
  void lookFrom(const Eigen::Vector3d& eye);

  // Returns the box of the rod's section at the visible objects, or of the whole rod if nothing is
  // visible. Both in the work frame. Precondition: a rod.
  Eigen::AlignedBox3d rodBeside(const Eigen::AlignedBox3d& shown) const;

private:
  const PlatformDrawing* drawing_ = nullptr;
  const ReachDrawing* reachDrawing_ = nullptr;
  vtkSmartPointer<vtkActor> plate_, rod_, base_, grid_, outline_, ruling_, axisX_, axisY_, reach_;
};

} // namespace voluta::scene
