// Simulate: the robot prints, its joints are plotted in step.
#pragma once

#include "window/pages/page.h"

namespace voluta::timeline {
class JointPlots;
}

namespace voluta::window {

class SimulatePage : public Page, public ViewportInput {
  Q_OBJECT

public:
  explicit SimulatePage(const Workspace& workspace);

  QWidget* side() override { return side_; }
  PageLayout layout() const override { return {false, timeline::BarMode::Time, true}; }
  std::vector<ViewportInput*> inputs() override { return {this}; }
  std::vector<project::Stage> stages() const override { return {project::Stage::Motion}; }

  void draw(scene::ViewState& view) override;
  std::optional<Laid> laid() const override;
  void goToWaypoint(const plan::ToolPath& path, std::size_t waypoint) override;
  int interest(const plan::Finding& finding) const override;
  bool goTo(const plan::Finding& finding) override;

  void clicked(const std::optional<scene::Hit>& hit) override;

private:
  void showMotion();
  void goToTimeOf(std::size_t waypoint);

  timeline::JointPlots* plots_;
  QWidget* side_;
};

} // namespace voluta::window
