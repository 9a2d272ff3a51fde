// The pieces in the viewport, their cuts, and estimates for other cuts.
#pragma once

#include "geometry/triangle_mesh.h"
#include "jobs/job_runner.h"
#include "planar/given_cuts.h"
#include "project/job.h"
#include "scene/drawings.h"
#include "viewer/viewport.h"

#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <vector>

namespace voluta::window {

class PiecesPresenter : public QObject {
  Q_OBJECT

public:
  // The viewport must outlive this.
  explicit PiecesPresenter(viewer::Viewport& viewport, QObject* parent = nullptr);
  ~PiecesPresenter() override;

  // Null: removes the shown pieces immediately. `choices` determine which faces need support.
  void setPieces(std::shared_ptr<const planar::PlanarDecomposition> pieces,
                 const project::Choices& choices);
  // Shows the pieces again after something else has drawn others.
  void showAgain();
  // Of the shown drawing; 0: none.
  int count() const { return drawing_ ? scene::pieceCount(*drawing_) : 0; }
  // Returns the maximum number of pieces on top of each other; 0: none shown.
  int storeys() const { return storeys_; }
  // The cuts of the shown pieces, as cutsOf() returns them.
  const std::vector<planar::GivenCut>& cuts() const { return cuts_; }
  int cutOf(int piece) const; // -1: none, it is on the plate
  int pieceOf(int cut) const; // -1: none
  // Returns the displacement of a piece's drawn base plane from its place on the part.
  Eigen::Vector3d planeOffset(int piece, double explodeMm) const;

  // Estimates the area that would need support with these cuts, on a simplified part or on the part
  // itself. Of several requests in quick succession only the last is completed.
  void estimate(std::shared_ptr<const geometry::TriangleMesh> part, const project::Choices& choices,
                std::vector<planar::GivenCut> cuts, bool exact);
  void dropEstimate();
  bool busy() const;

signals:
  void drawn();
  // `problem`: empty if there is none.
  void estimated(double riskyMm2, bool exact, const QString& problem);

private:
  struct Wanted {
    std::shared_ptr<const geometry::TriangleMesh> part;
    project::Choices choices;
    std::vector<planar::GivenCut> cuts;
    bool exact = false;
  };
  struct Coarse { // of a part, for estimates
    std::shared_ptr<const geometry::TriangleMesh> of;
    std::shared_ptr<const geometry::TriangleMesh> mesh;
  };
  void startEstimate();

  viewer::Viewport& viewport_;
  std::unique_ptr<jobs::JobRunner> drawingRun_, estimating_;
  std::shared_ptr<const planar::PlanarDecomposition> pieces_;
  std::shared_ptr<const scene::PiecesDrawing> drawing_;
  std::vector<planar::GivenCut> cuts_;
  std::vector<std::size_t> pieceOfCut_;
  int storeys_ = 0;
  Coarse coarse_;
  std::optional<Wanted> wanted_; // the next one to estimate
};

} // namespace voluta::window
