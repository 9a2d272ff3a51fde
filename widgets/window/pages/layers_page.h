// Layers: voxels, pieces, layers and tool-paths, by layer, by move and by step of growth.
#pragma once

#include "window/pages/page.h"
#include "window/pages/piece_cuts.h"
#include "window/view_options.h"

#include <array>
#include <memory>

namespace voluta::panels {
class LayerInfo;
}

namespace voluta::window {

struct LayerFacts;
class SpacingView;

class LayersPage : public Page, public ViewportInput {
  Q_OBJECT

public:
  explicit LayersPage(const Workspace& workspace);

  QWidget* side() override { return side_; }
  PageLayout layout() const override { return {true, timeline::BarMode::Moves}; }
  std::vector<project::Stage> stages() const override;
  std::vector<ViewportInput*> inputs() override { return {this, &pieces_}; }

  void draw(scene::ViewState& view) override;
  void drawn() override { pieces_.showHandles(); }
  std::optional<Laid> laid() const override;
  void goToWaypoint(const plan::ToolPath& path, std::size_t waypoint) override;
  int interest(const plan::Finding&) const override { return 1; }
  bool goTo(const plan::Finding& finding) override;

  void clicked(const std::optional<scene::Hit>& hit) override;
  void hovered(const std::optional<scene::Hit>& hit) override;

protected:
  void entered() override;
  void left() override;

private:
  void build();
  void listenToBars();
  void listenToDrawings();
  LayerSubject subject() const; // never Furthest
  void choose(LayerSubject subject);
  void lookElsewhere();
  // Layers of what is on show.
  int layerCount() const;
  // Of the layers on show; null: of others, or nothing is known.
  std::shared_ptr<const LayerFacts> facts() const;
  bool replaysGrowth() const;
  void showGrowth(LayerSubject subject);
  void showCount();
  void showMoves();
  void showMeasures(int layer);
  bool lookAtMissed(const plan::Finding& finding);

  PieceCuts pieces_;
  ViewOptions* options_;
  panels::LayerInfo* info_;
  SpacingView* spacing_;
  QWidget* side_;
  std::array<bool, 3> newest_{}; // of what is on show: decides what the viewport shows
  bool lookingAtMissed_ = false; // until something else is asked for
};

} // namespace voluta::window
