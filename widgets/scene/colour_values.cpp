#include "scene/colour_values.h"

#include "base/shown_number.h"
#include "layers/layer_stack.h"
#include "plan/tool_plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace voluta::scene {

namespace {

constexpr int kStops = 5;
constexpr double kLoneValue = 0.6; // position on the map of a constant value
constexpr std::array<base::Text, plan::kPathKinds> kKindNames{
    "Wall"_text,  "Infill"_text,        "Gap fill"_text, "Skirt or brim"_text, "Support"_text,
    "Prime"_text, "Sparse infill"_text, "Bridge"_text,   "Tape"_text,          "Shot"_text};

const std::vector<std::int32_t>* wholeNumbers(const ColourValues& v, ColourBy by) {
  switch (by) {
  case ColourBy::Layer:
    return &v.layer;
  case ColourBy::Group:
    return &v.group;
  case ColourBy::Kind:
    return &v.kind;
  case ColourBy::Part:
    return &v.item;
  case ColourBy::Tool:
    return &v.tool;
  case ColourBy::Region:
    return &v.region;
  default:
    return nullptr;
  }
}

const std::vector<float>* numbers(const ColourValues& v, ColourBy by) {
  switch (by) {
  case ColourBy::Height:
    return &v.height;
  case ColourBy::Spacing:
    return v.heights.known() ? &v.height : nullptr;
  case ColourBy::Width:
    return &v.width;
  case ColourBy::Speed:
    return &v.speed;
  case ColourBy::Time:
    return &v.minutes;
  case ColourBy::LayerTime:
    return &v.layerTimeS;
  case ColourBy::Direction:
    return &v.tiltDeg;
  default:
    return nullptr;
  }
}

struct Span {
  double low = 0.0, high = 0.0;
  double share(double value) const {
    return high > low ? (value - low) / (high - low) : kLoneValue;
  }
};

// Ignores the outermost hundredth on both sides, which would compress the rest of the scale.
Span spanOf(const std::vector<float>& values) {
  if (values.empty())
    return {};
  std::vector<float> sample;
  const std::size_t step = std::max<std::size_t>(1, values.size() / 20000);
  for (std::size_t i = 0; i < values.size(); i += step)
    sample.push_back(values[i]);
  std::sort(sample.begin(), sample.end());
  const std::size_t cut = sample.size() / 100;
  const Span span{sample[cut], sample[sample.size() - 1 - cut]};
  return span.high - span.low > 1e-3 ? span : Span{span.low, span.low};
}

Span spanOf(const ColourValues& values, ColourBy by) {
  if (by == ColourBy::Layer) {
    const auto highest = std::max_element(values.layer.begin(), values.layer.end());
    return {0.0, highest == values.layer.end() ? 0.0 : double(*highest)};
  }
  const Span span = spanOf(*numbers(values, by));
  // Scales of time and tilt start at zero.
  return by == ColourBy::Time || by == ColourBy::Direction ? Span{0.0, span.high} : span;
}

// Returns the number with the precision that a scale of that width needs, without trailing zeros if
// the scale has one value only.
std::string scaleNumber(double value, double width) {
  if (width <= 0.0) {
    const base::ShownNumber shown = base::shownNumber(value, 3);
    return fmt::format("{:.{}f}", shown.value, shown.decimals);
  }
  return fmt::format("{:.{}f}", value, width > 20 ? 0 : width > 2 ? 1 : 2);
}

Legend scaleLegend(const ColourByRow& row, const Span& span) {
  Legend legend{row.label, std::string(row.unit), false, false, {}, {}};
  const int stops = span.high > span.low ? kStops : 1;
  for (int i = 0; i < stops; ++i) {
    const double t = stops > 1 ? double(i) / (stops - 1) : kLoneValue;
    const double value = stops > 1 ? span.low + t * (span.high - span.low) : span.low;
    const double width = span.high - span.low;
    const bool counted = row.colourBy == ColourBy::Layer || row.colourBy == ColourBy::GrowthStep ||
                         row.colourBy == ColourBy::Peeling;
    std::string label = counted ? fmt::format("{}", static_cast<int>(std::lround(value)) + 1)
                                : scaleNumber(value, width);
    legend.entries.push_back({value, std::move(label), sequentialColour(t)});
  }
  return legend;
}

const ColourByRow& rowOf(ColourBy by) {
  return colourByTable()[static_cast<std::size_t>(by)];
}

} // namespace

ColourBy shownColouring(const ColourValues& values, ColourBy asked) {
  const auto* whole = wholeNumbers(values, asked);
  const auto* real = numbers(values, asked);
  return (whole && !whole->empty()) || (real && !real->empty()) ? asked : ColourBy::Layer;
}

namespace {
// Both limits and the nominal height are stops of the scale.
Legend spacingLegend(const HeightLimits& heights) {
  const ColourByRow& row = rowOf(ColourBy::Spacing);
  Legend legend{row.label, std::string(row.unit), false, true, {}, {}};
  const double low = heights.minMm, middle = heights.nominalMm, high = heights.maxMm;
  for (const auto& [value, note] :
       {std::pair(low, "limit"_text), std::pair((low + middle) / 2, base::Text()),
        std::pair(middle, "nominal"_text), std::pair((middle + high) / 2, base::Text()),
        std::pair(high, "limit"_text)})
    legend.entries.push_back(
        {value, fmt::format("{:.2f}", value), divergingColour(heights.shareOf(value)), note});
  legend.marks.push_back({0.0, "Too thick to print"_text, tooThickColour()});
  legend.marks.push_back({0.0, "Too thin to print"_text, tooThinColour()});
  return legend;
}
} // namespace

Legend voxelLegend(const VoxelDrawing& voxels, const Theme& theme) {
  Legend legend =
      scaleLegend(rowOf(voxels.colouredBy), {0.0, double(std::max(voxels.highest, 1) - 1)});
  if (voxels.bySteps)
    legend.marks.push_back({0.0, "Current growth step"_text, theme.current});
  const auto add = [&](base::Text label, const Colour& colour, std::size_t count) {
    if (count > 0)
      legend.marks.push_back({0.0, label, colour, count});
  };
  add("Support"_text, supportColour(), voxels.support);
  add("Missed, shadowed"_text, theme.blocked, voxels.lost[0]);
  add("Missed, unreached"_text, theme.unreached, voxels.lost[1]);
  add("Missed, cascade"_text, theme.cascade, voxels.lost[2]);
  return legend;
}

namespace {
base::Value categoryName(ColourBy colourBy, std::int32_t v) {
  if (colourBy == ColourBy::Kind)
    return kKindNames[static_cast<std::size_t>(v) % kKindNames.size()];
  if (colourBy == ColourBy::Region)
    return v == 0 ? base::Value("Part"_text) : base::Value(v);
  if (colourBy == ColourBy::Group && v == layers::kSupportGroup)
    return "Support"_text;
  if (colourBy == ColourBy::Group && v >= layers::kRegionGroups)
    return base::message("Region {number}"_text, v - layers::kRegionGroups + 1);
  return v + 1;
}
} // namespace

Legend legendOf(const ColourValues& values, ColourBy colourBy) {
  const ColourByRow& row = rowOf(colourBy);
  if (colourBy == ColourBy::Spacing)
    return spacingLegend(values.heights);
  if (!row.categorical)
    return scaleLegend(row, spanOf(values, colourBy));
  std::vector<std::int32_t> present = *wholeNumbers(values, colourBy);
  std::sort(present.begin(), present.end());
  present.erase(std::unique(present.begin(), present.end()), present.end());
  Legend legend{row.label, std::string(row.unit), true, false, {}, {}};
  for (const std::int32_t v : present)
    legend.entries.push_back({double(v), categoryName(colourBy, v), categoricalColour(v)});
  return legend;
}

std::vector<std::uint8_t> coloursOf(const ColourValues& values, ColourBy colourBy, int repeat) {
  const auto bytes = [](const Colour& c) {
    std::array<std::uint8_t, 3> b{};
    for (std::size_t k = 0; k < 3; ++k)
      b[k] = static_cast<std::uint8_t>(std::lround(255.0 * c[k]));
    return b;
  };
  std::vector<std::uint8_t> out;
  const auto add = [&](const std::array<std::uint8_t, 3>& b) {
    for (int r = 0; r < repeat; ++r)
      out.insert(out.end(), b.begin(), b.end());
  };
  if (rowOf(colourBy).categorical) {
    const auto& whole = *wholeNumbers(values, colourBy);
    out.reserve(3 * whole.size() * static_cast<std::size_t>(repeat));
    for (const std::int32_t v : whole)
      add(bytes(categoricalColour(v)));
    return out;
  }
  if (colourBy == ColourBy::Spacing) {
    const auto thin = bytes(tooThinColour()), thick = bytes(tooThickColour());
    std::array<std::array<std::uint8_t, 3>, 256> map{};
    for (std::size_t i = 0; i < map.size(); ++i)
      map[i] = bytes(divergingColour(double(i) / 255.0));
    // Layers are clamped to the limits; a layer at a limit is within it.
    constexpr double kSlack = 1e-3;
    out.reserve(3 * values.height.size() * static_cast<std::size_t>(repeat));
    for (const float height : values.height) {
      const double t = values.heights.shareOf(double(height));
      add(t < -kSlack ? thin
          : t > 1 + kSlack
              ? thick
              : map[static_cast<std::size_t>(std::clamp(255.0 * t + 0.5, 0.0, 255.0))]);
    }
    return out;
  }
  std::array<std::array<std::uint8_t, 3>, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i)
    table[i] = bytes(sequentialColour(double(i) / 255.0));
  const Span span = spanOf(values, colourBy);
  const auto addValue = [&](double v) {
    add(table[static_cast<std::size_t>(std::clamp(255.0 * span.share(v) + 0.5, 0.0, 255.0))]);
  };
  if (colourBy == ColourBy::Layer) {
    out.reserve(3 * values.layer.size() * static_cast<std::size_t>(repeat));
    for (const std::int32_t v : values.layer)
      addValue(v);
  } else {
    const auto& real = *numbers(values, colourBy);
    out.reserve(3 * real.size() * static_cast<std::size_t>(repeat));
    for (const float v : real)
      addValue(double(v));
  }
  return out;
}

} // namespace voluta::scene
