// Where the chosen cell's head reaches, found in the background: a map on the plate, whether the
// part is inside it, and the way to the best place.
#pragma once

#include "jobs/job_runner.h"
#include "panels/reach_panel.h"
#include "pipeline/cell_reach.h"
#include "window/pages/page.h"

#include <Eigen/Core>
#include <QObject>
#include <memory>
#include <optional>
#include <string>

namespace voluta::window {

class PartHandles;

class ReachView : public QObject, public ViewportInput {
  Q_OBJECT

public:
  // All outlive this but the panel, which is made here to be put somewhere.
  ReachView(const Workspace& workspace, const PartHandles& handles, QObject* parent);

  panels::ReachPanel* panel() { return panel_; }
  void draw(scene::ViewState& view) const;

  // The part's colour follows the handles.
  void gizmoDragged(const viewer::GizmoChange& change, bool finished) override;

private:
  struct Found;

  void refresh();
  void look(const std::string& key, double heightMm);
  void take(Found&& found);
  void showReach();
  void setBeyond(bool beyond);
  void move();
  // Of the part as it is placed now; none: no part on a plate, or no map of it yet.
  std::optional<cells::Place> placeNow() const;

  const Workspace& work_;
  const PartHandles& handles_;
  panels::ReachPanel* panel_;
  jobs::JobRunner runner_;
  std::string key_; // of the map that was looked for last
  std::shared_ptr<const cells::ReachMap> map_;
  std::optional<cells::Standing> standing_; // of the part on show
  Eigen::Vector2d middle_ = Eigen::Vector2d::Zero();
  std::optional<cells::Place> best_;
  bool mapShown_ = false, beyond_ = false;
};

} // namespace voluta::window
