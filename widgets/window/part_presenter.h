// The part in the viewport, what it stands on and the cell around it.
#pragma once

#include "document/document.h"
#include "jobs/job_runner.h"
#include "viewer/viewport.h"

#include <Eigen/Geometry>
#include <QObject>
#include <memory>
#include <string>
#include <utility>

namespace voluta::window {

class PartPresenter : public QObject {
  Q_OBJECT

public:
  // Both outlive this.
  PartPresenter(document::Document& document, viewer::Viewport& viewport);
  ~PartPresenter() override;

  // Of the part on show, work frame; empty: no part.
  const Eigen::AlignedBox3d& box() const { return box_; }
  bool busy() const;
  // The cell's arm as the solids that are checked for collisions, else as its meshes where it has
  // such.
  void setCollisionSolids(bool on);

signals:
  void drawn(bool another); // another: not the one that was on show with another placement

private:
  void show(project::Stage stage);
  void drawSource();
  void drawPart(const std::shared_ptr<const geometry::TriangleMesh>& mesh);
  void swapPart(const std::shared_ptr<const scene::PartDrawing>& drawing,
                const Eigen::AlignedBox3d& box);
  void drawPlatform(const platform::PlatformSolid& platform);
  void drawPlannedPlatform();
  void swapPlatform(const std::shared_ptr<const scene::PlatformDrawing>& drawing);
  void drawCell(const std::shared_ptr<const robot::Cell>& cell);

  document::Document& document_;
  viewer::Viewport& viewport_;
  std::unique_ptr<jobs::JobRunner> drawingPart_, drawingPlatform_, drawingCell_;
  std::shared_ptr<const void> shownSource_;
  // What was drawn last, so that the same data is never drawn twice.
  std::shared_ptr<const geometry::TriangleMesh> drawnPart_;
  std::shared_ptr<const robot::Cell> drawnCell_;
  bool collisionSolids_ = false;
  // What the platform was drawn from: what of the choices, the part.
  std::pair<std::string, std::shared_ptr<const geometry::TriangleMesh>> drawnPlatform_;
  Eigen::AlignedBox3d box_;
};

} // namespace voluta::window
