// Tool-paths of 3 and 6 axes out of a 3MF package with the Toolpath Extension 1.0, whoever made it.
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
  // In the model's build coordinates, mm. A width, height or speed of 0: the profile does not give
  // one. Paths are segments, in the order of the file; layers are its layer parts, counted from 0,
  // or what a file of our own says.
  plan::ToolPlan plan;
  bool hasObject = false;           // the model builds one, for geometry::readMesh
  bool workFrame = false;           // a file of our own: coordinates are the work frame's
  std::vector<base::Message> notes; // what was left out or read in one way of two, a sentence each
};

// Does the package's model have tool-paths of the extension? False also for what is no 3MF package.
bool holdsToolpaths(std::string_view bytes);

// - "polyline3d": the nozzle stands along z. "polyline6d": along z of the point's frame, out of the
//   bead; where the frames of all points look into what is printed, they are turned over, and told.
// - Values follow the profile and its modifiers on beadwidth, beadheight and depositionspeed, of
//   every type. A section that changes in a step does so within 0.1 mm behind the point.
// - Waits of profiles are left out, and told.
// Throws Error{UnreadableFile} with where it stands: no 3MF, damaged, not as the extension says
// (a part, profile or layer that is not there or not related, a number that is none, a frame
// without direction, a point's factor outside 0..1), a unit or a required extension that is not
// known, a modifier of what cannot be modified here, part names that leave the package.
// Throws Error{UnusableInput}: planar tool-paths without beads, none at all, too many points to be
// read. Throws Cancelled. `name`: of the file, for errors.
ReadBuild readBuild(std::string_view bytes, const std::string& name, const base::RunContext& ctx);

} // namespace voluta::build3mf
