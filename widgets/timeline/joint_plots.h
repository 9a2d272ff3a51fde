// Angle, speed and jerk of every joint over time, with their limits, synchronized with the
// time-line.
#pragma once

#include "plan/trajectory.h"
#include "robot/cell.h"
#include "robot/robot_model.h"

#include <QWidget>
#include <memory>
#include <vector>

class QHBoxLayout;
class QToolButton;

namespace voluta::jobs {
class JobRunner;
}

namespace voluta::timeline {

class ChartCanvas;
class JointCurves;

enum class PlotKind { Angle, Speed, Both, Jerk };

// Curves are prepared on a worker and reduced to the minimum and maximum per pixel column; this is
// repeated only when the view is zoomed, moved or resized. The wheel zooms about the pointer,
// dragging moves the view, a double click shows everything; colours follow the palette.
class JointPlots : public QWidget {
  Q_OBJECT

public:
  explicit JointPlots(QWidget* parent = nullptr);
  ~JointPlots() override;

  // null: nothing to show. Limits: one per joint, or none. The last joints are the external axes,
  // shown by their names; one that turns endlessly is hidden at first because of its large angles.
  // Returns immediately; ready() follows. The jerk of the trajectory shown before remains as pale
  // curves (setEarlierShown) until there is none.
  void setTrajectory(std::shared_ptr<const plan::Trajectory> trajectory,
                     std::vector<robot::JointLimits> limits,
                     std::vector<robot::ExternalAxis> externalAxes = {});
  bool prepared() const { return static_cast<bool>(curves_); }

  void setKind(PlotKind kind);
  PlotKind kind() const { return kind_; }
  // Whether the plot of the jerk includes the trajectory shown before. Initially not.
  void setEarlierShown(bool shown);
  void setJointShown(int joint, bool shown);
  bool jointShown(int joint) const;
  // Visible time span in seconds, clamped to the trajectory.
  void setSpan(double fromS, double toS);
  double spanFromS() const { return fromS_; }
  double spanToS() const { return toS_; }

public slots:
  void setTimeS(double timeS);

signals:
  void timeClicked(double timeS);
  void ready();

protected:
  void changeEvent(QEvent* event) override;

private:
  void buildWidgets();
  void makeJointButtons();
  const robot::ExternalAxis* externalAxis(std::size_t joint) const;
  void colourJointButtons();
  void applyKind();
  void refresh();
  void refreshJerk();
  void retranslate();

  jobs::JobRunner* runner_;
  std::shared_ptr<const JointCurves> curves_, earlier_;
  std::vector<robot::JointLimits> limits_;
  std::vector<robot::ExternalAxis> externalAxes_;
  std::vector<bool> shown_;
  PlotKind kind_ = PlotKind::Both;
  double fromS_ = 0.0, toS_ = 0.0;
  ChartCanvas *angle_ = nullptr, *speed_ = nullptr, *jerk_ = nullptr;
  QHBoxLayout* jointRow_ = nullptr;
  std::vector<QToolButton*> jointButtons_, kindButtons_;
  QToolButton *limitsButton_ = nullptr, *earlierButton_ = nullptr;
};

} // namespace voluta::timeline
