// From the document's results to what the viewport draws and the panels show, prepared in the
// background: the window's thread only swaps finished things in.
#pragma once

#include "document/document.h"
#include "jobs/job_runner.h"
#include "panels/layer_info.h"
#include "timeline/clock.h"
#include "viewer/viewport.h"
#include "window/layer_spacing.h"
#include "window/pieces_presenter.h"
#include "window/voxel_presenter.h"

#include <QObject>
#include <array>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

namespace voluta::window {

// What the Layers page knows of the layers on show.
struct LayerFacts {
  std::vector<panels::LayerMeasures> measures;
  std::vector<double> topsMm; // heights, or radii about an axis
  bool radii = false;
  LayerSpacing spacing;
};

class Presenter : public QObject {
  Q_OBJECT

public:
  // Both outlive this.
  Presenter(document::Document& document, viewer::Viewport& viewport, QObject* parent = nullptr);
  ~Presenter() override;

  VoxelPresenter& voxels() { return voxels_; }
  const VoxelPresenter& voxels() const { return voxels_; }
  PiecesPresenter& pieces() { return pieces_; }
  const PiecesPresenter& pieces() const { return pieces_; }
  bool hasPieces() const { return pieces_.count() > 0; }
  bool hasVoxels() const { return voxels_.layers() > 0; }
  bool hasLayers() const { return patchLayers_ > 0; }
  bool hasPaths() const { return pathLayers_ > 0; }
  // Layers of what is drawn furthest down the road, or of voxels that are newer; 0: none.
  int layerCount() const;
  const std::shared_ptr<const timeline::Clock>& clock() const { return clock_; }
  const std::shared_ptr<const LayerFacts>& facts() const { return facts_; }
  // Moves of a layer, as the move slider counts them.
  int movesOf(int layer) const;
  // Of the part on show, work frame; empty: no part.
  const Eigen::AlignedBox3d& partBox() const { return partBox_; }
  // How it lies there, also where the way of building laid it.
  const geometry::Placement& placement() const { return placement_; }
  static bool isUntouched(const geometry::Placement& placement);
  // Waypoints of a layer in print order, as moves count them.
  const std::vector<std::uint32_t>& waypointsOf(int layer) const;

  // Anything being prepared?
  bool busy() const;

signals:
  void partDrawn(bool another); // another: not the one that was on show with another placement
  void voxelsDrawn();
  void layersDrawn();
  void pathsDrawn();
  void motionReady();
  void factsReady();

private:
  enum Slot { Part, Plate, Patches, Paths, CellBodies, Facts, kSlotCount };

  void drawSource();
  void show(project::Stage stage);
  void drawPart(std::shared_ptr<const geometry::TriangleMesh> mesh);
  void swapPart(const std::shared_ptr<const scene::PartDrawing>& drawing,
                const Eigen::AlignedBox3d& box);
  void drawPlatform(const platform::PlatformSolid& platform);
  void drawPlannedPlate();
  void drawVoxels(); // of the preview where there is one
  void drawPieces();
  void drawMotion();
  void gatherFacts();
  document::Document& document_;
  viewer::Viewport& viewport_;
  VoxelPresenter voxels_;
  PiecesPresenter pieces_;
  std::array<std::unique_ptr<jobs::JobRunner>, kSlotCount> runners_;
  std::shared_ptr<const timeline::Clock> clock_;
  std::shared_ptr<const LayerFacts> facts_;
  std::shared_ptr<const scene::PathsDrawing> paths_;
  std::shared_ptr<const void> shownSource_;
  // What was drawn last, so that the same data is never drawn twice.
  std::array<std::shared_ptr<const void>, kSlotCount> drawn_;
  // What the platform was drawn from: what of the choices, the part.
  std::tuple<std::string, std::shared_ptr<const geometry::TriangleMesh>> plateDrawn_;
  Eigen::AlignedBox3d partBox_;
  geometry::Placement placement_;
  int patchLayers_ = 0, pathLayers_ = 0;
};

} // namespace voluta::window
