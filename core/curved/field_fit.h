// Fits one field to several objectives: even thickness, the order of growth, good contact below.
#pragma once

#include "base/run_context.h"
#include "curved/grid_solver.h"
#include "curved/voxel_graph.h"

#include <Eigen/Core>
#include <vector>

namespace voluta::curved {

// Returns the gradient of a field per voxel, per cell: central differences inside, one-sided at the
// surface, 0 along an axis without neighbours. Below a voxel on the platform the field is 0 half a
// cell away.
std::vector<Eigen::Vector3f> fieldGradient(const VoxelGraph& graph, const std::vector<float>& field,
                                           const base::RunContext& ctx);

// Returns the outward unit normals of the part at voxels within two cells of its surface, from the
// gradient of the blurred solid; zero elsewhere. The solid is continued below the plate, so that
// the base has no downward normal.
std::vector<Eigen::Vector3f> surfaceNormals(const VoxelGraph& graph, const base::RunContext& ctx);

struct FitOptions {
  float slopeMin = 0.65f, slopeMax = 1.45f; // Target limits of |grad field|
  int steps = 8;                            // Local-global alternations
  float overhang = 0.68f; // Minimum dot product of build direction and outward normal is -overhang
};

// Minimizes  sum over faces (d_e field - T . e)^2 + sum screen (field - target)^2  with field = 0
// on the platform, alternating with T = unit(grad field) clamp(|grad field|), whose direction is
// lightly smoothed and, near downward surfaces, rotated onto the cone around the normal in which
// layers still meet the surface well (local-global as in Liu et al. 2008; docs/growth.md).
class FieldFit {
public:
  FieldFit(const VoxelGraph& graph, const base::RunContext& ctx);

  // Improves `field` (start value and result, one value per voxel, in cells).
  void fit(std::vector<float>& field, const std::vector<float>& target,
           const std::vector<float>& screen, const FitOptions& options,
           const base::RunContext& ctx);

  const std::vector<Eigen::Vector3f>& normals() const { return normals_; }

private:
  const VoxelGraph& graph_;
  GridSolver solver_;
  std::vector<Eigen::Vector3f> normals_;
};

} // namespace voluta::curved
