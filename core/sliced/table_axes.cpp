#include "sliced/table_axes.h"

#include "base/units.h"
#include "program/common/program_text.h"
#include "program/gcode/gcode_bc.h"

#include <cmath>

namespace voluta::sliced {

void TableAxes::note(std::string_view comment) {
  const std::string_view text = program::trimmed(comment);
  if (text == program::kReversedNote)
    sense_ = -1.0;
  if (!text.starts_with(program::kTableNote))
    return;
  const auto taken = [](std::string_view& rest, char letter, double& value) {
    rest = program::trimmed(rest);
    if (rest.empty() || rest.front() != letter)
      return false;
    rest.remove_prefix(1);
    return program::takeNumber(rest, value) && std::isfinite(value);
  };
  std::string_view rest = text.substr(program::kTableNote.size());
  double x = 0.0, z = 0.0;
  if (taken(rest, 'X', x) && taken(rest, 'Z', z))
    frame_ = {x, z};
}

void TableAxes::take(program::GcodeWords& words) {
  isUsed_ = isUsed_ || words.any("BC");
  if (words['B'])
    angles_.tilt = sense_ * base::degreesToRadians(*words['B']);
  if (words['C'])
    angles_.rotation = sense_ * base::degreesToRadians(*words['C'] + countedDeg_);
}

void TableAxes::setCount(double rotationDeg) {
  countedDeg_ = base::radiansToDegrees(sense_ * angles_.rotation) - rotationDeg;
}

plan::NozzlePoint TableAxes::nozzleAt(const program::TablePose& pose) const {
  return program::nozzleAt(frame_, pose);
}

std::vector<plan::NozzlePoint> TableAxes::path(const program::TablePose& from,
                                               const program::TablePose& to) const {
  return program::pathOnPart(frame_, from, to);
}

} // namespace voluta::sliced
