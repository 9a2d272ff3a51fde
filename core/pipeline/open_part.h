// The choice `openSurfaces`: what becomes of a part that encloses nothing.
#pragma once

#include "base/parameters.h"
#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "plan/finding.h"
#include "process/process.h"
#include "project/loaded_part.h"

#include <memory>
#include <string>
#include <vector>

namespace voluta::pipeline {

inline constexpr const char* kRefuseOpenSurfaces = "refuse";

base::ParameterTable openSurfaceParameters();

// Width of the wall that an open surface is thickened to, mm: two beads.
double openSurfaceWallMm(const process::Process& process);
// What decides about the mesh of an open part, as text; empty where it is refused.
std::string openSurfacesKey(const base::ParameterValues& values, const process::Process& process);

// The part as it is planned: a part that encloses a volume stays as it is.
class OpenPart {
public:
  // All three outlive this.
  OpenPart(const project::LoadedPart& loaded, const base::ParameterValues& values,
           const process::Process& process);

  // In the units of the part's file; `scale`: mm of one of them. Throws Error{UnusableInput}: it
  // cannot be closed or thickened. Throws Cancelled.
  std::shared_ptr<const geometry::TriangleMesh> mesh(double scale, const base::RunContext& ctx);
  // That the part is open, which blocks, or what was done about it and which defects the mesh that
  // was made last still has.
  plan::Findings findings() const;
  // What was mended to make it, a sentence each.
  const std::vector<base::Message>& repairs() const { return repairs_; }

private:
  void make(double scale, const base::RunContext& ctx);
  plan::Findings doneFindings() const;

  const project::LoadedPart& loaded_;
  std::string choice_;
  double wallMm_;
  std::shared_ptr<const geometry::TriangleMesh> mesh_; // made last
  double scale_ = 0.0;                                 // for which it was thickened
  std::vector<base::Message> repairs_, remains_;       // of it
};

} // namespace voluta::pipeline
