#include "elastic/load_case.h"

#include "base/error.h"
#include "geometry/measures.h"
#include "voxel/column_parity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace voluta::elastic {

namespace {
using Eigen::Vector3d;
using geometry::TriangleMesh;

constexpr int kFiner = 5; // cells whose centres are tested, along each side of a cell

voxel::VoxelGrid gridAround(const TriangleMesh& part, std::size_t cells) {
  const Eigen::AlignedBox3d box = geometry::bounds(part);
  voxel::VoxelGrid grid;
  const double volume = std::abs(geometry::volume(part));
  if (!(volume > 0.0))
    throw base::Error(base::ErrorCode::UnusableInput, "the part has no volume to be loaded"_text);
  // Of a frame of thin rods, most cells of its box are empty.
  constexpr double kMostOfBox = 500'000.0;
  grid.pitch =
      std::cbrt(std::max(volume / static_cast<double>(cells), box.sizes().prod() / kMostOfBox));
  const Vector3d count = (box.sizes() / grid.pitch).array().round().max(1.0);
  // The part fills its cells along its longest side, and lies in the middle of the others.
  Eigen::Index longest = 0;
  box.sizes().maxCoeff(&longest);
  grid.pitch = box.sizes()[longest] / count[longest];
  grid.size = (box.sizes() / grid.pitch - Vector3d::Constant(1e-6))
                  .array()
                  .ceil()
                  .max(1.0)
                  .matrix()
                  .cast<int>();
  grid.origin = box.center() - 0.5 * grid.pitch * grid.size.cast<double>();
  return grid;
}

// Returns the share of each cell within a closed mesh.
std::vector<float> shares(const TriangleMesh& mesh, const voxel::VoxelGrid& grid,
                          const base::RunContext& ctx) {
  voxel::VoxelGrid fine = grid;
  fine.pitch /= kFiner;
  fine.size *= kFiner;
  std::vector<std::uint8_t> solid(fine.cellCount(), 0);
  voxel::fillClosed(mesh, fine, solid, ctx);
  std::vector<float> share(grid.cellCount(), 0.0F);
  for (std::size_t c = 0; c < solid.size(); ++c)
    if (solid[c]) {
      const Eigen::Vector3i at = fine.cell(c) / kFiner;
      share[grid.index(at.x(), at.y(), at.z())] += 1.0F / (kFiner * kFiner * kFiner);
    }
  return share;
}

// Returns the part's cells that are at least half within a body. If there are none, the body is
// thin: returns those that it meets.
std::vector<std::size_t> cellsWithin(const LoadCase& load, const TriangleMesh& body,
                                     const base::RunContext& ctx) {
  const std::vector<float> inBody = shares(body, load.grid, ctx);
  std::vector<std::size_t> half, any;
  for (std::size_t c = 0; c < inBody.size(); ++c)
    if (inBody[c] > 0.0F && load.isSolid(c)) {
      any.push_back(c);
      if (inBody[c] >= 0.5F)
        half.push_back(c);
    }
  return half.empty() ? any : half;
}

// Removes the cells that no held cell carries.
void keepHeld(LoadCase& load) {
  constexpr std::array<std::array<int, 3>, 6> kSides{
      {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}};
  std::vector<char> isCarried(load.share.size(), 0);
  std::vector<std::size_t> open = load.held;
  for (const std::size_t c : open)
    isCarried[c] = 1;
  while (!open.empty()) {
    const Eigen::Vector3i cell = load.grid.cell(open.back());
    open.pop_back();
    for (const auto& [i, j, k] : kSides) {
      const Eigen::Vector3i beside = cell + Eigen::Vector3i(i, j, k);
      if (!load.grid.contains(beside.x(), beside.y(), beside.z()))
        continue;
      const std::size_t index = load.grid.index(beside.x(), beside.y(), beside.z());
      if (load.isSolid(index) && !isCarried[index]) {
        isCarried[index] = 1;
        open.push_back(index);
      }
    }
  }
  for (std::size_t c = 0; c < isCarried.size(); ++c)
    if (!isCarried[c])
      load.share[c] = 0.0F;
}
} // namespace

LoadCase loadCase(const TriangleMesh& part, std::span<const TriangleMesh> holds,
                  std::span<const BodyForce> forces, std::size_t cells,
                  const base::RunContext& ctx) {
  LoadCase load;
  load.grid = gridAround(part, cells);
  load.share = shares(part, load.grid, ctx);
  for (const TriangleMesh& hold : holds)
    std::ranges::copy(cellsWithin(load, hold, ctx), std::back_inserter(load.held));
  std::ranges::sort(load.held);
  const auto [from, to] = std::ranges::unique(load.held);
  load.held.erase(from, to);
  if (load.held.empty())
    throw base::Error(base::ErrorCode::Usage,
                      "nothing of the part is within the regions that hold it"_text, {},
                      "move them onto the part, or make them larger"_text);
  keepHeld(load);
  for (const BodyForce& force : forces) {
    std::vector<std::size_t> within = cellsWithin(load, force.body, ctx);
    if (within.empty())
      throw base::Error(base::ErrorCode::Usage,
                        "a region with a force contains nothing of the part that is held"_text, {},
                        "move it onto the part, or make it larger"_text);
    load.forces.push_back({std::move(within), force.newton});
  }
  return load;
}

} // namespace voluta::elastic
