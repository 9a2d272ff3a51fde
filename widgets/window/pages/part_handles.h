// The part moved, turned, scaled and laid on a face by handles and clicks in the viewport.
#pragma once

#include "geometry/placement.h"
#include "window/pages/page.h"

namespace voluta::window {

class PartHandles : public QObject, public ViewportInput {
  Q_OBJECT

public:
  // `page`: on which the tools can be used. All outlives this.
  PartHandles(const Workspace& workspace, const Page& page);

  std::vector<Command> commands();
  // Where edits of the placement begin.
  geometry::Placement placed() const;
  // None without a part.
  void setTool(viewer::Tool tool);

  void clicked(const std::optional<scene::Hit>& hit) override;
  void gizmoStarted() override;
  void gizmoDragged(const viewer::GizmoChange& change, bool finished) override;

private:
  std::vector<Command> toolCommands();
  void drop();
  void centre();
  void layOnFace(const Eigen::Vector3d& normal);
  void layOnTouchedPoints();
  void placeDragged(const viewer::GizmoChange& change);

  Workspace work_;
  const Page& page_;
  geometry::Placement before_; // the drag
  double scaleBefore_ = 1.0;
};

} // namespace voluta::window
