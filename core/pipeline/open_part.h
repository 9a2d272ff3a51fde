// The parameter `openSurfaces`: handling of parts that do not enclose a volume.
#pragma once

#include "base/parameters.h"
#include "base/run_context.h"
#include "geometry/triangle_mesh.h"
#include "plan/finding.h"
#include "process/process.h"
#include "project/choices.h"
#include "project/loaded_part.h"

#include <Eigen/Geometry>
#include <memory>
#include <string>
#include <vector>

namespace voluta::pipeline {

inline constexpr const char* kRefuseOpenSurfaces = "refuse";

base::ParameterTable openSurfaceParameters();

// Wall thickness to which open surfaces are thickened: two bead widths [mm].
double openSurfaceWallMm(const process::Process& process);
// Returns whether the part is a surface that becomes a wall of one bead.
bool isPrintedAsWall(const project::LoadedPart& loaded, const base::ParameterValues& values);
// Cache key: all inputs that determine the mesh of an open part, other than the placement that a
// search finds. Empty by default.
std::string openSurfacesKey(const project::Choices& choices, const base::ParameterValues& values,
                            const process::Process& process);

// Prepares the mesh for planning. A part that encloses a volume is left unchanged.
class OpenPart {
public:
  // `loaded` must outlive the object. `levelLayers`: all layers will be horizontal.
  OpenPart(const project::LoadedPart& loaded, const base::ParameterValues& values,
           const process::Process& process, bool levelLayers);

  // Returns the mesh in the units of the part's file; `scale` is millimetres per unit, and
  // `rotation` that of the placement. Throws Error{UnusableInput} if it cannot be closed or
  // thickened; Cancelled.
  std::shared_ptr<const geometry::TriangleMesh>
  mesh(double scale, const Eigen::Quaterniond& rotation, const base::RunContext& ctx);
  // Returns the finding that the part is open (blocking), or how it was closed or thickened and
  // which defects the mesh returned last still has.
  plan::Findings findings() const;
  // Repairs made for the last mesh, one sentence each.
  const std::vector<base::Message>& repairs() const { return repairs_; }

private:
  void make(const base::RunContext& ctx);
  plan::Findings doneFindings() const;

  const project::LoadedPart& loaded_;
  std::string choice_;
  double wallMm_, beadMm_, layerHeightMm_;             // layerHeightMm_: 0 if layers are not level
  std::shared_ptr<const geometry::TriangleMesh> mesh_; // the last result of mesh()
  // for which mesh_ was thickened
  double scale_ = 0.0;
  Eigen::Vector3d up_ = Eigen::Vector3d::UnitZ(); // normal of the plate in the part's frame
  std::vector<base::Message> repairs_, remains_;  // of mesh_
};

} // namespace voluta::pipeline
