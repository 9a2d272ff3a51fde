// The pieces in the viewport, the cuts that made them, and what other cuts would come to.
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
  // The viewport outlives this.
  explicit PiecesPresenter(viewer::Viewport& viewport, QObject* parent = nullptr);
  ~PiecesPresenter() override;

  // Null: none; what is on show goes at once. `choices` say when faces need support.
  void setPieces(std::shared_ptr<const planar::PlanarDecomposition> pieces,
                 const project::Choices& choices);
  // Of the drawing on show; 0: none.
  int count() const { return drawing_ ? scene::pieceCount(*drawing_) : 0; }
  // How many pieces stand on each other at most; 0: none are on show.
  int storeys() const { return storeys_; }
  // Of the pieces on show, as cutsOf() has them.
  const std::vector<planar::GivenCut>& cuts() const { return cuts_; }
  int cutOf(int piece) const; // -1: none, it stands on the plate
  int pieceOf(int cut) const; // -1: none
  // Where the base plane of a piece is drawn, off its place on the part.
  Eigen::Vector3d planeOffset(int piece, double explodeMm) const;

  // What of the part would need support, cut so: on a simplified part or on the part itself. Of
  // several that follow each other fast the last counts.
  void estimate(std::shared_ptr<const geometry::TriangleMesh> part, const project::Choices& choices,
                std::vector<planar::GivenCut> cuts, bool exact);
  void dropEstimate();
  bool busy() const;

signals:
  void drawn();
  // `problem` empty: none.
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
  std::optional<Wanted> wanted_; // the next to be estimated
};

} // namespace voluta::window
