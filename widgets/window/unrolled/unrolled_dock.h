// The unrolled layer beside the viewport, and the path that is chosen in both.
#pragma once

#include "plan/tool_plan.h"

#include <QDockWidget>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>

namespace voluta::document {
class Document;
}
namespace voluta::scene {
struct ViewState;
}
namespace voluta::timeline {
class LayerRangeSlider;
}

namespace voluta::window {

class Presenter;
class UnrolledView;

inline constexpr std::size_t kAllLaid = std::numeric_limits<std::size_t>::max();
// How far the print has come in the picture: the layer on show, the first waypoint not laid yet.
struct Laid {
  int layer = 0;
  std::size_t end = kAllLaid;
};

// Which paths the layers on show have: none that were made from other layers.
std::shared_ptr<const plan::ToolPlan> planOfLayers(const document::Document& document);

class UnrolledDock : public QDockWidget {
  Q_OBJECT

public:
  // All outlive this. The slider knows what a layer is called.
  UnrolledDock(const document::Document& document, const Presenter& presenter,
               const timeline::LayerRangeSlider& layers, QWidget* parent);

  // The user's wish, kept in the settings; closed by its own button it stays closed until it is
  // asked for again.
  bool wanted() const { return wanted_; }
  void setWanted(bool wanted);
  // Layers on show can be laid flat.
  bool offered() const;

  // none: the page on show has no layers to lay flat. Shows or hides the dock.
  void showLaid(const std::optional<Laid>& laid);
  // Its path stands out in both views; none: no path.
  void choose(std::optional<std::size_t> waypoint);
  // Into the picture that shows paths.
  void mark(scene::ViewState& view) const;
  void retranslate();

signals:
  void chosen(std::optional<std::size_t> waypoint);
  void wantedChanged(); // by its own button
  void firstShown();    // it has no share of the column yet

protected:
  void closeEvent(QCloseEvent* event) override;

private:
  const document::Document& document_;
  const Presenter& presenter_;
  const timeline::LayerRangeSlider& layers_;
  UnrolledView* view_;
  std::optional<std::size_t> chosen_;
  bool wanted_, sized_ = false;
};

} // namespace voluta::window
