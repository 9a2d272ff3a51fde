// Pieces of planar mode: selected in tree or viewport, exploded, their cut planes dragged by
// handles.
#pragma once

#include "planar/given_cuts.h"
#include "window/pages/page.h"

#include <Eigen/Geometry>
#include <functional>
#include <optional>
#include <vector>

namespace voluta::panels {
class PiecesPanel;
}

namespace voluta::window {

class PieceCuts : public QObject, public ViewportInput {
  Q_OBJECT

public:
  // `shown`: returns whether the pieces are shown.
  PieceCuts(const Workspace& workspace, std::function<bool()> shown);

  // Created here; the caller places it.
  panels::PiecesPanel* panel() { return panel_; }
  void draw(scene::ViewState& view) const;
  // Shows handles on the chosen piece's base plane; otherwise the tools apply to the part.
  void showHandles();
  // concerns: returns whether the finding is about pieces and there are any. lookAt: flies to the
  // finding's face, from a side on which it is visible; the pieces must be shown.
  bool concerns(const plan::Finding& finding) const;
  void lookAt(const plan::Finding& finding);

  void clicked(const std::optional<scene::Hit>& hit) override;
  void gizmoStarted() override { cutsBeforeDrag_ = cuts_; }
  void gizmoDragged(const viewer::GizmoChange& change, bool finished) override;

private:
  void listen();
  void changeTool(viewer::Tool tool);
  double explodeMm() const;
  void showPieces();
  void showCuts();
  void select(int piece); // -1: none
  std::optional<Eigen::Isometry3d> movedBase() const;
  void setCuts(const QString& text, const QString& editName); // empty: the search's
  void pickRoot(const Eigen::Vector3d& point);

  Workspace work_;
  std::function<bool()> shown_;
  panels::PiecesPanel* panel_;
  std::vector<planar::GivenCut> cuts_, cutsBeforeDrag_; // from the choices, else as found
  int chosenCut_ = -1;                                  // of the chosen piece; -1: none
  bool handles_ = false;
};

} // namespace voluta::window
