// How long a run still takes, told so that the number does not jump about.
#pragma once

#include <optional>

namespace voluta::jobs {

// What is left of the work at the pace of the work that was really done, smoothed over some
// seconds; between reports it counts down. What comes at one stroke was kept from an earlier run
// and says nothing of the pace. Nothing in the first 2 s, nor before a hundredth of the work is
// done, nor while the run stands still for longer than it was to take: then nobody knows.
class TimeLeft {
public:
  // elapsedS: since the start of the run, not decreasing; fraction in [0, 1].
  std::optional<double> update(double elapsedS, double fraction);

private:
  std::optional<double> estimateS_;
  double lastS_ = 0.0, movedS_ = 0.0;
  double fraction_ = 0.0, atOneStroke_ = 0.0;
};

} // namespace voluta::jobs
