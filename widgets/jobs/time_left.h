// How long a run still takes, told so that the number does not jump about.
#pragma once

#include <optional>

namespace voluta::jobs {

// The estimate elapsed * (1 - fraction) / fraction, smoothed over some seconds; between reports it
// counts down. Nothing in the first 2 s, nor before a hundredth of the work is done.
class TimeLeft {
public:
  // elapsedS: since the start of the run, not decreasing; fraction in [0, 1].
  std::optional<double> update(double elapsedS, double fraction);

private:
  std::optional<double> estimateS_;
  double lastS_ = 0.0;
};

} // namespace voluta::jobs
