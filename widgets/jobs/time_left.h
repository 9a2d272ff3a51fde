// How long a run still takes, told so that the number does not jump about.
#pragma once

#include <deque>
#include <optional>

namespace voluta::jobs {

// What is left of the work at the pace of the work that was really done, smoothed over some
// seconds; between reports it counts down. What comes at one stroke was kept from an earlier run
// and says nothing of the pace. Returns nothing where the time is not known within a factor of two:
// in the first 2 s, before a hundredth of the work is done, while the run stands still for longer
// than it was to take, and where the pace of the whole run, the pace of its last quarter and the
// estimates made in its last half differ by more. In this comparison a second is left at least.
class TimeLeft {
public:
  // elapsedS: since the start of the run, not decreasing; fraction in [0, 1].
  std::optional<double> update(double elapsedS, double fraction);

private:
  struct Estimate {
    double atS, worked; // when it was made, and what was done by then
    double endS;        // when the run was to end
  };
  // Notes an estimate by the pace of the whole run. Returns one by both paces where they and the
  // earlier ones agree.
  std::optional<double> agreed(double elapsedS, double worked, double leftS, double left);

  std::deque<Estimate> estimates_; // of the last half of the run
  std::optional<double> estimateS_;
  double lastS_ = 0.0, movedS_ = 0.0;
  double fraction_ = 0.0, atOneStroke_ = 0.0;
};

} // namespace voluta::jobs
