#include "process/feature_parameters.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace voluta::process {

namespace {

constexpr double kFastestMmPerS = 500.0;

struct SpeedRow {
  Feature feature;
  std::string_view key;
  base::Text label, help;
};

constexpr std::array kSpeeds{
    SpeedRow{Feature::OuterWall, "outerWallSpeedMmPerS", "outer-wall speed"_text,
             "Speed of the outermost walls. 0: that of the process."_text},
    SpeedRow{Feature::InnerWall, "innerWallSpeedMmPerS", "inner-wall speed"_text,
             "Speed of all other walls. 0: that of the process."_text},
    SpeedRow{Feature::Infill, "infillSpeedMmPerS", "infill speed"_text,
             "Speed of solid infill and gap fill, limited by the extruder's flow. 0: that of the "
             "process."_text},
    SpeedRow{Feature::Support, "supportSpeedMmPerS", "support speed"_text,
             "Speed of supports. 0: that of the process."_text},
    SpeedRow{Feature::FirstLayer, "firstLayerSpeedMmPerS", "first-layer speed"_text,
             "Speed of all beads of the first layer and of the brim. 0: that of the process."_text},
};

} // namespace

base::ParameterTable featureParameters() {
  std::vector<base::ParameterSpec> specs;
  for (const SpeedRow& row : kSpeeds)
    specs.push_back(base::numberParameter(std::string(row.key), "mm/s", 0.0, 0.0, kFastestMmPerS,
                                          "Beads"_text, row.label, row.help));
  return base::ParameterTable(std::move(specs));
}

void setFeatureSpeeds(FeatureTable& features, const base::ParameterValues& values) {
  for (const SpeedRow& row : kSpeeds)
    if (const double speed = values.number(row.key); speed > 0.0)
      features.of(row.feature).speedMmPerS = speed;
}

} // namespace voluta::process
