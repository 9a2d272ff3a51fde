// Pieces in a picture: each with its faces that need support, its edges and its base plane.
#pragma once

#include "scene/actors.h"
#include "scene/drawing_data.h"
#include "scene/theme.h"
#include "scene/view_state.h"

#include <Eigen/Geometry>
#include <vector>

namespace voluta::scene {

class PieceActors {
public:
  explicit PieceActors(vtkRenderer* renderer);

  // Null: none. The drawing outlives its being shown.
  void setDrawing(const PiecesDrawing* drawing);
  void setTheme(const Theme& theme);
  void show(const ViewState& view, const Eigen::Isometry3d& world_T_work);
  void hide();

  // What a section plane cuts.
  std::vector<vtkActor*> actors() const;

private:
  struct One {
    vtkSmartPointer<vtkActor> safe, risky, edges, base, baseRim;
  };
  void remove();

  vtkRenderer* renderer_;
  Theme theme_;
  const PiecesDrawing* drawing_ = nullptr;
  std::vector<One> pieces_;
};

// What the colours of pieces say; `named`: each by its number, which the picture does not show.
Legend pieceLegend(const PiecesDrawing& drawing, const Theme& theme, bool named);

} // namespace voluta::scene
