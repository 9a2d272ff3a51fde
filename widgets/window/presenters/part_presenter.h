// The active part in the viewport, the parts beside it, their platform and the cell around them.
#pragma once

#include "document/document.h"
#include "jobs/job_runner.h"
#include "viewer/viewport.h"
#include "window/presenters/shown_plate_parts.h"

#include <Eigen/Geometry>
#include <QObject>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace voluta::window {

class PartPresenter : public QObject {
  Q_OBJECT

public:
  // Both must outlive this.
  PartPresenter(document::Document& document, viewer::Viewport& viewport);
  ~PartPresenter() override;

  // Bounding box of the active part, work frame; empty: no part.
  const Eigen::AlignedBox3d& box() const { return box_; }
  bool busy() const;
  // The shown cell: the chosen one in its home pose, or that of the shown plan.
  enum class CellOf { Choices, Plan };
  void showCell(CellOf which);
  // Returns whether the cell to show is drawn.
  bool hasCell() const { return cells_[static_cast<std::size_t>(shownCell_)] != nullptr; }

signals:
  void platformDrawn(const Eigen::Vector3d& sizeMm);
  void drawn(bool another); // another: not the previously shown parts in another placement
  void cellDrawn();

private:
  // The choices and the placed part of each item that determine the platform
  using PlatformKey =
      std::vector<std::pair<std::string, std::shared_ptr<const geometry::TriangleMesh>>>;
  static PlatformKey platformKeyOf(const project::Choices& choices, const project::Job& job);

  using Sources = std::vector<std::shared_ptr<const project::LoadedPart>>;
  void show(project::Stage stage);
  void showActive();
  void clear();
  void drawSource();
  void drawPart(const std::shared_ptr<const geometry::TriangleMesh>& mesh);
  // Returns whether another set of parts than `before` is open and the camera has to frame it: none
  // of them is left, or the camera is not the user's.
  bool framesAnew(const Sources& before) const;
  void swapPart(const std::shared_ptr<const scene::PartDrawing>& drawing,
                const Eigen::AlignedBox3d& box);
  void drawPlatform(const platform::PlatformSolid& platform);
  void drawPlannedPlatform();
  void swapPlatform(const std::shared_ptr<const scene::PlatformDrawing>& drawing,
                    const Eigen::Vector3d& sizeMm);
  void drawCell(const std::shared_ptr<const robot::Cell>& cell);
  std::shared_ptr<const pipeline::PlanResult> placedForCell() const;
  void drawChosenCell();
  void swapCell(CellOf which, std::shared_ptr<const scene::CellDrawing> drawing);

  document::Document& document_;
  viewer::Viewport& viewport_;
  std::unique_ptr<jobs::JobRunner> drawingPart_, drawingPlatform_, drawingCell_, drawingChosenCell_;
  PlateParts plate_;
  // The parts when the active part, and when all parts were drawn last
  Sources shownSources_, drawnSources_;
  // Last drawn, so that the same data are not drawn twice.
  std::shared_ptr<const geometry::TriangleMesh> drawnPart_;
  std::shared_ptr<const robot::Cell> drawnCell_;
  // Inputs of the drawn chosen cell: a key of the choices, the part.
  std::pair<std::string, std::shared_ptr<const geometry::TriangleMesh>> chosenCell_;
  std::array<std::shared_ptr<const scene::CellDrawing>, 2> cells_; // by CellOf
  CellOf shownCell_ = CellOf::Choices;
  // Inputs of the drawn platform: a key of the choices, the part.
  PlatformKey drawnPlatform_;
  Eigen::AlignedBox3d box_;
};

} // namespace voluta::window
