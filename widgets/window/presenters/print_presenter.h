// The print in the viewport: layers, tool-paths, the robot's motion, and facts about each layer.
#pragma once

#include "document/document.h"
#include "jobs/job_runner.h"
#include "panels/layer_info.h"
#include "timeline/clock.h"
#include "viewer/viewport.h"
#include "window/kind_statistics.h"
#include "window/layer_spacing.h"
#include "window/presenters/job_layers.h"

#include <QObject>
#include <memory>
#include <vector>

namespace voluta::window {

// Facts about the most recent layers, for the Layers page.
struct LayerFacts {
  JobLayers of;
  std::vector<panels::LayerMeasures> measures;
  std::vector<double> topsMm; // heights, or radii about an axis
  bool radii = false;
  LayerSpacing spacing;
};

// Of the shown tool-paths.
struct ShownStatistics {
  std::shared_ptr<const plan::ToolPlan> of;
  PrintStatistics figures;
};

class PrintPresenter : public QObject {
  Q_OBJECT

public:
  // Both must outlive this.
  PrintPresenter(document::Document& document, viewer::Viewport& viewport);
  ~PrintPresenter() override;

  // Of the shown drawings; 0: none.
  int patchLayers() const { return patchLayers_; }
  int pathLayers() const { return pathLayers_; }
  const std::shared_ptr<const timeline::Clock>& clock() const { return clock_; }
  const std::shared_ptr<const LayerFacts>& facts() const { return facts_; }
  // Null: not known yet.
  const std::shared_ptr<const ShownStatistics>& statistics() const { return statistics_; }
  // Returns the waypoints of a layer in print order, as counted by moves.
  const std::vector<std::uint32_t>& waypointsOf(int layer) const;
  bool busy() const;

signals:
  void layersDrawn();
  void pathsDrawn();
  void motionReady();
  void factsReady();
  void statisticsReady();

private:
  void show(project::Stage stage);
  void drop(project::Stage stage);
  void drawLayers(const JobLayers& layers, const process::Process& process);
  void drawPaths(const std::shared_ptr<const plan::ToolPlan>& plan);
  void swapPaths(const std::shared_ptr<const scene::PathsDrawing>& drawing);
  // Returns the result with the motion of the shown paths, if it is for the chosen cell; a motion
  // does not apply to another robot. Null: there is none.
  std::shared_ptr<const pipeline::PlanResult> shownMotion() const;
  void followCell();
  void drawMotion();
  void gatherFacts();
  void measureKinds();

  document::Document& document_;
  viewer::Viewport& viewport_;
  std::unique_ptr<jobs::JobRunner> drawingLayers_, drawingPaths_, gathering_, measuring_;
  std::shared_ptr<const timeline::Clock> clock_;
  std::shared_ptr<const LayerFacts> facts_;
  std::shared_ptr<const ShownStatistics> statistics_;
  std::shared_ptr<const scene::PathsDrawing> paths_;
  // Last drawn, so that the same data are not drawn twice.
  JobLayers drawnLayers_;
  std::shared_ptr<const plan::ToolPlan> drawnPaths_;
  int patchLayers_ = 0, pathLayers_ = 0;
};

} // namespace voluta::window
