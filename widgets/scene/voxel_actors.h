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
  // The voxels, or the blocks of fast frames.
  struct Detail {
    explicit Detail(vtkRenderer* renderer);

    void setDrawing(const VoxelDrawing* given);
    void show(const ViewState& view, bool replayed) const;
    void prepare() const;

    const VoxelDrawing* drawing = nullptr;
    RangeActor outside, inside, ghosts;
    std::array<RangeActor, kLossCount> missed, halos; // by reason
  };
  static constexpr std::size_t kFine = 0, kCoarse = 1;

  std::array<Detail, 2> details_;
};

} // namespace voluta::scene
