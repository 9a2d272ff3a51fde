// The voxels in the viewport: by layer, by growth step, and the convex front of a step.
#pragma once

#include "curved/decomposition.h"
#include "jobs/job_runner.h"
#include "scene/drawings.h"
#include "viewer/viewport.h"

#include <QObject>
#include <memory>
#include <optional>
#include <vector>

namespace voluta::window {

class VoxelPresenter : public QObject {
  Q_OBJECT

public:
  // The viewport must outlive this.
  explicit VoxelPresenter(viewer::Viewport& viewport, QObject* parent = nullptr);
  ~VoxelPresenter() override;

  // Null: removes the shown voxels immediately. Otherwise the new voxels replace them once drawn;
  // of several in quick succession only some are drawn, always including the last. layerHeightMm as
  // in scene::VoxelLook.
  void setDecomposition(std::shared_ptr<const curved::Decomposition> decomposition,
                        double layerHeightMm);
  // Layer, GrowthStep or Peeling; others count as Layer.
  void setColouring(scene::ColourBy colourBy);
  // The replay needs a separate drawing, which is made only while `wanted`.
  void setReplayWanted(bool wanted);
  // Draws the convex front of that step; of several waiting requests the newest. None: no front.
  void setFrontStep(std::optional<int> step);

  // Of the shown drawings; 0: none.
  int layers() const { return layers_; }
  int steps() const { return steps_; }
  // Number of shown missed voxels.
  std::size_t missed() const { return missed_; }
  double pitchMm() const { return decomposition_ ? decomposition_->grid.pitch : 0.0; }
  bool busy() const;

signals:
  void drawn();       // layers() are new
  void replayReady(); // steps() are new

private:
  void draw();
  void drawReplay();
  void drawFront();
  scene::VoxelLook look() const;

  viewer::Viewport& viewport_;
  std::unique_ptr<jobs::JobRunner> voxels_, replay_, peeling_, front_;
  std::shared_ptr<const curved::Decomposition> decomposition_;
  double layerHeightMm_ = 0.0;
  scene::ColourBy colourBy_ = scene::ColourBy::Layer;
  std::shared_ptr<const std::vector<std::int32_t>> peeled_; // of decomposition_, once needed
  bool drawAgain_ = false, replayAgain_ = false; // newer requests arrived in the meantime
  bool replayWanted_ = false, replayStale_ = true;
  std::optional<int> frontWanted_, frontDrawn_;
  int layers_ = 0, steps_ = 0;
  std::size_t missed_ = 0;
};

} // namespace voluta::window
