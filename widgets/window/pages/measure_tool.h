// Measures the part at clicked places: the corner, edge or face there, its radius and the wall
// behind it; of two places distance and angle. The figures stand on a card in the viewport.
#pragma once

#include "geometry/measuring.h"
#include "jobs/job_runner.h"
#include "window/pages/page.h"

#include <QObject>
#include <QStringList>
#include <memory>
#include <vector>

class QLabel;

namespace voluta::window {

class MeasureTool : public QObject, public ViewportInput {
  Q_OBJECT

public:
  // All must outlive this.
  MeasureTool(const Workspace& workspace, const Page& page, QObject* parent);

  std::vector<Command> commands();
  void retranslate() { show(); }
  // A third place begins anew.
  void clicked(const std::optional<scene::Hit>& hit) override;

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  using Mesh = std::shared_ptr<const geometry::TriangleMesh>;
  struct Found {
    std::shared_ptr<const geometry::Measuring> of;
    geometry::MeasuredPoint point;
  };

  bool isOn() const { return work_.viewport.tool() == viewer::Tool::Measure; }
  // Returns the active part in its place; null while it is placed.
  Mesh placedPart() const;
  void forget();
  void forgetIfMoved();
  void show();
  void keepToItsPlace();
  QStringList lines() const;

  const Workspace work_;
  const Page& page_;
  QLabel* card_;
  jobs::JobRunner runner_;
  Mesh part_; // of measuring_ and places_
  std::shared_ptr<const geometry::Measuring> measuring_;
  std::vector<geometry::MeasuredPoint> places_; // two at most
};

} // namespace voluta::window
