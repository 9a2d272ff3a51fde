// Pieces of planar mode: chosen in tree or viewport, moved apart, their cuts dragged by handles.
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
  // `shown`: are the pieces what is on show?
  PieceCuts(const Workspace& workspace, std::function<bool()> shown);

  // Made here, to be put somewhere.
  panels::PiecesPanel* panel() { return panel_; }
  void draw(scene::ViewState& view) const;
  // Handles on the chosen piece's base plane; elsewhere the tools are those of the part.
  void showHandles();
  // Flies to the face that the finding is about, to a side that it is seen from; false: it is not
  // about pieces, or there are none. What is on show is to be the pieces.
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
  std::vector<planar::GivenCut> cuts_, cutsBeforeDrag_; // as the choices have them, else as found
  int chosenCut_ = -1;                                  // of the chosen piece; -1: none
  bool handles_ = false;
};

} // namespace voluta::window
