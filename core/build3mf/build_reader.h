// Reads 3- and 6-axis tool-paths from a 3MF package with the Toolpath Extension 1.0, from any
// maker.
#pragma once

#include "base/text.h"
#include "plan/tool_plan.h"

#include <string>
#include <string_view>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::build3mf {

struct ReadBuild {
  // In the model's build coordinates [mm]. A width, height or speed of 0: not given by the profile.
  // Paths are segments, in the order of the file; layers are its layer parts, counted from 0, or as
  // stated in a file written by Voluta.
  plan::ToolPlan plan;
  bool hasObject = false;           // The model builds one, for geometry::readMesh
  bool workFrame = false;           // A file written by Voluta: coordinates are in the work frame
  std::vector<base::Message> notes; // One sentence for each omission or ambiguity
};

// Returns whether the package's model has tool-paths of the extension; also false if it is no 3MF
// package.
bool holdsToolpaths(std::string_view bytes);

// - "polyline3d": the nozzle is along z. "polyline6d": along z of the point's frame, out of the
//   bead; if the frames of all points point into the printed part, they are reversed, which is
//   reported in notes.
// - Values follow the profile and its modifiers of beadwidth, beadheight and depositionspeed, of
//   every type. A stepwise change of section is spread over 0.1 mm after the point.
// - Waits of profiles are left out and reported.
//
// Throws Error{UnreadableFile} with the position: not a 3MF package, damaged, or violating the
// extension (a part, profile or layer that is missing or not related, an invalid number, a frame
// without direction, a point's factor outside 0..1), an unknown unit or required extension, a
// modifier of a property that cannot be modified, part names that leave the package. Throws
// Error{UnusableInput} for planar tool-paths without beads, no tool-paths, or too many points.
// Throws Cancelled. `name`: of the file, for errors.
ReadBuild readBuild(std::string_view bytes, const std::string& name, const base::RunContext& ctx);

} // namespace voluta::build3mf
