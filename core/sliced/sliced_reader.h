// Reads the G-code of a slicer as tool-paths with the solid that they make.
#pragma once

#include "base/text.h"
#include "geometry/triangle_mesh.h"
#include "plan/tool_plan.h"

#include <string>
#include <string_view>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::sliced {

// A note that the beads and what is left out are not the material that the file's E words state.
// Values: stated, read [mm3], and the line where they part.
inline constexpr base::Text kAmountNote =
    "the file extrudes {stated:.0f} by its E words, its beads and what is left out have {read:.0f}; they part {line}"_text;

// A note that the print pauses at a stop of the file. Values: its line; the bead before which it
// comes, from 1; its layer, from 1; the text for the operator; the command.
inline constexpr base::Text kStopNote =
    "line {line}: the print pauses before bead {bead} in layer {layer}: {text} ({command})"_text;
// Returns whether the operator changes the filament at that command.
bool changesFilament(std::string_view command);

struct ReadSliced {
  plan::ToolPlan plan;              // In the file's coordinates [mm]; fill: of `solid`
  geometry::TriangleMesh solid;     // What the beads make; closed, facing outward
  double filamentMm = 0.0;          // Its diameter as used; 0: the file states volumes
  double volumeMm3 = 0.0;           // Of all beads in `plan`
  std::vector<base::Message> notes; // One sentence for each omission or assumption
};

// Throws Error{UnreadableFile, UnusableInput} with the line: as followGcode() and solidOfLayers();
// binary G-code; no extrusion. Throws Cancelled. `name`: of the file, for errors.
ReadSliced readSliced(std::string_view text, const std::string& name, const base::RunContext& ctx);

} // namespace voluta::sliced
