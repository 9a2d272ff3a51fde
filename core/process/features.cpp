#include "process/features.h"

#include "base/json_node.h"
#include "base/units.h"
#include "process/feature_flow.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace voluta::process {

namespace {
using base::JsonNode;

constexpr std::array<FeatureRow, kFeatures> kRows{{
    {.feature = Feature::OuterWall, .key = "outerWall", .hasWidth = true},
    {.feature = Feature::InnerWall, .key = "innerWall"},
    {.feature = Feature::Infill, .key = "infill"},
    {.feature = Feature::SparseInfill, .key = "sparseInfill"},
    {.feature = Feature::Bridge, .key = "bridge", .hasSpeed = false},
    {.feature = Feature::Support, .key = "support", .hasWidth = true},
    {.feature = Feature::FirstLayer, .key = "firstLayer", .hasWidth = true},
}};

double readFlow(const JsonNode& node) {
  const double flow = node.positive();
  if (flow < kMinFlow || flow > kMaxFlow)
    node.fail(base::message("must be between {least} and {most}"_text, base::number(kMinFlow),
                            base::number(kMaxFlow)));
  return flow;
}

double readWidth(const JsonNode& node, double minMm, double maxMm) {
  const double width = node.positive();
  if (width < minMm || width > maxMm)
    node.fail(
        base::message("must be between {least} and {most}"_text, base::mm(minMm), base::mm(maxMm)));
  return width;
}

} // namespace

double OverhangSpeed::at(double overhang) const {
  const double place = std::clamp(overhang, 0.0, 1.0) * static_cast<double>(shares.size());
  const auto next = std::min(static_cast<std::size_t>(place), shares.size() - 1);
  return std::lerp(next == 0 ? 1.0 : shares[next - 1], shares[next],
                   place - static_cast<double>(next));
}

OverhangSpeed readOverhangSpeed(const JsonNode& node) {
  constexpr double kSlowest = 0.05;
  OverhangSpeed speed;
  const std::vector<JsonNode> items = node.items();
  if (items.size() != speed.shares.size())
    node.fail("must have four shares, for 25, 50, 75 and 100 % of the width"_text);
  double before = 1.0;
  for (std::size_t i = 0; i < items.size(); ++i) {
    const double share = speed.shares[i] = items[i].number();
    if (share < kSlowest || share > 1.0)
      items[i].fail(base::message("must be between {least} and {most}"_text, base::number(kSlowest),
                                  base::number(1.0)));
    if (share > before)
      items[i].fail("is more than with less overhang"_text);
    before = share;
  }
  return speed;
}

std::span<const FeatureRow> featureRows() {
  return kRows;
}

FeatureTable readFeatures(const JsonNode& node, const WidthRange& widths) {
  node.allowOnly(
      {"outerWall", "innerWall", "infill", "sparseInfill", "bridge", "support", "firstLayer"});
  FeatureTable table;
  for (const FeatureRow& row : kRows) {
    if (!node.has(row.key))
      continue;
    const JsonNode own = node.at(row.key);
    if (row.hasWidth)
      own.allowOnly({"speedMmPerS", "flow", "widthMm"});
    else if (row.hasSpeed)
      own.allowOnly({"speedMmPerS", "flow"});
    else
      own.allowOnly({"flow"});
    FeatureSettings& settings = table.of(row.feature);
    if (own.has("speedMmPerS"))
      settings.speedMmPerS = own.at("speedMmPerS").positive();
    if (own.has("flow"))
      settings.flow = readFlow(own.at("flow"));
    if (own.has("widthMm"))
      settings.widthMm = readWidth(
          own.at("widthMm"), row.feature == Feature::OuterWall ? widths.usualMm : widths.minMm,
          widths.maxMm);
  }
  return table;
}

} // namespace voluta::process
