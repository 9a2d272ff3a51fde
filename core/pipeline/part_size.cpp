#include "pipeline/part_size.h"

#include "geometry/measures.h"
#include "plan/blocking_share.h"
#include "plan/finding_kinds.h"
#include "voxel/wall_thickness.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace voluta::pipeline {

namespace {

constexpr double kTinyMm = 1.0, kHugeMm = 2000.0;

// Returns the area-weighted median thickness of the thin places.
double usualMm(std::vector<voxel::ThinPlace> places, double areaMm2) {
  std::ranges::sort(places, {}, &voxel::ThinPlace::usualMm);
  double sum = 0.0;
  for (const voxel::ThinPlace& place : places)
    if (sum += place.areaMm2; sum >= 0.5 * areaMm2)
      return place.usualMm;
  return places.back().usualMm;
}

} // namespace

plan::Findings sizeFindings(const geometry::TriangleMesh& part, double scale,
                            const std::function<double()>& reach, const process::Process& process,
                            const base::RunContext& ctx) {
  const double size = geometry::bounds(part).sizes().maxCoeff();
  if (size < kTinyMm)
    return {plan::makeFinding(plan::FindingKind::TinyPart, {{"size", base::mm(size)}})};
  if (size > kHugeMm)
    return {plan::makeFinding(plan::FindingKind::HugePart, {{"size", base::mm(size)}})};
  const double minimum = process.beadWidthMinMm;
  const std::vector<voxel::ThinPlace> places =
      voxel::thinPlaces(part, minimum, ctx, process.layerHeightMinMm);
  const double area =
      std::accumulate(places.begin(), places.end(), 0.0,
                      [](double sum, const voxel::ThinPlace& p) { return sum + p.areaMm2; });
  // A wall has two sides, hence half the area.
  const double volume =
      std::accumulate(places.begin(), places.end(), 0.0, [](double sum, const voxel::ThinPlace& p) {
        return sum + 0.5 * p.areaMm2 * p.usualMm;
      });
  const double whole = std::max({std::abs(geometry::volume(part)), volume, 1e-9});
  const double share = volume / whole;
  if (places.empty() || share <= plan::kBlockingShare)
    return {};
  const double usual = usualMm(places, area);
  // Round up to a hundredth: rounding down would leave the wall too thin.
  const double wanted = std::ceil(100.0 * scale * minimum / std::max(usual, 1e-6)) / 100.0;
  std::vector<plan::NamedValue> values{{"share", base::percent(100.0 * share)},
                                       {"usual", base::mm(usual)},
                                       {"least", base::mm(minimum)}};
  const bool room = wanted <= reach();
  if (room)
    values.push_back({"scale", base::number(wanted)});
  plan::Finding thin =
      plan::makeFinding(room ? plan::FindingKind::ThinPart : plan::FindingKind::ThinPartInReach,
                        std::move(values), places.front().at);
  // The replay judges what beads make of thin walls among others.
  constexpr double kMostOfIt = 0.5;
  thin.blocking = share > kMostOfIt;
  return {thin};
}

double scaleWithin(double maximum) {
  constexpr double kSame = 1e-9;
  const double digits = std::pow(10.0, 2.0 - std::floor(std::log10(maximum)));
  return std::floor(maximum * digits + kSame) / digits;
}

plan::Finding tooLargeFinding(const motion::TooLarge& tooLarge, std::optional<double> scale) {
  std::vector<plan::NamedValue> values{{"share", base::percent(100.0 * tooLarge.share)}};
  if (!tooLarge.size || !scale)
    return plan::makeFinding(plan::FindingKind::MuchOutOfReach, std::move(values));
  values.push_back({"size", base::percent(100.0 * *tooLarge.size)});
  values.push_back({"scale", base::number(scaleWithin(*scale * *tooLarge.size))});
  return plan::makeFinding(plan::FindingKind::TooLarge, std::move(values));
}

} // namespace voluta::pipeline
