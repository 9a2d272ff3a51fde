// One drawing of voxels in a picture: faces, faint faces, missed voxels.
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

  // Null: none. The drawing outlives its being shown.
  void setDrawing(const VoxelDrawing* drawing);
  void setTheme(const Theme& theme);

  // What the view asks for, by growth step where `replayed`.
  void show(const ViewState& view, bool replayed);
  void hide();
  // Nothing in sight, but the buffers are filled with the next frame: showing it later takes no
  // longer than any frame.
  void prepare();

  // For poses and sections.
  std::vector<vtkActor*> actors() const;

private:
  const VoxelDrawing* drawing_ = nullptr;
  RangeActor outside_, inside_, ghosts_;
  std::array<RangeActor, kLossCount> missed_, halos_; // by reason
};

} // namespace voluta::scene
