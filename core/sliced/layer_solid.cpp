#include "sliced/layer_solid.h"

#include "base/error.h"
#include "base/run_context.h"
#include "base/units.h"
#include "geometry/measures.h"
#include "process/bead_model.h"
#include "sliced/layer_mask.h"
#include "sliced/layer_slabs.h"
#include "sliced/layer_surface.h"
#include "sliced/sliced_sections.h"
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

constexpr double kMaxFaces = 4e5; // Soft limit
constexpr double kMaxCells = 1 << 27;
constexpr double kShellBeads = 0.8;     // Part of an outer wall that is certainly solid
constexpr double kThinBeads = 0.75;     // Gaps between neighbouring beads are no holes
constexpr double kWithinShare = 0.8;    // Of a gap that is inside the part
constexpr float kWidestBeadMm = 200.0f; // Wider than any nozzle lays: an amount for another way

bool isOfPart(plan::PathKind kind) {
  return kind != plan::PathKind::Support && kind != plan::PathKind::Tape && !plan::isWaste(kind);
}
std::uint8_t markOf(plan::PathKind kind) {
  return kind == plan::PathKind::Wall           ? LayerMask::kWall
         : kind == plan::PathKind::SparseInfill ? LayerMask::kSparse
                                                : LayerMask::kInfill;
}

// Cells until gaps are filled; then there are empty and solid ones only.
constexpr std::uint8_t kEmpty = 0, kSolid = 1, kSparseGap = 2, kSparseBead = 3;

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
      LayerMask mask(field_);
      const std::vector<std::uint8_t> sparse =
          fillSlab(slabs.segments(k), static_cast<std::uint32_t>(k), mask, sparseVotes, votes);
      const std::size_t base = k * mask.bits.size();
      for (std::size_t c = 0; c < mask.bits.size(); ++c)
        object.solid[base + c] = valueOf(mask, c, sparse[c] != 0);
    }
    fillGaps(object);
    for (std::size_t p = 0; p < plan_.paths.size(); ++p)
      if (plan_.paths[p].kind == plan::PathKind::Infill && 2 * sparseVotes[p] > votes[p])
        plan_.paths[p].kind = plan::PathKind::SparseInfill;
    return solidOf(object, slabs, ctx);
  }

private:
  // Solid infill beside sparse infill, e.g. below a slope, is solid where its kind is known.
  std::uint8_t valueOf(const LayerMask& mask, std::size_t c, bool isSparse) const {
    if (!isSparse)
      return mask.isSolid(c) ? kSolid : kEmpty;
    const bool isKnown = sparseShare_ == 0.0 && (mask.bits[c] & LayerMask::kOfInfill) != 0 &&
                         (mask.bits[c] & LayerMask::kOfSparse) == 0;
    return isKnown ? kSolid : mask.isSolid(c) ? kSparseBead : kSparseGap;
  }

  void measure() {
    std::vector<float> hatches;
    for (const plan::ToolPath& path : plan_.paths)
      if (isOfPart(path.kind))
        for (std::size_t i = path.first; i < path.first + path.count; ++i) {
          if (!(plan_.widthMm[i] > 0.0f) || !(plan_.heightMm[i] > 0.0f))
            throw base::Error(base::ErrorCode::UnusableInput,
                              "the height of the beads is not known"_text, {},
                              "slice with comments, or with layers of one height"_text);
          if (plan_.widthMm[i] > kWidestBeadMm)
            throw base::Error(
                base::ErrorCode::UnusableInput,
                base::message("a bead at X{x:.1f} Y{y:.1f} Z{z:.1f} is {width:.0f} wide"_text,
                              base::number(plan_.position[i].x()),
                              base::number(plan_.position[i].y()),
                              base::number(plan_.position[i].z()),
                              base::mm(static_cast<double>(plan_.widthMm[i]))),
                {}, "correct the amount (E) of that line, or the filament's diameter"_text);
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
    field_.pitch = std::clamp(std::sqrt(area / kMaxFaces), kFine * hatchMm_, kClosed * hatchMm_);
    field_.pitch = std::max(
        field_.pitch, std::sqrt(size.x() * size.y() * static_cast<double>(slabs) / kMaxCells));
    field_.origin = box_.min().head<2>() - Vector2d::Constant(widestMm_ + field_.pitch);
    const auto cells = [&](double mm) {
      return static_cast<int>(std::ceil(mm / field_.pitch)) + 2;
    };
    field_.width = cells(size.x());
    field_.depth = cells(size.y());
  }

  // Returns whether each cell is of a region of sparse infill, which fillGaps() fills.
  std::vector<std::uint8_t> fillSlab(const std::vector<LayerSlabs::Segment>& segments,
                                     std::uint32_t slab, LayerMask& mask,
                                     std::vector<std::size_t>& sparseVotes,
                                     std::vector<std::size_t>& votes) {
    for (const LayerSlabs::Segment& s : segments)
      mask.mark(plan_, s.end, markOf(plan_.paths[s.path].kind));
    std::vector<std::uint8_t> sparse(mask.bits.size());
    const int thin = std::max(1, static_cast<int>(kThinBeads * hatchMm_ / field_.pitch));
    for (std::size_t c = 0; c < mask.bits.size(); ++c) {
      if (!mask.isOpen(c))
        continue;
      LayerMask::Region region = mask.regionFrom(c);
      if (region.isOutside)
        continue;
      if (region.infill == 0 && !mask.isThin(region, thin)) {
        if (sparseShare_ > 0.0)
          gaps_.push_back({slab, std::move(region.cells)});
        continue;
      }
      const bool isSparse =
          region.infill > 0 && (2 * region.sparse > region.infill ||
                                static_cast<double>(region.beads) <
                                    sparseShare_ * static_cast<double>(region.cells.size()));
      for (const std::size_t in : region.cells) {
        sparse[in] = isSparse;
        if (!isSparse)
          mask.bits[in] |= LayerMask::kFilled;
      }
    }
    for (const LayerSlabs::Segment& s : segments) {
      ++votes[s.path];
      sparseVotes[s.path] +=
          sparse[mask.cellOf(0.5 * (plan_.position[s.end - 1] + plan_.position[s.end]).head<2>())];
    }
    return sparse;
  }

  // Sparse infill is inside the part if there is solid material above and below; else it shows.
  // Without comments, closed paths of infill look like walls. What they enclose is inside the part
  // by the same rule; else it is a hole.
  void fillGaps(voxel::VoxelObject& object) {
    const std::size_t cells =
        static_cast<std::size_t>(object.size.x()) * static_cast<std::size_t>(object.size.y());
    const auto slabs = static_cast<std::size_t>(object.size.z());
    constexpr std::uint32_t kNone = 0xffffffff;
    std::vector<std::uint32_t> lowest(cells, kNone), highest(cells, 0);
    for (std::size_t k = 0; k < slabs; ++k)
      for (std::size_t c = 0; c < cells; ++c)
        if (object.solid[k * cells + c] == kSolid) {
          lowest[c] = std::min(lowest[c], static_cast<std::uint32_t>(k));
          highest[c] = static_cast<std::uint32_t>(k);
        }
    for (std::size_t k = 0; k < slabs; ++k)
      for (std::size_t c = 0; c < cells; ++c)
        if (std::uint8_t& cell = object.solid[k * cells + c]; cell != kEmpty)
          cell = cell != kSparseGap || (lowest[c] < k && highest[c] > k) ? kSolid : kEmpty;
    for (const Gap& gap : gaps_) {
      std::size_t within = 0;
      for (const std::size_t c : gap.cells)
        within += lowest[c] < gap.slab && highest[c] > gap.slab;
      if (static_cast<double>(within) < kWithinShare * static_cast<double>(gap.cells.size()))
        continue;
      hasGaps_ = true;
      for (const std::size_t c : gap.cells)
        object.solid[gap.slab * cells + c] = kSolid;
    }
  }

  LayerSolid solidOf(const voxel::VoxelObject& object, const LayerSlabs& slabs,
                     const base::RunContext& ctx) const {
    LayerSolid solid;
    solid.mesh = surfaceOfLayers(object, plan_, slabs, field_, ctx);
    const bool hasSparse = std::ranges::any_of(plan_.paths, [](const plan::ToolPath& path) {
      return path.kind == plan::PathKind::SparseInfill;
    });
    if (hasSparse || hasGaps_) {
      solid.fill.shellMm = kShellBeads * hatchMm_;
      solid.fill.openMm3 = std::max(0.0, geometry::volume(solid.mesh) - partBeadsMm3(plan_));
    }
    return solid;
  }

  plan::ToolPlan& plan_;
  const double sparseShare_;
  Eigen::AlignedBox3d box_;
  double hatchMm_ = 0.0, widestMm_ = 0.0;
  LayerMask::Field field_;
  // Regions within closed paths, without infill
  struct Gap {
    std::uint32_t slab;
    std::vector<std::size_t> cells;
  };
  std::vector<Gap> gaps_;
  bool hasGaps_ = false; // Some of them are inside the part
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
