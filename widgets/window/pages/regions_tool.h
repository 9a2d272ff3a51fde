// Edits the regions of the active part: their list in a panel, their bodies in the view.
#pragma once

#include "document/document.h"
#include "jobs/job_runner.h"
#include "panels/regions_panel.h"
#include "regions/painting.h"
#include "scene/drawings.h"
#include "window/pages/page.h"

#include <Eigen/Geometry>
#include <QObject>
#include <QTimer>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace voluta::window {

class RegionsTool : public QObject, public ViewportInput {
  Q_OBJECT

public:
  // All must outlive this.
  RegionsTool(const Workspace& workspace, const Page& page, QObject* parent);

  // Created here, to be placed by the caller; for while the tool is open.
  panels::RegionsPanel* panel() { return panel_; }
  std::vector<Command> commands();
  bool isOpen() const { return open_; }
  // Shows the bodies in the part; while the tool is closed, their outlines.
  void draw(scene::ViewState& view) const;

  void painted(const std::optional<scene::Hit>& hit, bool erases, bool finished) override;
  void gizmoStarted() override;
  void gizmoDragged(const viewer::GizmoChange& change, bool finished) override;

signals:
  void opened(bool open);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  using Mesh = std::shared_ptr<const geometry::TriangleMesh>;
  // The part where it is printed, as far as it is known.
  struct Placed {
    std::shared_ptr<const project::LoadedPart> source;
    Mesh part;
    geometry::Placement placement;
    double scale = 1.0; // from the file's lengths to mm
  };
  // A body that was made before; it depends on all else.
  struct Kept {
    std::string shape;
    Mesh surface, part, body;
  };
  struct Made;
  // A touch of the brush, in the coordinates of the part's file.
  struct Dab {
    Eigen::Vector3d place = Eigen::Vector3d::Zero();
    double radius = 0.0, angleRad = 0.0;
    bool faces = false, erases = false;
    std::optional<regions::SeenThrough> through = {}; // a rectangle instead
  };
  struct Painted;

  void listen();
  void setOpen(bool open);
  void changeTool(viewer::Tool tool);
  void takeDocument();
  void takePlaced();
  void showProblem();
  void makeBodies();
  void takeBodies(const Made& made);
  void showHandles();
  bool beginStroke();
  void paintRectangle(const std::array<viewer::Ray, 4>& corners, bool erases);
  void paintDabs();
  void endStroke();
  void dropStroke();
  void growLayers();
  void add(const QString& kind);
  void addFromFile();
  void append(project::Region region);
  void set(const std::vector<project::Region>& regions, const QString& editName);
  // Returns the middle of the selected region in its file's coordinates; nullopt: it has none.
  std::optional<Eigen::Vector3d> middle() const;
  bool isPainted() const; // the selected region
  QString partName() const;

  const Workspace work_;
  const Page& page_;
  panels::RegionsPanel* panel_;
  jobs::JobRunner drawing_, reading_, painting_;
  bool open_ = false, dragging_ = false;
  Placed placed_;
  std::vector<Kept> kept_;
  std::shared_ptr<const scene::RegionsDrawing> bodies_;
  Eigen::Isometry3d work_T_file_ = Eigen::Isometry3d::Identity(); // of scaled coordinates
  bool isPosed_ = false;                                          // work_T_file_ is that of placed_
  Eigen::Vector3d movedMm_ = Eigen::Vector3d::Zero();
  QString bodyProblem_;
  // The stroke that is being painted.
  std::shared_ptr<const regions::PaintableSurface> surface_; // of surfaceOf_
  Mesh surfaceOf_, stroke_;
  std::vector<Dab> dabs_; // not painted yet
  std::optional<Eigen::Vector3d> lastDabMm_;
  std::size_t strokeOf_ = 0; // the region
  bool isStroke_ = false, strokeEnds_ = false;
  QTimer rest_; // of the brush
};

} // namespace voluta::window
