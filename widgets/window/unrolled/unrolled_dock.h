// The unrolled layer next to the viewport, and the path selected in both.
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

inline constexpr std::size_t kAllPrinted = std::numeric_limits<std::size_t>::max();
// Progress of the print in the picture: the shown layer, and the first waypoint that is not printed
// yet.
struct PrintProgress {
  int layer = 0;
  std::size_t end = kAllPrinted;
};

// Returns the plan whose paths belong to the shown layers; nullptr if its paths were made from
// other layers.
std::shared_ptr<const plan::ToolPlan> planOfLayers(const document::Document& document);

class UnrolledDock : public QDockWidget {
  Q_OBJECT

public:
  // The arguments must outlive this object. The slider provides the layers' names.
  UnrolledDock(const document::Document& document, const Presenter& presenter,
               const timeline::LayerRangeSlider& layers, QWidget* parent);

  // Whether the user wants the dock; stored in the settings. If closed by its own button, it stays
  // closed until requested again.
  bool wanted() const { return wanted_; }
  void setWanted(bool wanted);
  // Returns whether the shown layers can be unrolled.
  bool offered() const;

  // nullopt: the current page has no layers to unroll. Shows or hides the dock.
  void showProgress(const std::optional<PrintProgress>& printProgress);
  // Highlights the waypoint's path in both views; nullopt: no path.
  void choose(std::optional<std::size_t> waypoint);
  // Marks the path in the view that shows paths.
  void mark(scene::ViewState& view) const;
  void retranslate();

signals:
  void chosen(std::optional<std::size_t> waypoint);
  void wantedChanged(); // By its own button
  void firstShown();    // Its share of the column is not set yet

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
