#include "sliced/layer_solid.h"

#include "base/error.h"
#include "base/run_context.h"
#include "geometry/measures.h"
#include "process/bead_model.h"
#include "sliced/bead_sections.h"
#include "sliced/layer_slabs.h"
#include "voxel/voxel_object.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace voluta::sliced {

namespace {
using Eigen::Vector2d, Eigen::Vector3d;

constexpr double kMostFaces = 4e5; // Soft limit
constexpr double kMostCells = 1 << 27;
constexpr double kShellBeads = 0.8; // Part of an outer wall that is certainly solid

bool isOfPart(plan::PathKind kind) {
  return kind != plan::PathKind::Support && kind != plan::PathKind::Tape && !plan::isWaste(kind);
}
bool isWall(plan::PathKind kind) {
  return kind == plan::PathKind::Wall;
}

// The cells of one slab, x fastest.
struct Mask {
  int width = 0, depth = 0;
  std::vector<std::uint8_t> bits;

  Mask(int w, int d)
      : width(w), depth(d), bits(static_cast<std::size_t>(w) * static_cast<std::size_t>(d)) {}
  std::size_t index(int i, int j) const {
    return static_cast<std::size_t>(i) +
           static_cast<std::size_t>(width) * static_cast<std::size_t>(j);
  }
};

enum Bit : std::uint8_t { kBead = 1, kOfWall = 2, kInfill = 4, kReached = 8, kFilled = 16 };

struct Field {
  Vector2d origin;
  double pitch = 1.0;
  int width = 1, depth = 1;
};

// Marks the cells whose centres are within half a hatch of a segment.
void mark(Mask& mask, const Field& field, const plan::ToolPlan& plan, std::size_t i,
          std::uint8_t bits) {
  const Vector2d a = plan.position[i - 1].head<2>(), b = plan.position[i].head<2>();
  const double width = 0.5 * (plan.widthMm[i - 1] + plan.widthMm[i]);
  const double height = 0.5 * (plan.heightMm[i - 1] + plan.heightMm[i]);
  const double half = 0.5 * process::hatchOf(width, height);
  const auto cell = [&](double at, int axis, int most) {
    return static_cast<int>(
        std::clamp(std::floor((at - field.origin[axis]) / field.pitch), 0.0, most - 1.0));
  };
  const Vector2d along = b - a;
  const double length2 = along.squaredNorm();
  for (int j = cell(std::min(a.y(), b.y()) - half, 1, field.depth);
       j <= cell(std::max(a.y(), b.y()) + half, 1, field.depth); ++j)
    for (int k = cell(std::min(a.x(), b.x()) - half, 0, field.width);
         k <= cell(std::max(a.x(), b.x()) + half, 0, field.width); ++k) {
      const Vector2d centre = field.origin + field.pitch * Vector2d(k + 0.5, j + 0.5);
      const double t =
          length2 > 0.0 ? std::clamp((centre - a).dot(along) / length2, 0.0, 1.0) : 0.0;
      if ((centre - a - t * along).squaredNorm() <= half * half)
        mask.bits[mask.index(k, j)] |= bits;
    }
}

// A region within walls.
struct Region {
  std::vector<std::size_t> cells;
  std::size_t beads = 0, infill = 0;
  bool isOutside = false;
};

Region regionFrom(Mask& mask, std::size_t seed) {
  Region region;
  std::vector<std::size_t> open{seed};
  mask.bits[seed] |= kReached;
  while (!open.empty()) {
    const std::size_t c = open.back();
    open.pop_back();
    region.cells.push_back(c);
    region.beads += (mask.bits[c] & kBead) != 0;
    region.infill += (mask.bits[c] & kInfill) != 0;
    const int i = static_cast<int>(c % static_cast<std::size_t>(mask.width));
    const int j = static_cast<int>(c / static_cast<std::size_t>(mask.width));
    region.isOutside =
        region.isOutside || i == 0 || j == 0 || i + 1 == mask.width || j + 1 == mask.depth;
    const auto visit = [&](int x, int y) {
      if (x < 0 || y < 0 || x >= mask.width || y >= mask.depth)
        return;
      const std::size_t n = mask.index(x, y);
      if ((mask.bits[n] & (kReached | kOfWall)) == 0) {
        mask.bits[n] |= kReached;
        open.push_back(n);
      }
    };
    visit(i - 1, j), visit(i + 1, j), visit(i, j - 1), visit(i, j + 1);
  }
  return region;
}

class Filling {
public:
  Filling(plan::ToolPlan& plan, double sparseShare) : plan_(plan), sparseShare_(sparseShare) {}

  LayerSolid fill(const base::RunContext& ctx) {
    measure();
    const LayerSlabs slabs(plan_, isOfPart);
    sized(slabs.count());
    voxel::VoxelObject object;
    object.size = {field_.width, field_.depth, static_cast<int>(slabs.count())};
    object.solid.assign(static_cast<std::size_t>(field_.width) *
                            static_cast<std::size_t>(field_.depth) * slabs.count(),
                        0);
    std::vector<std::size_t> sparseVotes(plan_.paths.size()), votes(plan_.paths.size());
    for (std::size_t k = 0; k < slabs.count(); ++k) {
      ctx.checkpoint();
      Mask mask(field_.width, field_.depth);
      fillSlab(slabs.segments(k), mask, sparseVotes, votes);
      const std::size_t base = k * mask.bits.size();
      for (std::size_t c = 0; c < mask.bits.size(); ++c)
        object.solid[base + c] = (mask.bits[c] & (kBead | kFilled)) != 0;
    }
    for (std::size_t p = 0; p < plan_.paths.size(); ++p)
      if (plan_.paths[p].kind == plan::PathKind::Infill && 2 * sparseVotes[p] > votes[p])
        plan_.paths[p].kind = plan::PathKind::SparseInfill;
    return solidOf(object, slabs);
  }

private:
  void measure() {
    std::vector<float> hatches;
    for (const plan::ToolPath& path : plan_.paths)
      if (isOfPart(path.kind))
        for (std::size_t i = path.first; i < path.first + path.count; ++i) {
          if (!(plan_.widthMm[i] > 0.0f) || !(plan_.heightMm[i] > 0.0f))
            throw base::Error(base::ErrorCode::UnusableInput,
                              "the height of the beads is not known"_text, {},
                              "slice with comments, or with layers of one height"_text);
          box_.extend(plan_.position[i]);
          box_.extend(
              Vector3d(plan_.position[i] - Vector3d(0, 0, static_cast<double>(plan_.heightMm[i]))));
          widestMm_ = std::max(widestMm_, static_cast<double>(plan_.widthMm[i]));
          hatches.push_back(
              static_cast<float>(process::hatchOf(plan_.widthMm[i], plan_.heightMm[i])));
        }
    if (hatches.empty())
      throw base::Error(base::ErrorCode::UnusableInput, "contains no beads of a part"_text, {},
                        "export the G-code with extrusion (E)"_text);
    const auto tenth = hatches.begin() + static_cast<std::ptrdiff_t>(hatches.size() / 10);
    std::nth_element(hatches.begin(), tenth, hatches.end());
    hatchMm_ = static_cast<double>(*tenth);
  }

  void sized(std::size_t slabs) {
    const Vector3d size = box_.sizes() + Vector3d(2.0 * widestMm_, 2.0 * widestMm_, 0.0);
    const double area = 2.0 * (size.x() * size.y() + size.y() * size.z() + size.z() * size.x());
    // Walls stay closed: cells that touch only by corners do not let a region out.
    constexpr double kFine = 0.25, kClosed = 0.6;
    field_.pitch = std::clamp(std::sqrt(area / kMostFaces), kFine * hatchMm_, kClosed * hatchMm_);
    field_.pitch = std::max(
        field_.pitch, std::sqrt(size.x() * size.y() * static_cast<double>(slabs) / kMostCells));
    field_.origin = box_.min().head<2>() - Vector2d::Constant(widestMm_ + field_.pitch);
    const auto cells = [&](double mm) {
      return static_cast<int>(std::ceil(mm / field_.pitch)) + 2;
    };
    field_.width = cells(size.x());
    field_.depth = cells(size.y());
  }

  void fillSlab(const std::vector<LayerSlabs::Segment>& segments, Mask& mask,
                std::vector<std::size_t>& sparseVotes, std::vector<std::size_t>& votes) const {
    for (const LayerSlabs::Segment& s : segments) {
      const plan::PathKind kind = plan_.paths[s.path].kind;
      mark(mask, field_, plan_, s.end,
           static_cast<std::uint8_t>(isWall(kind) ? kBead | kOfWall : kBead | kInfill));
    }
    std::vector<std::uint8_t> sparse(mask.bits.size());
    for (std::size_t c = 0; c < mask.bits.size(); ++c) {
      if ((mask.bits[c] & (kReached | kOfWall)) != 0)
        continue;
      const Region region = regionFrom(mask, c);
      if (region.isOutside || region.infill == 0)
        continue;
      const bool isSparse = static_cast<double>(region.beads) <
                            sparseShare_ * static_cast<double>(region.cells.size());
      for (const std::size_t in : region.cells) {
        mask.bits[in] |= kFilled;
        sparse[in] = isSparse;
      }
    }
    for (const LayerSlabs::Segment& s : segments) {
      const Vector2d middle = 0.5 * (plan_.position[s.end - 1] + plan_.position[s.end]).head<2>();
      const Vector2d at = (middle - field_.origin) / field_.pitch;
      const std::size_t c = mask.index(static_cast<int>(at.x()), static_cast<int>(at.y()));
      ++votes[s.path];
      sparseVotes[s.path] += sparse[c];
    }
  }

  LayerSolid solidOf(const voxel::VoxelObject& object, const LayerSlabs& slabs) const {
    LayerSolid solid;
    solid.mesh = voxel::surfaceOf(object);
    for (Vector3d& v : solid.mesh.vertices)
      v = {field_.origin.x() + field_.pitch * v.x(), field_.origin.y() + field_.pitch * v.y(),
           slabs.heightAt(v.z())};
    const bool hasSparse = std::ranges::any_of(plan_.paths, [](const plan::ToolPath& path) {
      return path.kind == plan::PathKind::SparseInfill;
    });
    if (hasSparse) {
      solid.fill.shellMm = kShellBeads * hatchMm_;
      solid.fill.openMm3 = std::max(0.0, geometry::volume(solid.mesh) - partBeadsMm3(plan_));
    }
    return solid;
  }

  plan::ToolPlan& plan_;
  const double sparseShare_;
  Eigen::AlignedBox3d box_;
  double hatchMm_ = 0.0, widestMm_ = 0.0;
  Field field_;
};
} // namespace

double partBeadsMm3(const plan::ToolPlan& plan) {
  double volume = 0.0;
  for (const plan::ToolPath& path : plan.paths)
    volume += isOfPart(path.kind) ? beadsMm3(plan, path) : 0.0;
  return volume;
}

bool isLevel(const plan::ToolPlan& plan) {
  constexpr double kUpright = 1.0 - 1e-6;
  return std::ranges::all_of(plan.direction, [](const Vector3d& d) { return d.z() >= kUpright; });
}

LayerSolid solidOfLayers(plan::ToolPlan& plan, double sparseShare, const base::RunContext& ctx) {
  base::require(plan.direction.size() == plan.waypointCount() &&
                    plan.widthMm.size() == plan.waypointCount() &&
                    plan.heightMm.size() == plan.waypointCount(),
                "plan arrays of one length");
  return Filling(plan, sparseShare).fill(ctx);
}

} // namespace voluta::sliced
