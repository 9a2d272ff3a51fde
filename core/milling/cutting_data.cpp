#include "milling/cutting_data.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace voluta::milling {

namespace {
constexpr std::array kData{
    CuttingData{"hard-plastic", "Hard plastic"_text, 8500.0, 0.0254, 0.5, 0.8},
    CuttingData{"soft-plastic", "Soft plastic"_text, 8500.0, 0.0381, 0.6, 0.7},
};
} // namespace

std::span<const CuttingData> cuttingData() {
  return kData;
}

const CuttingData* cuttingDataFor(std::string_view id) {
  const auto* at = std::ranges::find(kData, id, &CuttingData::id);
  return at == kData.end() ? nullptr : at;
}

double feedMmPerMin(const Cutter& cutter, const CuttingData& data) {
  return data.feedPerToothMm * cutter.teeth * data.rpm;
}

double lineDistanceMm(const Cutter& cutter, const CuttingData& data) {
  return data.sideLoad * cutter.diameterMm;
}

double finePassMm(const Cutter& cutter, const CuttingData& data) {
  return data.depthOfCut * cutter.diameterMm;
}

double ridgeOnPlaneMm(double radiusMm, double distanceMm) {
  const double half = std::min(0.5 * distanceMm, radiusMm);
  return radiusMm - std::sqrt(radiusMm * radiusMm - half * half);
}

double ridgeOnSphereMm(double radiusMm, double sphereMm, double atMm, double distanceMm) {
  const double reach = sphereMm + radiusMm;
  const double angle = std::asin((atMm + distanceMm) / reach) - std::asin(atMm / reach);
  const double lateral = reach * std::sin(0.5 * angle);
  return reach * std::cos(0.5 * angle) -
         std::sqrt(std::max(0.0, radiusMm * radiusMm - lateral * lateral)) - sphereMm;
}

} // namespace voluta::milling
