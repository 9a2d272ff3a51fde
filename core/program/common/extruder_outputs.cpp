#include "program/common/extruder_outputs.h"

#include "program/common/program_text.h"

#include <algorithm>
#include <utility>

namespace voluta::program {

std::pair<double, double> pushedOut(double mm3, double drawnMm3) {
  const double left = drawnMm3 - mm3;
  return {std::max(0.0, -left), std::max(0.0, left)};
}

std::string shareText(double share) {
  share = std::clamp(share, 0.0, 1.0);
  std::string text;
  appendFixed(text, share, decimalsFor(share, 4), true);
  return text;
}

double writtenShare(double share) {
  share = std::clamp(share, 0.0, 1.0);
  return roundedTo(share, decimalsFor(share, 4));
}

void WrittenOutputs::off() {
  on_ = false;
  flowText_.clear();
}

std::optional<std::string> WrittenOutputs::flow(double mm3PerS) {
  std::string text = shareText(mm3PerS / full_);
  if (text == flowText_)
    return std::nullopt;
  flowText_ = std::move(text);
  return flowText_;
}

bool WrittenOutputs::setExtruder(bool on) {
  return std::exchange(on_, on) != on;
}

void ReadOutputs::setExtruder(bool on) {
  on_ = on;
  offSaid_ = !on;
}

void ReadOutputs::flow(double share) {
  flow_ = share;
  zeroSaid_ = share == 0.0;
}

bool ReadOutputs::moveWith(plan::ProgramMotion& motion, double fullFlowMm3PerS) {
  const bool known = on_ && flow_;
  on_ = on_.value_or(false);
  flow_ = flow_.value_or(0.0);
  motion.extruding = *on_;
  motion.flowMm3PerS = *on_ ? *flow_ * fullFlowMm3PerS : 0.0;
  offSaid_ = zeroSaid_ = false;
  return known;
}

} // namespace voluta::program
