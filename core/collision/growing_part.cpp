#include "collision/growing_part.h"

#include "base/error.h"
#include "base/parallel.h"
#include "base/run_context.h"
#include "collision/bead_sections.h"
#include "collision/bead_solid.h"
#include "collision/fill_times.h"
#include "collision/same_segments.h"
#include "collision/shape_distance.h"
#include "geometry/measures.h"
#include "plan/tool_plan.h"
#include "platform/platform_solid.h"
#include "process/tooling.h"
#include "voxel/column_parity.h"
#include "voxel/voxel_grid.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace voluta::collision {

using Eigen::Vector3d;
using Eigen::Vector3i;

static_assert(GrowingPart::kNeverFilled == FillTimes::kNever);

namespace {

constexpr std::size_t kMaxCells = std::size_t{1} << 29;
constexpr std::size_t kSegmentsAChunk = 1024;
// Time of the ground, which exists before waypoint 0; beads fill cells from 1 on.
constexpr std::uint32_t kFromTheStart = 0;
constexpr double kMaxGroundCells = 1 << 24;
constexpr double kRodChordMm = 0.01;

// First waypoint of every segment that stays where it is printed (excluding gaps between paths, and
// shots, which are below the layer that they end at).
std::vector<std::uint32_t> segmentsOf(const plan::ToolPlan& plan) {
  std::vector<std::uint32_t> segments;
  segments.reserve(plan.waypointCount());
  const bool falls = plan.isPrimeInAir();
  for (const plan::ToolPath& path : plan.paths) {
    base::require(path.first + path.count <= plan.waypointCount(), "paths inside the plan");
    if ((falls && &path == &plan.paths.front()) || path.kind == plan::PathKind::Shot)
      continue;
    for (std::size_t i = path.first; i + 1 < path.first + path.count; ++i)
      segments.push_back(static_cast<std::uint32_t>(i));
  }
  return segments;
}

voxel::VoxelGrid gridAround(const plan::ToolPlan& plan, const std::vector<std::uint32_t>& segments,
                            double pitch, const base::RunContext& ctx) {
  voxel::VoxelGrid grid;
  grid.pitch = pitch;
  if (segments.empty())
    return grid;
  struct Around {
    Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    Around& operator+=(const Around& o) {
      low = low.cwiseMin(o.low);
      high = high.cwiseMax(o.high);
      return *this;
    }
  };
  const auto [low, high] = base::parallelSum<Around>(ctx, segments.size(), kSegmentsAChunk, {},
                                                     [&](std::size_t b, std::size_t e) {
                                                       Around part;
                                                       for (std::size_t s = b; s < e; ++s) {
                                                         const BeadSolid bead(plan, segments[s]);
                                                         part += {bead.low(), bead.high()};
                                                       }
                                                       return part;
                                                     });
  base::require(low.allFinite() && high.allFinite(), "waypoints are finite");
  // An integer multiple of the pitch, so that a part that grows elsewhere has the same cells.
  grid.origin = (low / pitch).array().floor().matrix() * pitch;
  const Vector3d cells = ((high - grid.origin) / pitch).array().ceil();
  if (cells.x() * cells.y() * cells.z() > static_cast<double>(kMaxCells))
    throw base::Error(base::ErrorCode::UnusableInput,
                      "the part is too large for a collision grid of this resolution"_text, {},
                      "scale the part down"_text);
  grid.size = cells.cast<int>();
  return grid;
}

// The cells of a grid whose centres are inside a box, allowing for rounding.
struct CellBox {
  Vector3i low, high;
};
CellBox centresIn(const voxel::VoxelGrid& grid, const Vector3d& low, const Vector3d& high) {
  constexpr double kRounding = 1e-6; // cells
  const Eigen::Array3d first = (low - grid.origin).array() / grid.pitch - 0.5,
                       last = (high - grid.origin).array() / grid.pitch - 0.5;
  return {(first - kRounding).ceil().matrix().cast<int>().cwiseMax(0),
          (last + kRounding).floor().matrix().cast<int>().cwiseMin(grid.size - Vector3i::Ones())};
}

// Returns whether the cell is empty or filled later than this.
bool isLater(std::uint32_t& cell, std::uint32_t lead) {
  return std::atomic_ref<std::uint32_t>(cell).load(std::memory_order_relaxed) < lead;
}

void raise(std::uint32_t& cell, std::uint32_t value) {
  std::atomic_ref<std::uint32_t> shared(cell);
  std::uint32_t old = shared.load(std::memory_order_relaxed);
  while (value > old && !shared.compare_exchange_weak(old, value, std::memory_order_relaxed)) {
  }
}

// Fills the cells of a segment, all inside the box, unless they are filled earlier.
void deposit(const BeadSolid& bead, const CellBox& box, std::uint32_t segment,
             const voxel::VoxelGrid& grid, FillTimes::ReversedTimes& leads) {
  const auto& [low, high] = box;
  const std::uint32_t lead = FillTimes::leadOf(segment + 1);
  for (int k = low.z(); k <= high.z(); ++k)
    for (int j = low.y(); j <= high.y(); ++j) {
      std::size_t cell = grid.index(low.x(), j, k);
      if (low.x() <= high.x())
        leads.prepare(cell);
      for (int i = low.x(); i <= high.x(); ++i, ++cell)
        if (isLater(leads[cell], lead) && bead.contains(grid.centre(i, j, k)))
          raise(leads[cell], lead);
    }
}

void requireArrays(const plan::ToolPlan& plan) {
  base::require(plan.direction.size() == plan.waypointCount() &&
                    plan.widthMm.size() == plan.waypointCount() &&
                    plan.heightMm.size() == plan.waypointCount(),
                "plan arrays of one length");
  base::require(plan.waypointCount() < GrowingPart::kNeverFilled, "fewer than 2^32 - 1 waypoints");
}

// Blocks of a grid that contain a cell to be refilled.
class Emptied {
public:
  explicit Emptied(const voxel::VoxelGrid& grid) {
    blocks_.size = (grid.size.array() + (kSide - 1)) / kSide;
    marks_.resize(blocks_.cellCount());
  }
  void mark(int i, int j, int k) {
    std::atomic_ref<std::uint8_t>(marks_[blocks_.index(i / kSide, j / kSide, k / kSide)])
        .store(1, std::memory_order_relaxed);
  }
  bool anyIn(const CellBox& box) const {
    const auto& [low, high] = box;
    if ((low.array() > high.array()).any())
      return false;
    for (int z = low.z() / kSide; z <= high.z() / kSide; ++z)
      for (int y = low.y() / kSide; y <= high.y() / kSide; ++y)
        for (int x = low.x() / kSide; x <= high.x() / kSide; ++x)
          if (marks_[blocks_.index(x, y, z)] != 0)
            return true;
    return false;
  }

private:
  static constexpr int kSide = 4; // cells
  voxel::VoxelGrid blocks_;
  std::vector<std::uint8_t> marks_;
};

// Time for queries before waypoint `before`: the ground exists before the first.
std::uint32_t momentOf(std::size_t before) {
  return static_cast<std::uint32_t>(
      std::clamp<std::size_t>(before, kFromTheStart + 1, GrowingPart::kNeverFilled));
}

} // namespace

double growingPitch(const plan::ToolPlan& plan, const process::Tooling& tooling) {
  constexpr double kCells = 1 << 27;
  double finest = std::numeric_limits<double>::infinity(), widest = 0.0;
  const auto include = [&](const process::Process& process) {
    finest = std::min({finest, 0.25 * process.beadWidthMm, 0.5 * process.layerHeightMm});
    widest = std::max(widest, process.beadWidthMaxMm);
  };
  // Tape is thinner than any clearance.
  for (const plan::ToolPath& path : plan.paths)
    if (path.kind != plan::PathKind::Tape)
      include(tooling.of(path).process);
  if (std::isinf(finest))
    include(tooling.first().process); // No path that names a tool
  Eigen::AlignedBox3d box;
  for (const Vector3d& p : plan.position)
    box.extend(p);
  if (box.isEmpty())
    return finest;
  const Vector3d sides = box.sizes().array() + 2.0 * widest;
  return std::max(finest, std::cbrt(sides.prod() / kCells));
}

std::shared_ptr<const FillTimes> groundCells(const platform::PlatformSolid& platform,
                                             const plan::ToolPlan& plan, double pitch,
                                             const base::RunContext& ctx) {
  struct Solid {
    geometry::TriangleMesh mesh;
    std::uint32_t moment = kFromTheStart;
  };
  std::vector<Solid> solids;
  if (platform.mesh)
    solids.push_back({*platform.mesh});
  if (platform.rod)
    solids.push_back({platform::meshOf(*platform.rod, kRodChordMm)});
  for (const plan::Insert& insert : plan.inserts)
    // Queries for a later waypoint than the last one before the insert find it.
    if (const std::size_t first = plan.firstAfter(insert); first < plan.waypointCount())
      solids.push_back(
          {*insert.body, static_cast<std::uint32_t>(std::max<std::size_t>(first, 1) - 1)});
  Eigen::AlignedBox3d box;
  for (const Solid& solid : solids)
    box.extend(geometry::bounds(solid.mesh));
  if (box.isEmpty())
    return nullptr;
  voxel::VoxelGrid grid;
  grid.pitch = std::max(pitch, std::cbrt(box.volume() / kMaxGroundCells));
  grid.origin = (box.min() / grid.pitch).array().floor().matrix() * grid.pitch;
  grid.size = ((box.max() - grid.origin) / grid.pitch).array().ceil().cast<int>().max(1);
  FillTimes::ReversedTimes leads(grid.cellCount());
  for (const auto& [mesh, moment] : solids) {
    std::vector<std::uint8_t> inside(grid.cellCount(), 0);
    const geometry::TriangleMesh caps = voxel::capsOf(mesh);
    if (caps.triangles.empty())
      voxel::fillClosed(mesh, grid, inside, ctx);
    else
      voxel::fillOpen(mesh, caps, grid, inside, ctx);
    const std::uint32_t lead = FillTimes::leadOf(moment);
    for (std::size_t c = 0; c < inside.size(); ++c)
      if (inside[c] != 0 && leads[c] < lead)
        leads[c] = lead;
  }
  return std::make_shared<FillTimes>(grid, std::move(leads), ctx);
}

GrowingPart::GrowingPart(const plan::ToolPlan& plan, double pitchMm, const base::RunContext& ctx,
                         std::shared_ptr<const FillTimes> ground)
    : ground_(ground ? std::move(ground) : std::make_shared<FillTimes>()) {
  base::require(pitchMm > 0.0, "pitch > 0");
  requireArrays(plan);
  const std::vector<std::uint32_t> segments = segmentsOf(plan);
  const voxel::VoxelGrid grid = gridAround(plan, segments, pitchMm, ctx);
  FillTimes::ReversedTimes leads(grid.cellCount());
  base::parallelChunks(ctx, segments.size(), kSegmentsAChunk, [&](std::size_t b, std::size_t e) {
    for (std::size_t s = b; s < e; ++s) {
      const BeadSolid bead(plan, segments[s]);
      deposit(bead, centresIn(grid, bead.low(), bead.high()), segments[s], grid, leads);
    }
  });
  beads_ = std::make_shared<FillTimes>(grid, std::move(leads), ctx);
  sections_ = std::make_shared<BeadSections>(plan, segments);
}

GrowingPart::GrowingPart(const plan::ToolPlan& plan, const GrowingPart& other,
                         const plan::ToolPlan& itsPlan, const base::RunContext& ctx)
    : ground_(other.ground_) {
  requireArrays(plan);
  requireArrays(itsPlan);
  const std::vector<std::uint32_t> segments = segmentsOf(plan), its = segmentsOf(itsPlan);
  const std::vector<std::uint32_t> same = sameSegments(plan, segments, itsPlan, its, ctx);
  // Indexed by the first waypoint of a segment of the other plan: its lead in this plan, or 0.
  std::vector<std::uint32_t> leadHere(itsPlan.waypointCount(), 0);
  std::vector<char> known(segments.size(), 0);
  for (std::size_t s = 0; s < its.size(); ++s)
    if (same[s] != kNoSegment) {
      leadHere[its[s]] = FillTimes::leadOf(segments[same[s]] + 1);
      known[same[s]] = 1;
    }

  const voxel::VoxelGrid& there = other.grid();
  const voxel::VoxelGrid grid = gridAround(plan, segments, there.pitch, ctx);
  FillTimes::ReversedTimes leads(grid.cellCount());
  Emptied emptied(grid);
  // Both origins are integer multiples of the pitch.
  const Vector3i shift =
      ((there.origin - grid.origin) / grid.pitch).array().round().matrix().cast<int>();
  const Vector3i low = shift.cwiseMax(0), high = (shift + there.size).cwiseMin(grid.size);
  base::parallelChunks(
      ctx, static_cast<std::size_t>(std::max(0, high.z() - low.z())), 1,
      [&](std::size_t b, std::size_t e) {
        for (int k = low.z() + static_cast<int>(b); k < low.z() + static_cast<int>(e); ++k)
          for (int j = low.y(); j < high.y(); ++j) {
            std::size_t from = there.index(low.x() - shift.x(), j - shift.y(), k - shift.z());
            std::size_t to = grid.index(low.x(), j, k);
            for (int i = low.x(); i < high.x(); ++i, ++from, ++to) {
              const std::uint32_t filled = other.filledAt(from);
              if (filled == kNeverFilled)
                continue;
              leads[to] = leadHere[filled - 1];
              if (leads[to] == 0)
                emptied.mark(i, j, k);
            }
          }
      });
  base::parallelChunks(ctx, segments.size(), kSegmentsAChunk, [&](std::size_t b, std::size_t e) {
    for (std::size_t s = b; s < e; ++s) {
      const BeadSolid bead(plan, segments[s]);
      const CellBox box = centresIn(grid, bead.low(), bead.high());
      if (!known[s] || emptied.anyIn(box))
        deposit(bead, box, segments[s], grid, leads);
    }
  });
  beads_ = std::make_shared<FillTimes>(grid, std::move(leads), ctx);
  sections_ = std::make_shared<BeadSections>(plan, segments);
}

std::shared_ptr<const GrowingPart> regrown(const plan::ToolPlan& plan, const GrowingPart& other,
                                           const plan::ToolPlan& itsPlan,
                                           const process::Tooling& tooling,
                                           const base::RunContext& ctx) {
  const double pitch = growingPitch(plan, tooling);
  return pitch == other.grid().pitch
             ? std::make_shared<const GrowingPart>(plan, other, itsPlan, ctx)
             : std::make_shared<const GrowingPart>(plan, pitch, ctx, other.ground_);
}

const voxel::VoxelGrid& GrowingPart::grid() const {
  return beads_->grid();
}

std::uint32_t GrowingPart::filledAt(std::size_t cell) const {
  return beads_->filledAt(cell);
}

bool GrowingPart::touches(const robot::Shape& shape, const Eigen::Isometry3d& work_T_shape,
                          double marginMm, std::size_t before) const {
  const std::uint32_t moment = momentOf(before);
  return beads_->touches(shape, work_T_shape, marginMm, moment) ||
         ground_->touches(shape, work_T_shape, marginMm, moment);
}

bool GrowingPart::headTouches(const Revolved& head, const Eigen::Isometry3d& work_T_head,
                              double marginMm, std::size_t before,
                              std::optional<std::size_t> printing) const {
  const std::uint32_t moment = momentOf(before);
  return beads_->touches(head, work_T_head, marginMm - 0.5 * beads_->grid().pitch, moment) ||
         ground_->touches(head, work_T_head, marginMm - 0.5 * ground_->grid().pitch, moment) ||
         sections_->reachedBy(head.underside(work_T_head, std::min(marginMm, kUndersideMm)),
                              printing.value_or(before));
}

Eigen::AlignedBox3d GrowingPart::bounds() const {
  Eigen::AlignedBox3d box;
  for (const FillTimes* cells : {ground_.get(), beads_.get()}) {
    const voxel::VoxelGrid& grid = cells->grid();
    if (grid.cellCount() == 0)
      continue;
    box.extend(grid.origin);
    box.extend(Eigen::Vector3d(grid.origin + grid.pitch * grid.size.cast<double>()));
  }
  return box;
}

bool GrowingPart::holds(const Eigen::Vector3d& point, std::size_t before) const {
  const std::uint32_t moment = momentOf(before);
  return beads_->holds(point, moment) || ground_->holds(point, moment);
}

double GrowingPart::distance(const robot::Shape& shape, const Eigen::Isometry3d& work_T_shape,
                             double capMm, std::size_t before) const {
  const std::uint32_t moment = momentOf(before);
  return ground_->distance(shape, work_T_shape,
                           beads_->distance(shape, work_T_shape, capMm, moment), moment);
}

} // namespace voluta::collision
