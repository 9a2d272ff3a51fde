#include "scene/colour_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace voluta::scene {

namespace {

constexpr int kStops = 5;
constexpr double kLoneValue = 0.6; // place on the map of a value that is the same everywhere
constexpr std::array<const char*, 5> kKindNames{"Wall", "Infill", "Gap fill", "Skirt", "Support"};

const std::vector<std::int32_t>* wholeNumbers(const ColourValues& v, ColourBy by) {
  switch (by) {
  case ColourBy::Layer:
    return &v.layer;
  case ColourBy::Group:
    return &v.group;
  case ColourBy::Kind:
    return &v.kind;
  default:
    return nullptr;
  }
}

const std::vector<float>* numbers(const ColourValues& v, ColourBy by) {
  switch (by) {
  case ColourBy::Height:
    return &v.height;
  case ColourBy::Width:
    return &v.width;
  case ColourBy::Speed:
    return &v.speed;
  case ColourBy::Time:
    return &v.minutes;
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

// Without the outermost hundredth on both sides, which would flatten all the rest.
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
  // Time and tilt are read from nought.
  return by == ColourBy::Time || by == ColourBy::Direction ? Span{0.0, span.high} : span;
}

// As exact as a scale of that width needs; without idle zeros where it has one value only.
std::string scaleNumber(double value, double width) {
  if (width <= 0.0)
    return fmt::format("{:.3g}", value);
  return fmt::format("{:.{}f}", value, width > 20 ? 0 : width > 2 ? 1 : 2);
}

Legend scaleLegend(const ColourByRow& row, const Span& span) {
  Legend legend{std::string(row.label), std::string(row.unit), false, {}};
  const int stops = span.high > span.low ? kStops : 1;
  for (int i = 0; i < stops; ++i) {
    const double t = stops > 1 ? double(i) / (stops - 1) : kLoneValue;
    const double value = stops > 1 ? span.low + t * (span.high - span.low) : span.low;
    const double width = span.high - span.low;
    std::string label = row.colourBy == ColourBy::Layer
                            ? fmt::format("{}", static_cast<int>(std::lround(value)) + 1)
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

Legend layerLegend(int layers) {
  return scaleLegend(rowOf(ColourBy::Layer), {0.0, double(std::max(layers, 1) - 1)});
}

Legend legendOf(const ColourValues& values, ColourBy colourBy) {
  const ColourByRow& row = rowOf(colourBy);
  if (!row.categorical)
    return scaleLegend(row, spanOf(values, colourBy));
  std::vector<std::int32_t> present = *wholeNumbers(values, colourBy);
  std::sort(present.begin(), present.end());
  present.erase(std::unique(present.begin(), present.end()), present.end());
  Legend legend{std::string(row.label), std::string(row.unit), true, {}};
  for (const std::int32_t v : present)
    legend.entries.push_back({double(v),
                              colourBy == ColourBy::Kind
                                  ? kKindNames[static_cast<std::size_t>(v) % kKindNames.size()]
                                  : fmt::format("{}", v + 1),
                              categoricalColour(v)});
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
