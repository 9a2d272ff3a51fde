// Reach of the chosen cell's head, computed in the background: a map on the plate, whether the part
// is inside it, and moving the part to the best place.
#pragma once

#include "jobs/job_runner.h"
#include "panels/reach_panel.h"
#include "pipeline/cell_reach.h"
#include "window/pages/page.h"

#include <Eigen/Core>
#include <QObject>
#include <deque>
#include <memory>
#include <optional>
#include <string>

namespace voluta::window {

class PartHandles;

class ReachView : public QObject, public ViewportInput {
  Q_OBJECT

public:
  // All must outlive this except the panel, which is created here; the caller places it.
  ReachView(const Workspace& workspace, const PartHandles& handles, QObject* parent);

  panels::ReachPanel* panel() { return panel_; }
  void draw(scene::ViewState& view) const;

  // Updates the part's colour during dragging.
  void gizmoDragged(const viewer::GizmoChange& change, bool finished) override;

private:
  struct Found;

  static std::deque<Found>& kept();
  void refresh();
  void look(const std::string& key, double heightMm);
  void take(Found&& found);
  void showReach();
  void setBeyond(bool beyond);
  void move();
  // Returns the place of the part in its present placement; none: no part on a plate, or no map for
  // it yet.
  std::optional<cells::Place> placeNow() const;

  const Workspace& work_;
  const PartHandles& handles_;
  panels::ReachPanel* panel_;
  jobs::JobRunner runner_;
  std::string key_; // of the map computed last
  std::shared_ptr<const cells::ReachMap> map_;
  std::optional<cells::Standing> standing_; // of the shown part
  Eigen::Vector2d middle_ = Eigen::Vector2d::Zero();
  std::optional<cells::Place> best_;
  bool mapShown_ = false, beyond_ = false;
};

} // namespace voluta::window
