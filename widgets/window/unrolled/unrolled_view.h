// The unrolled layer with its captions: the layer's name, and the item at the pointer.
#pragma once

#include "jobs/job_runner.h"
#include "layers/layer_stack.h"
#include "plan/tool_plan.h"
#include "window/unrolled/unrolled_layer.h"

#include <QWidget>
#include <memory>
#include <optional>

class QLabel;

namespace voluta::window {

class UnrolledCanvas;

// Layers are unrolled in the background on first use.
class UnrolledView : public QWidget {
  Q_OBJECT

public:
  explicit UnrolledView(QWidget* parent = nullptr);
  ~UnrolledView() override;

  // Of one plan; nullptr: none.
  void setPlan(std::shared_ptr<const layers::LayerStack> stack,
               std::shared_ptr<const plan::ToolPlan> plan);
  // Shows the layer with that index; waypoints of the plan before `printedEnd` are printed.
  // `title`: the layer's name.
  void showLayer(int layer, std::size_t printedEnd, const QString& title);
  // Highlights its path and marks its position.
  void choose(std::optional<std::size_t> waypoint);

  UnrolledCanvas& canvas() { return *canvas_; }
  // Returns whether the display is up to date.
  bool settled() const;

signals:
  // nullopt: beside all paths.
  void chosen(std::optional<std::size_t> waypoint);

protected:
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;

private:
  void prepare();
  void refresh();
  void showPlace(const std::optional<QPointF>& mm, const std::optional<UnrolledHit>& hit);
  void retranslate();

  jobs::JobRunner runner_;
  std::shared_ptr<const layers::LayerStack> stack_;
  std::shared_ptr<const plan::ToolPlan> plan_;
  std::shared_ptr<const UnrolledLayer> layer_;
  int wanted_ = -1, preparing_ = -1;
  std::size_t printedEnd_ = 0;
  std::optional<std::size_t> chosen_;
  QLabel *title_, *place_;
  UnrolledCanvas* canvas_;
};

} // namespace voluta::window
