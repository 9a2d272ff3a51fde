// Jogging on the Simulate page: the arm in the view follows the panel, not the time-line.
#pragma once

#include "window/pages/jogged_arm.h"
#include "window/pages/page.h"

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

namespace voluta::panels {
class JogPanel;
struct JogState;
} // namespace voluta::panels
namespace voluta::jobs {
class JobRunner;
}

namespace voluta::window {

class Jogging : public QObject {
  Q_OBJECT

public:
  // `workspace` as of a page; `parent` owns the panel.
  Jogging(const Workspace& workspace, QWidget* parent);
  ~Jogging() override;

  panels::JogPanel* panel() { return panel_; }
  // Begins where the time-line is. Returns false if there is no motion of the chosen cell.
  bool start();
  void end();
  bool isOn() const { return arm_ != nullptr; }
  void retranslate();
  // Precondition of the following: isOn().
  const robot::JointVector& joints() const { return arm_->joints(); }
  const JoggedArm& arm() const { return *arm_; }

signals:
  void moved(); // the arm, by the user
  void ended();

private:
  void take(bool reached);
  void show();
  // Checks the pose shown, after the check in progress.
  void check();
  void say(panels::JogState& state) const;
  void readPart(const std::shared_ptr<const pipeline::PlanResult>& plan);

  const Workspace& work_;
  panels::JogPanel* panel_;
  std::unique_ptr<jobs::JobRunner> reading_, checking_;
  QTimer slowly_; // until a check is mentioned
  std::unique_ptr<JoggedArm> arm_;
  std::optional<JoggedArm::Check> checked_; // of the last pose that was; none: not yet
  bool againWanted_ = false;
  bool reached_ = true; // by the last wish
};

} // namespace voluta::window
