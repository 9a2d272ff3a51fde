// Simulate page: the robot's motion with synchronized joint plots.
#pragma once

#include "panels/text_lines.h"
#include "pipeline/plan_result.h"
#include "record/run_comparison.h"
#include "window/pages/page.h"
#include "window/pages/tip_trace.h"

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;

namespace voluta::jobs {
class JobRunner;
}
namespace voluta::panels {
class CursorInfo;
class ResumeBar;
} // namespace voluta::panels
namespace voluta::timeline {
class JointPlots;
}

namespace voluta::window {

class Jogging;
class ProgramPreview;

class SimulatePage : public Page, public ViewportInput {
  Q_OBJECT

public:
  explicit SimulatePage(const Workspace& workspace);
  ~SimulatePage() override;

  QWidget* side() override { return side_; }
  PageLayout layout() const override { return {false, timeline::BarMode::Time, true}; }
  std::vector<Command> commands() override;
  std::vector<ViewportInput*> inputs() override { return {this}; }
  std::vector<project::Stage> stages() const override { return {project::Stage::Motion}; }

  void entered() override;
  void retranslate() override;
  void draw(scene::ViewState& view) override;
  std::optional<PrintProgress> printProgress() const override;
  void goToWaypoint(const plan::ToolPath& path, std::size_t waypoint) override;
  int interest(const plan::Finding& finding) const override;
  bool goTo(const plan::Finding& finding) override;

  void clicked(const std::optional<scene::Hit>& hit) override;

protected:
  void left() override;
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  // A trace of the tip, and all of it as lines.
  struct Traced {
    TipTrace trace;
    std::vector<scene::LineGroup> whole;
  };

  void build();
  void listen();
  void jog(bool on);
  void prepareTrace();
  void showTrace();
  void showMotion();
  // Returns the plan that a recorded run can be compared with and other machines can join; null:
  // none.
  std::shared_ptr<const pipeline::PlanResult> comparable() const;
  void compareRun();
  void printTogether();
  void showRunPlaces();
  void showEvents();
  // The layer at the time-line's position, from 0; negative: there is none.
  int layerShown() const;
  void openTimeMenu(double timeS, const QPoint& global);
  void goToPoint(std::size_t point);
  // Returns the start of the bead at the time-line's position; none if the print cannot be resumed
  // there.
  std::optional<std::size_t> resumePoint() const;
  void showResume();
  void resume();
  void goToTimeOf(std::size_t waypoint);
  void showProgram();
  void showCursor();
  void followNozzle();
  QString programLine(std::size_t& number) const;

  timeline::JointPlots* plots_;
  QCheckBox* solids_; // over the arm
  QCheckBox* follow_; // the nozzle, by the camera
  QCheckBox* kinds_;  // in their colours, with their statistics
  QCheckBox* jog_;
  QLabel* traceName_;
  QComboBox* traces_; // of the nozzle's tip
  panels::CursorInfo* cursor_;
  ProgramPreview* lines_;
  QWidget *plotsArea_ = nullptr, *jogArea_ = nullptr;
  std::unique_ptr<Jogging> jogging_;
  std::unique_ptr<jobs::JobRunner> tracing_;
  std::shared_ptr<const timeline::Clock> tracedClock_; // of traced_, or of the one in progress
  std::shared_ptr<const Traced> traced_;               // null: not known yet
  std::vector<panels::TextLines> texts_;               // of the program's files
  panels::ResumeBar* resume_;
  QPushButton* addEvent_;
  std::vector<record::ErrorPlace> runPlaces_; // of the run compared last with this motion
  QWidget* side_;
};

} // namespace voluta::window
