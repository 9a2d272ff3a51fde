#include "scene/colouring.h"

#include "base/error.h"
#include "base/nearest_name.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace voluta::scene {

const std::vector<ColourByRow>& colourByTable() {
  static const std::vector<ColourByRow> table{
      {ColourBy::Layer, "layer", "Layer"_text, "", false},
      {ColourBy::Group, "group", "Group"_text, "", true},
      {ColourBy::Kind, "kind", "Kind"_text, "", true},
      {ColourBy::Height, "height", "Height"_text, "mm", false},
      {ColourBy::Width, "width", "Width"_text, "mm", false},
      {ColourBy::Speed, "speed", "Speed"_text, "mm/s", false},
      {ColourBy::Time, "time", "Time"_text, "min", false},
      {ColourBy::LayerTime, "layerTime", "Layer time"_text, "s", false},
      {ColourBy::Direction, "direction", "Tilt of the nozzle"_text, "deg", false},
      {ColourBy::Spacing, "spacing", "Layer spacing"_text, "mm", false},
      {ColourBy::GrowthStep, "growth", "Growth step"_text, "", false},
      {ColourBy::Peeling, "peeling", "Peeling rank"_text, "", false},
      {ColourBy::Tool, "tool", "Tool"_text, "", true},
      {ColourBy::Part, "part", "Part"_text, "", true},
      {ColourBy::Region, "region", "Region"_text, "", true},
  };
  return table;
}

ColourBy colourByOf(std::string_view id) {
  std::vector<std::string> ids;
  for (const ColourByRow& row : colourByTable()) {
    if (row.id == id)
      return row.colourBy;
    ids.emplace_back(row.id);
  }
  throw base::Error(base::ErrorCode::Usage, base::message("unknown colour '{name}'"_text, id), {},
                    base::message("did you mean '{name}'?"_text, base::nearestName(id, ids)));
}

namespace {

// Hue changes from violet-blue over green to yellow while lightness increases evenly: neighbouring
// steps stay distinguishable for every kind of colour vision. Stops in CIE L*a*b*.
struct Lab {
  double l, a, b;
};
constexpr std::array<Lab, 6> kSequential{
    {{22, 30, -38}, {36, 6, -38}, {50, -18, -18}, {64, -34, 10}, {78, -28, 44}, {92, -6, 66}}};
// Blue and brown are distinguishable for every kind of colour vision; both ends are equally dark.
constexpr std::array<Lab, 5> kDiverging{
    {{34, 10, -48}, {63, -8, -30}, {95, 0, 3}, {74, 0, 54}, {34, 3, 40}}};

double linearToSrgb(double v) {
  v = std::clamp(v, 0.0, 1.0);
  return v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1.0 / 2.4) - 0.055;
}

Colour srgbOf(const Lab& lab) {
  const auto cube = [](double f) {
    constexpr double d = 6.0 / 29.0;
    return f > d ? f * f * f : 3.0 * d * d * (f - 4.0 / 29.0);
  };
  const double fy = (lab.l + 16.0) / 116.0;
  const double x = 0.95047 * cube(fy + lab.a / 500.0);
  const double y = cube(fy);
  const double z = 1.08883 * cube(fy - lab.b / 200.0);
  return {linearToSrgb(3.2406 * x - 1.5372 * y - 0.4986 * z),
          linearToSrgb(-0.9689 * x + 1.8758 * y + 0.0415 * z),
          linearToSrgb(0.0557 * x - 0.2040 * y + 1.0570 * z)};
}

template <std::size_t N> Colour colourAt(const std::array<Lab, N>& stops, double t) {
  const double place = std::clamp(std::isfinite(t) ? t : 0.0, 0.0, 1.0) * (N - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(place), N - 2);
  const double f = place - static_cast<double>(i);
  const Lab &p = stops[i], &q = stops[i + 1];
  return srgbOf({p.l + f * (q.l - p.l), p.a + f * (q.a - p.a), p.b + f * (q.b - p.b)});
}

} // namespace

Colour sequentialColour(double t) {
  return colourAt(kSequential, t);
}

Colour divergingColour(double t) {
  return colourAt(kDiverging, t);
}

Colour tooThinColour() {
  return {0.20, 0.90, 0.98};
}

Colour tooThickColour() {
  return {1.00, 0.93, 0.25};
}

Colour supportColour() {
  return {0.34, 0.71, 0.91};
}

Colour pieceColour(int index) {
  static constexpr Colour kColours[] = {{0.00, 0.45, 0.70}, {0.90, 0.62, 0.00}, {0.00, 0.62, 0.45},
                                        {0.94, 0.89, 0.26}, {0.53, 0.80, 0.93}, {0.36, 0.27, 0.72},
                                        {0.42, 0.25, 0.06}, {0.95, 0.88, 0.71}, {0.70, 0.67, 0.88}};
  constexpr double kDarker = 0.62;
  const auto i = static_cast<std::size_t>(index);
  Colour colour = kColours[i % std::size(kColours)];
  if (i / std::size(kColours) % 2 == 1)
    for (double& c : colour)
      c *= kDarker;
  return colour;
}

Colour categoricalColour(int index) {
  static constexpr Colour kColours[] = {{0.00, 0.45, 0.70}, {0.90, 0.62, 0.00}, {0.00, 0.62, 0.45},
                                        {0.80, 0.47, 0.65}, {0.34, 0.71, 0.91}, {0.94, 0.89, 0.26},
                                        {0.45, 0.45, 0.45}, {0.36, 0.27, 0.72}, {0.33, 0.38, 0.06},
                                        {0.62, 0.87, 0.55}};
  return kColours[static_cast<std::size_t>(index) % std::size(kColours)];
}

} // namespace voluta::scene
