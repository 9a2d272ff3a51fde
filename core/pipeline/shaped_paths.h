// Parts whose own tool-paths are changed by parameters (path_parameters.h), and the body below
// them.
#pragma once

#include "base/run_context.h"
#include "geometry/placement.h"
#include "geometry/triangle_mesh.h"
#include "modes/mode_stages.h"
#include "project/loaded_part.h"

#include <memory>

namespace voluta::pipeline {

struct Resolved;

// A part with its tool-paths, and the body that carries them; null: printed on the platform.
struct ShapedPart {
  std::shared_ptr<const project::LoadedPart> part;
  std::shared_ptr<const geometry::TriangleMesh> ground; // In the coordinates of the part's mesh
};

// Returns the part as the parameters change it: itself if it has no tool-paths in use, or nothing
// changes. A platform that is a body replaces the ground made here. Throws Error{Usage} for an
// invalid frame; Error{UnusableInput} as sliced::shaped(); Cancelled.
ShapedPart shapedPart(std::shared_ptr<const project::LoadedPart> loaded, const Resolved& resolved,
                      const base::RunContext& ctx);

// Returns the load stage of a part with a ground: the body is placed by the choices' placement,
// with its lowest point at the lift, and the part with it. A plate of the cell, or one made for the
// part, carries the body. Precondition: there is a body. Throws as loadStage().
std::shared_ptr<const modes::LoadStage>
loadStageOnGround(const ShapedPart& shaped, const Resolved& resolved, const base::RunContext& ctx);
// Returns the body placed by `own`, in the work frame. Precondition: there is a body.
std::shared_ptr<const geometry::TriangleMesh> placedGround(const ShapedPart& shaped,
                                                           const geometry::Placement& own);

} // namespace voluta::pipeline
