#include "program/gcode/extruder_axis.h"

#include "base/error.h"
#include "program/common/motion_targets.h"
#include "program/common/program_text.h"
#include "program/filament.h"

#include <algorithm>

namespace voluta::program {

base::ParameterSpec extruderAxisMm() {
  return base::numberParameter(
      "extruderAxisMm", "mm", 10000.0, 20.0, 1e6, "Programs"_text, "extruder axis: range"_text,
      "Maximum filament length that the external axis feeds before it is reset "
      "to 0."_text);
}

AxisCount axisCount(const ProgramInput& input) {
  const plan::Trajectory& t = input.trajectory;
  const double limit = numberOf(extruderAxisMm(), input.options) * filamentArea();
  // The prime or purge before the first bead, and the retraction within the range.
  double spare =
      (primesStanding(input) ? process::primeFlow(input.process()) : 0.0) * input.process().primeS +
      input.process().retractMm * filamentArea();
  for (const plan::TrajectoryEvent& event : t.events)
    if (event.kind == plan::EventKind::Purge)
      spare += event.volumeMm3;
  AxisCount count{{0}};
  std::size_t lifted = 0; // the last point at which the axis may be reset
  for (std::size_t i = 1; i < t.pointCount(); ++i) {
    if (standsClear(t, i))
      lifted = i;
    const auto extrudedSince = [&](std::size_t point) {
      return t.extrudedMm3[i] - t.extrudedMm3[point == 0 ? 0 : point - 1] + spare;
    };
    if (extrudedSince(count.zeros.back()) > limit)
      count.zeros.push_back(lifted);
    count.maxMm = std::max(count.maxMm, extrudedSince(count.zeros.back()) / filamentArea());
    if (extrudedSince(count.zeros.back()) > limit)
      throw base::Error(
          base::ErrorCode::Usage,
          base::message("more than {length:.0f} of filament is needed between two lifts: beyond "
                        "the extruder axis' range"_text,
                        base::mm(limit / filamentArea())),
          {}, base::message("increase {option}"_text, "extruderAxisMm"_name));
  }
  return count;
}

std::string axisNote(std::string_view axis, const AxisCount& count) {
  return joined({"extruder: ", axis, ", linear, mm of filament, which goes with each motion; ",
                 kDiameterNote, fixedText(kFilamentDiameterMm, 3),
                 " mm; set to 0 at the start, it "
                 "goes to ",
                 fixedText(count.maxMm, 1), " mm"});
}

} // namespace voluta::program
