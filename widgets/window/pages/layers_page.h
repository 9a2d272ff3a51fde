// Layers page: voxels, pieces, layers and tool-paths, by layer, by move and by growth step.
#pragma once

#include "window/pages/page.h"
#include "window/pages/piece_cuts.h"
#include "window/view_options.h"

#include <array>
#include <memory>
#include <vector>

namespace voluta::panels {
class LayerInfo;
}
namespace voluta::plan {
struct ToolPlan;
}

class QPushButton;

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

  void retranslate() override;
  void draw(scene::ViewState& view) override;
  void drawn() override { pieces_.showHandles(); }
  std::optional<PrintProgress> printProgress() const override;
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
  // Returns the number of layers of the shown subject.
  int layerCount() const;
  // Returns the facts of the shown layers; null if they are of other layers or unknown.
  std::shared_ptr<const LayerFacts> facts() const;
  bool replaysGrowth() const;
  void showGrowth(LayerSubject subject);
  void showCount();
  void showPauses();
  void showMoves();
  void showMeasures(int layer);
  bool lookAtMissed(const plan::Finding& finding);

  PieceCuts pieces_;
  ViewOptions* options_;
  panels::LayerInfo* info_;
  QPushButton* addEvent_;
  SpacingView* spacing_;
  QWidget* side_;
  std::array<bool, 3> newest_{}; // availability of newer results: determines the shown view
  bool lookingAtMissed_ = false; // until the user looks at something else
};

} // namespace voluta::window
