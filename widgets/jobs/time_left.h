// Estimates the remaining time of a run, so that the displayed number does not jump.
#pragma once

#include <deque>
#include <optional>

namespace voluta::jobs {

// The remaining work at the pace of the work actually done, smoothed over some seconds; it counts
// down between reports. Jumps of progress come from results of an earlier run and are ignored for
// the pace. Returns nullopt if the time is not known within a factor of two: in the first 2 s,
// before a hundredth of the work is done, while the run makes no progress for longer than its
// estimated rest, and if the pace of the whole run, the pace of its last quarter and the estimates
// made in its last half differ by more. For this comparison at least one second is assumed to
// remain.
class TimeLeft {
public:
  // elapsedS: since the start of the run, not decreasing; fraction in [0, 1].
  std::optional<double> update(double elapsedS, double fraction);

private:
  struct Estimate {
    double atS, worked; // Time of the estimate, and the work done by then
    double endS;        // Estimated end of the run
  };
  // Stores an estimate by the pace of the whole run. Returns an estimate by both paces if they and
  // the earlier ones agree.
  std::optional<double> agreed(double elapsedS, double worked, double leftS, double left);

  std::deque<Estimate> estimates_; // Of the last half of the run
  std::optional<double> estimateS_;
  double lastS_ = 0.0, movedS_ = 0.0;
  double fraction_ = 0.0, atOneStroke_ = 0.0;
};

} // namespace voluta::jobs
