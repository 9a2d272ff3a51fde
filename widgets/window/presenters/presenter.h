// Turns the document's results into drawings and panel contents. Works in the background; the
// window's thread only swaps in finished data.
#pragma once

#include "document/document.h"
#include "viewer/viewport.h"
#include "window/presenters/part_presenter.h"
#include "window/presenters/pieces_presenter.h"
#include "window/presenters/print_presenter.h"
#include "window/presenters/voxel_presenter.h"

#include <QObject>
#include <memory>
#include <vector>

namespace voluta::window {

class Presenter : public QObject {
  Q_OBJECT

public:
  // Both must outlive this.
  Presenter(document::Document& document, viewer::Viewport& viewport, QObject* parent = nullptr);
  ~Presenter() override;

  VoxelPresenter& voxels() { return voxels_; }
  PiecesPresenter& pieces() { return pieces_; }
  bool hasPieces() const { return pieces_.count() > 0; }
  bool hasVoxels() const { return voxels_.layers() > 0; }
  bool hasLayers() const { return print_.patchLayers() > 0; }
  bool hasPaths() const { return print_.pathLayers() > 0; }
  bool hasCell() const { return part_.hasCell(); }
  // Number of drawn layers of each kind; 0: none.
  int voxelLayers() const { return voxels_.layers(); }
  int patchLayers() const { return print_.patchLayers(); }
  int pathLayers() const { return print_.pathLayers(); }
  // Bounding box of the shown part, work frame; empty: no part.
  const Eigen::AlignedBox3d& partBox() const { return part_.box(); }
  void showCell(PartPresenter::CellOf which) { part_.showCell(which); }
  // Of the motion, if it is for the chosen cell; null: there is none.
  const std::shared_ptr<const timeline::Clock>& clock() const { return print_.clock(); }
  const std::shared_ptr<const LayerFacts>& facts() const { return print_.facts(); }
  const std::shared_ptr<const ShownStatistics>& statistics() const { return print_.statistics(); }
  // Returns the waypoints of a layer in print order, as counted by moves.
  const std::vector<std::uint32_t>& waypointsOf(int layer) const {
    return print_.waypointsOf(layer);
  }
  // Returns the number of moves of a layer, as counted by the move slider.
  int movesOf(int layer) const { return static_cast<int>(waypointsOf(layer).size()); }

  // Returns whether anything is being prepared.
  bool busy() const;

signals:
  void platformDrawn(const Eigen::Vector3d& sizeMm);
  void partDrawn(bool another); // another: not the previously shown part in another placement
  void cellDrawn();
  void voxelsDrawn();
  void layersDrawn();
  void pathsDrawn();
  void motionReady();
  void factsReady();
  void statisticsReady();

private:
  void drawVoxels(); // of the preview if there is one
  void drawPieces();

  document::Document& document_;
  PartPresenter part_;
  VoxelPresenter voxels_;
  PiecesPresenter pieces_;
  PrintPresenter print_;
};

} // namespace voluta::window
