#include "toolpath/unsupported/supported_walls.h"

#include "base/index.h"
#include "base/parallel.h"
#include "base/run_context.h"
#include "geometry/edges.h"
#include "geometry/measures.h"
#include "layers/stack_query.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace voluta::toolpath {

namespace {

using base::at;
using Eigen::Vector3d;

// Required supported share of a bead's width: half, plus a margin, since beads are rasterised and
// judged at eight samples across.
constexpr double kCarried = 0.5625;
constexpr double kSamples = 12.0; // across a bead of the usual width
constexpr double kOn = 0.03;      // beads: this close beside a patch counts as over its edge
constexpr double kTouches = 0.25; // beads: the edge of a wide bead rests on material this close

// Measures the support below the rim of one patch.
class Rim {
public:
  Rim(const layers::LayerStack& stack, std::size_t p, const layers::StackQuery& query,
      const process::Process& process)
      : stack_(stack), patch_(stack.patches[p]), query_(query), process_(process),
        reachMm_(process.layerHeightMaxMm + process.beadWidthMaxMm) {
    Eigen::AlignedBox3d box = geometry::bounds(patch_.surface);
    const double thickest =
        patch_.thicknessMm.empty() ? 0.0 : *std::ranges::max_element(patch_.thicknessMm);
    box.min().array() -= thickest + reachMm_;
    box.max().array() += thickest + reachMm_;
    below_ = query.near(box, 0, static_cast<int>(p));
    std::erase_if(below_, [&](int q) { return stack.patches[at(q)].layer >= patch_.layer; });
  }

  std::vector<double> widths() const {
    const auto& vertices = patch_.surface.vertices;
    std::vector<double> width(vertices.size(), process_.beadWidthMm);
    if (below_.empty() || patch_.group == layers::kSupportGroup)
      return width;
    std::vector<Vector3d> inwards(vertices.size(), Vector3d::Zero());
    const auto edges = geometry::sortedHalfEdges(patch_.surface);
    geometry::forEachEdge(edges, [&](std::size_t b, std::size_t e) {
      if (e - b != 1)
        return;
      const int low = edges[b].low, high = edges[b].high;
      const Vector3d along =
          (edges[b].forward ? 1.0 : -1.0) * (vertices[at(high)] - vertices[at(low)]);
      for (const int v : {low, high})
        inwards[at(v)] += patch_.direction[at(v)].cross(along);
    });
    for (std::size_t v = 0; v < vertices.size(); ++v)
      if (inwards[v].squaredNorm() > 0.0 && (patch_.innerRim.empty() || !patch_.innerRim[v]))
        width[v] = widthAt(v, inwards[v].normalized());
    return width;
  }

private:
  // Returns the lateral distance of a point's foot from the patches below; twice the search radius
  // if none is near.
  double lateralMm(std::size_t v, const Vector3d& point) const {
    const Vector3d& up = patch_.direction[v];
    const Vector3d foot = point - patch_.thicknessMm[v] * up;
    const layers::StackQuery::Place place = query_.closest(below_, foot, reachMm_);
    if (place.patch < 0)
      return 2.0 * reachMm_;
    // Measure perpendicular to the directions of the patch below: over its interior the distance is
    // zero.
    const layers::Patch& below = stack_.patches[at(place.patch)];
    Vector3d along = Vector3d::Zero();
    for (const int corner : below.surface.triangles[at(place.triangle)])
      along += below.direction[at(corner)];
    along.normalize();
    const Vector3d lateral = place.point - foot;
    return (lateral - lateral.dot(along) * along).norm();
  }

  double widthAt(std::size_t v, const Vector3d& inwards) const {
    const double usual = process_.beadWidthMm, sample = usual / kSamples, on = kOn * usual;
    const Vector3d& rim = patch_.surface.vertices[v];
    const auto lateral = [&](double inMm) { return lateralMm(v, rim + inMm * inwards); };
    // Common case: the rim is above the patch below or close to it.
    if (lateral(0.0) < (1.0 - kCarried) * usual && lateral(0.5 * usual) < on)
      return usual;
    const auto count =
        static_cast<std::size_t>(std::ceil((process_.beadWidthMaxMm + kTouches * usual) / sample));
    std::vector<char> isCarried(count, 0);
    for (std::size_t i = 0; i < count;) {
      const double off = lateral((static_cast<double>(i) + 0.5) * sample);
      isCarried[i] = off < on;
      // No sample closer than `off` can be over a patch.
      i += std::max<std::size_t>(
          1, static_cast<std::size_t>(std::min(off / sample, static_cast<double>(count))));
    }
    return carriedWidth(isCarried, sample, process_);
  }

  const layers::LayerStack& stack_;
  const layers::Patch& patch_;
  const layers::StackQuery& query_;
  const process::Process& process_;
  double reachMm_;
  std::vector<int> below_;
};

} // namespace

double carriedWidth(const std::vector<char>& isCarried, double sampleMm,
                    const process::Process& process) {
  const double usual = process.beadWidthMm, maximum = process.beadWidthMaxMm;
  double best = usual, bestShare = 0.0;
  std::size_t carried = 0;
  for (std::size_t i = 0; i < isCarried.size(); ++i) {
    carried += isCarried[i] != 0 ? 1 : 0;
    const double width = std::min(maximum, static_cast<double>(i + 1) * sampleMm);
    if (width < usual - 1e-9)
      continue;
    const double share = static_cast<double>(carried) / static_cast<double>(i + 1);
    if (share > bestShare) {
      bestShare = share;
      best = width;
    }
    if (share >= kCarried)
      return width;
  }
  return best;
}

std::vector<std::vector<double>> carriedWallWidths(const layers::LayerStack& stack,
                                                   const process::Tooling& tooling,
                                                   const base::RunContext& ctx) {
  std::vector<Eigen::AlignedBox3d> around;
  for (const layers::Patch& patch : stack.patches)
    around.push_back(geometry::bounds(patch.surface));
  const layers::StackQuery query(stack.patches, around, 0.0, ctx);
  std::vector<std::vector<double>> widths(stack.patches.size());
  base::parallelChunks(ctx, widths.size(), 4, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p)
      widths[p] = Rim(stack, p, query, tooling.at(stack.patches[p].tool).process).widths();
  });
  return widths;
}

} // namespace voluta::toolpath
