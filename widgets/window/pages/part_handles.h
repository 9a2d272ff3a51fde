// Moving, rotating, scaling and laying the part on a face by handles and clicks in the viewport.
#pragma once

#include "geometry/placement.h"
#include "window/pages/page.h"

namespace voluta::window {

class PartHandles : public QObject, public ViewportInput {
  Q_OBJECT

public:
  // `page`: on which the tools can be used. All must outlive this.
  PartHandles(const Workspace& workspace, const Page& page);

  std::vector<Command> commands();
  // Returns the placement with which edits start.
  geometry::Placement placed() const;
  // Without a part: no tool.
  void setTool(viewer::Tool tool);

  void clicked(const std::optional<scene::Hit>& hit) override;
  void gizmoStarted() override;
  void gizmoDragged(const viewer::GizmoChange& change, bool finished) override;

private:
  std::vector<Command> toolCommands();
  bool areHandles() const;
  void drop();
  void centre();
  void layOnFace(const Eigen::Vector3d& normal);
  void layOnTouchedPoints();
  void placeDragged(const viewer::GizmoChange& change);

  Workspace work_;
  const Page& page_;
  geometry::Placement before_; // before the drag
  double scaleBefore_ = 1.0;
};

} // namespace voluta::window
