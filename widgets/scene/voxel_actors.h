// Actors of one voxel drawing: faces, faint faces, missed voxels.
#pragma once

#include "scene/actors.h"
#include "scene/drawing_data.h"
#include "scene/view_state.h"

#include <array>
#include <vector>

namespace voluta::scene {

class VoxelActors {
public:
  explicit VoxelActors(vtkRenderer* renderer);

  // Null: none. The drawing must outlive its display.
  void setDrawing(const VoxelDrawing* drawing);
  void setTheme(const Theme& theme);

  // Shows the voxels selected by the view, by growth step if `replayed`.
  void show(const ViewState& view, bool replayed);
  void hide();
  // Fills the buffers with the next frame without showing anything, so that the first display is as
  // fast as any frame.
  void prepare();

  // For poses and sections.
  std::vector<vtkActor*> actors() const;

private:
  const VoxelDrawing* drawing_ = nullptr;
  RangeActor outside_, inside_, ghosts_;
  std::array<RangeActor, kLossCount> missed_, halos_; // by reason
};

} // namespace voluta::scene
