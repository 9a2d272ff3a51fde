// Cuts the active part with a plane that is moved and tilted in the view, shows the halves, and
// splits a part into its bodies.
#pragma once

#include "document/document.h"
#include "jobs/job_runner.h"
#include "panels/cut_panel.h"
#include "scene/drawings.h"
#include "window/pages/page.h"

#include <Eigen/Geometry>
#include <QObject>
#include <memory>
#include <optional>
#include <vector>

namespace voluta::window {

class CutTool : public QObject, public ViewportInput {
  Q_OBJECT

public:
  // All must outlive this.
  CutTool(const Workspace& workspace, const Page& page, QObject* parent);

  // Created here, to be placed by the caller; for while the tool is open.
  panels::CutPanel* panel() { return panel_; }
  std::vector<Command> commands();
  bool isOpen() const { return open_; }
  // Shows the halves instead of the part.
  void draw(scene::ViewState& view) const;

  void clicked(const std::optional<scene::Hit>& hit) override;
  void gizmoStarted() override;
  void gizmoDragged(const viewer::GizmoChange& change, bool finished) override;

signals:
  void opened(bool open);

private:
  using Mesh = std::shared_ptr<const geometry::TriangleMesh>;
  struct Preview;

  void listen();
  void setOpen(bool open);
  void changeTool(viewer::Tool tool);
  // Returns the active part in its place; null while it is placed.
  Mesh placedPart() const;
  void takePart();
  void takeNumbers();
  void toMiddle();
  void setNormal(const Eigen::Vector3d& normal);
  void showPlane();
  planar::Plane plane() const;
  void preview();
  void startPreview();
  void show(const Preview& made);
  void cut();
  void split();
  void makeParts(
      const QString& title, const QString& editName, bool isSplit,
      std::function<std::vector<document::Document::Successor>(const base::RunContext&)> work);
  bool canCut() const;
  QString partName() const;

  const Workspace work_;
  const Page& page_;
  panels::CutPanel* panel_;
  jobs::JobRunner drawing_, making_;
  bool open_ = false, picking_ = false, dragging_ = false, again_ = false;
  Mesh part_;
  std::shared_ptr<const project::LoadedPart> source_; // of part_
  Eigen::AlignedBox3d box_;
  Eigen::Vector3d pivot_ = Eigen::Vector3d::Zero(), normal_ = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d pivotBefore_ = Eigen::Vector3d::Zero(), normalBefore_ = Eigen::Vector3d::UnitZ();
  std::shared_ptr<const scene::PiecesDrawing> halves_;
};

} // namespace voluta::window
