#include "toolpath/infill/thin_rings.h"

#include "base/index.h"
#include "process/bead_model.h"
#include "toolpath/infill/curve_tools.h"
#include "toolpath/surface_fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace voluta::toolpath {

namespace {
using base::at;

// Shares of the area that may be narrower and wider than the beads allow: sharp corners are wide.
constexpr double kNarrowShare = 0.1, kWideShare = 0.2;
// [hatches of the narrowest bead]: below half of it a wall gets no bead; a little more for the
// rounding of distances.
constexpr double kLeast = 0.55, kSlack = 0.99;

// Returns the two boundaries; nullopt if there is another number.
std::optional<std::array<std::vector<SourceSegment>, 2>> twoRims(const PatchSurface& s) {
  std::vector<std::size_t> edgeFrom(s.position.size(), s.boundary.size());
  for (std::size_t i = 0; i < s.boundary.size(); ++i) {
    std::size_t& edge = edgeFrom[at(s.boundary[i][0])];
    if (edge != s.boundary.size() || s.isSeam(i)) // boundaries touch
      return std::nullopt;
    edge = i;
  }
  std::vector<char> seen(s.boundary.size(), 0);
  std::array<std::vector<SourceSegment>, 2> rims;
  std::size_t count = 0;
  for (std::size_t first = 0; first < seen.size(); ++first) {
    if (seen[first])
      continue;
    if (count == 2)
      return std::nullopt;
    for (std::size_t i = first; i < seen.size() && !seen[i]; i = edgeFrom[at(s.boundary[i][1])]) {
      seen[i] = 1;
      rims[count].push_back(
          {s.position[at(s.boundary[i][0])], s.position[at(s.boundary[i][1])], s.boundary[i][2]});
    }
    ++count;
  }
  return count == 2 ? std::optional(std::move(rims)) : std::nullopt;
}

double lengthOf(const std::vector<SourceSegment>& rim) {
  double length = 0.0;
  for (const SourceSegment& segment : rim)
    length += (segment.b - segment.a).norm();
  return length;
}

// Returns the widths that these shares of the area are below, and above.
std::pair<double, double> usualWidths(const PatchSurface& s, const std::vector<double>& width) {
  std::vector<std::pair<double, double>> widthAndArea;
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    double mean = 0.0;
    for (const int v : s.triangles[t])
      mean += width[at(v)] / 3.0;
    widthAndArea.emplace_back(mean, s.triangleArea[t]);
  }
  std::ranges::sort(widthAndArea);
  double sum = 0.0, low = widthAndArea.front().first, high = widthAndArea.back().first;
  for (const auto& [w, area] : widthAndArea) {
    if (sum <= kNarrowShare * s.areaMm2)
      low = w;
    if (sum <= (1.0 - kWideShare) * s.areaMm2)
      high = w;
    sum += area;
  }
  return {low, high};
}

// Returns the number of beads for these widths; 0 if none suits both, or if it is larger.
int beadsFor(double low, double high, const process::Process& process, int mostBeads) {
  const auto hatch = [&](double width) {
    return process::hatchOf(width, std::min(process.layerHeightMm, width));
  };
  const double least = hatch(process.beadWidthMinMm), usual = hatch(process.beadWidthMm),
               most = hatch(process.beadWidthMaxMm);
  const auto deviation = [&](int n) {
    return std::abs(std::log(std::sqrt(low * high) / n / usual));
  };
  int best = 0;
  for (int n = 1; n <= mostBeads + 1; ++n) {
    const bool isWideEnough = n == 1 ? low > kLeast * least : low > kSlack * n * least;
    if (isWideEnough && high < n * most && (best == 0 || deviation(n) < deviation(best)))
      best = n;
  }
  return best > mostBeads ? 0 : best;
}
} // namespace

std::vector<SurfaceCurve> thinRings(const PatchSurface& s, const process::Process& process,
                                    int mostBeads) {
  const auto rims = twoRims(s);
  if (!rims || mostBeads < 1)
    return {};
  // Quickly rule out patches that are wide.
  const double meanMm = s.areaMm2 / (0.5 * (lengthOf((*rims)[0]) + lengthOf((*rims)[1])));
  if (meanMm > mostBeads * process.beadWidthMaxMm)
    return {};
  const std::vector<double> outer = distanceToSegments(s, (*rims)[0], 1e9),
                            inner = distanceToSegments(s, (*rims)[1], 1e9);
  std::vector<double> width(s.position.size()), share(width.size());
  for (std::size_t v = 0; v < width.size(); ++v) {
    width[v] = outer[v] + inner[v];
    share[v] = outer[v] / std::max(width[v], 1e-9);
  }
  const auto [low, high] = usualWidths(s, width);
  const int n = beadsFor(low, high, process, mostBeads);
  std::vector<SurfaceCurve> rings;
  for (int k = 0; k < n; ++k) {
    std::vector<SurfaceCurve> ring = isolines(s, share, (k + 0.5) / n);
    // In sharp corners of coarse triangles there may be small islands.
    constexpr double kIsland = 0.1;
    double longest = 0.0;
    for (const SurfaceCurve& c : ring)
      longest = std::max(longest, lengthOf(c));
    std::erase_if(ring, [&](const SurfaceCurve& c) { return lengthOf(c) < kIsland * longest; });
    if (ring.size() != 1 || !ring.front().closed)
      return {};
    rings.push_back(std::move(ring.front()));
  }
  return rings;
}

} // namespace voluta::toolpath
