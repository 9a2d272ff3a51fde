#include "process/process_numbers.h"

#include "process/feature_flow.h"

namespace voluta::process {

namespace {
constexpr double kMaxMm = 1000.0, kMaxMmPerS = 5000.0, kMaxMmPerS2 = 100000.0;
constexpr double kMaxMm3PerS = 1e7, kMaxS = 600.0;

constexpr base::Text kBeads = "Beads"_text, kSpeeds = "Speeds"_text, kExtruder = "Extruder"_text,
                     kBridges = "Bridges"_text, kHead = "Head"_text, kSizes = "Sizes"_text;
constexpr double kMinScale = 0.9, kMaxScale = 1.1, kMaxOffsetMm = 2.0;

constexpr std::array kNumbers{
    ProcessNumber{"nozzleDiameterMm", "mm", &Process::nozzleDiameterMm, kMaxMm, kBeads,
                  "nozzle diameter"_text, "Diameter of the nozzle's opening."_text},
    ProcessNumber{"layerHeightMm.default", "mm", &Process::layerHeightMm, kMaxMm, kBeads,
                  "layer height"_text, "Usual height of a layer, and of a bead."_text},
    ProcessNumber{"layerHeightMm.min", "mm", &Process::layerHeightMinMm, kMaxMm, kBeads,
                  "minimum layer height"_text, "Curved layers are nowhere thinner."_text},
    ProcessNumber{"layerHeightMm.max", "mm", &Process::layerHeightMaxMm, kMaxMm, kBeads,
                  "maximum layer height"_text, "Curved layers are nowhere thicker."_text},
    ProcessNumber{"beadWidthMm.default", "mm", &Process::beadWidthMm, kMaxMm, kBeads,
                  "bead width"_text, "Usual width of a bead."_text},
    ProcessNumber{"beadWidthMm.min", "mm", &Process::beadWidthMinMm, kMaxMm, kBeads,
                  "minimum bead width"_text, "Beads are nowhere narrower."_text},
    ProcessNumber{"beadWidthMm.max", "mm", &Process::beadWidthMaxMm, kMaxMm, kBeads,
                  "maximum bead width"_text, "Beads are nowhere wider."_text},
    ProcessNumber{"stepMm", "mm", &Process::stepMm, kMaxMm, kBeads, "waypoint distance"_text,
                  "Distance of waypoints along a tool-path."_text},
    ProcessNumber{"speedMmPerS", "mm/s", &Process::speedMmPerS, kMaxMmPerS, kSpeeds,
                  "print speed"_text, "Usual speed of the nozzle while it prints."_text},
    ProcessNumber{"travelSpeedMmPerS", "mm/s", &Process::travelSpeedMmPerS, kMaxMmPerS, kSpeeds,
                  "travel speed"_text, "Speed of the nozzle between tool-paths."_text},
    ProcessNumber{"accelerationMmPerS2", "mm/s²", &Process::accelerationMmPerS2, kMaxMmPerS2,
                  kSpeeds, "acceleration"_text, "Maximum acceleration of the nozzle."_text},
    ProcessNumber{"maxFlowMm3PerS", "mm³/s", &Process::maxFlowMm3PerS, kMaxMm3PerS, kExtruder,
                  "maximum flow"_text, "Flow at full scale of the analogue output."_text},
    ProcessNumber{"primeS", "s", &Process::primeS, kMaxS, kExtruder, "prime time"_text,
                  "The extruder runs this long before a tool-path begins."_text, true},
    ProcessNumber{"retractMm", "mm", &Process::retractMm, kMaxMm, kExtruder,
                  "retraction length"_text,
                  "Length of filament that is retracted for a travel. 0: none."_text, true, true},
    ProcessNumber{"bridgeMm", "mm", &Process::bridgeMm, kMaxMm, kBridges, "longest bridge"_text,
                  "Maximum length of an unsupported bridge."_text, true, true},
    ProcessNumber{"bridgeSpeedMmPerS", "mm/s", &Process::bridgeSpeedMmPerS, kMaxMmPerS, kBridges,
                  "bridge speed"_text, "Maximum speed on a bridge."_text, false, true},
    ProcessNumber{"contactToleranceMm", "mm", &Process::contactToleranceMm, kMaxMm, kHead,
                  "contact tolerance"_text,
                  "How deep the head may enter soft beads before it is a collision."_text, true},
    ProcessNumber{"scaleX", "", &Process::scaleX, kMaxScale, kSizes, "size factor along x"_text,
                  "Flat layers are made larger by it, so that printed lengths are right. 1: "
                  "none."_text,
                  false, true, kMinScale, true},
    ProcessNumber{"scaleY", "", &Process::scaleY, kMaxScale, kSizes, "size factor along y"_text,
                  "As along x."_text, false, true, kMinScale, true},
    ProcessNumber{"outlineOffsetMm", "mm", &Process::outlineOffsetMm, kMaxOffsetMm, kSizes,
                  "outline offset"_text, "Outlines of flat layers move outwards by it."_text, true,
                  true, -kMaxOffsetMm, true},
    ProcessNumber{"holeOffsetMm", "mm", &Process::holeOffsetMm, kMaxOffsetMm, kSizes,
                  "hole offset"_text,
                  "Contours of holes in flat layers move into the material by it."_text, true, true,
                  -kMaxOffsetMm, true},
};

constexpr FeatureNumber speedOf(Feature feature, std::string_view key, base::Text label) {
  return {feature, key,        "speedMmPerS", "mm/s", &FeatureSettings::speedMmPerS,
          0.0,     kMaxMmPerS, label};
}
constexpr FeatureNumber flowOf(Feature feature, std::string_view key, base::Text label) {
  return {feature, key, "flow", "", &FeatureSettings::flow, kMinFlow, kMaxFlow, label};
}
constexpr FeatureNumber widthOf(Feature feature, std::string_view key, base::Text label) {
  return {feature, key, "widthMm", "mm", &FeatureSettings::widthMm, 0.0, kMaxMm, label};
}

constexpr std::array kFeatureNumbers{
    speedOf(Feature::OuterWall, "outerWall", "outer-wall speed"_text),
    flowOf(Feature::OuterWall, "outerWall", "outer-wall flow"_text),
    widthOf(Feature::OuterWall, "outerWall", "outer-wall width"_text),
    speedOf(Feature::InnerWall, "innerWall", "inner-wall speed"_text),
    flowOf(Feature::InnerWall, "innerWall", "inner-wall flow"_text),
    speedOf(Feature::Infill, "infill", "infill speed"_text),
    flowOf(Feature::Infill, "infill", "infill flow"_text),
    speedOf(Feature::SparseInfill, "sparseInfill", "sparse-infill speed"_text),
    flowOf(Feature::SparseInfill, "sparseInfill", "sparse-infill flow"_text),
    flowOf(Feature::Bridge, "bridge", "bridge flow"_text),
    speedOf(Feature::Support, "support", "support speed"_text),
    flowOf(Feature::Support, "support", "support flow"_text),
    widthOf(Feature::Support, "support", "support width"_text),
    speedOf(Feature::FirstLayer, "firstLayer", "first-layer speed"_text),
    flowOf(Feature::FirstLayer, "firstLayer", "first-layer flow"_text),
    widthOf(Feature::FirstLayer, "firstLayer", "first-layer width"_text),
};
} // namespace

std::span<const ProcessNumber> processNumbers() {
  return kNumbers;
}

bool isOfTape(const ProcessNumber& row) {
  return row.key.starts_with("layerHeightMm") || row.key.starts_with("beadWidthMm") ||
         row.key == "speedMmPerS" || row.key.starts_with("bridge");
}

std::span<const FeatureNumber> featureNumbers() {
  return kFeatureNumbers;
}

} // namespace voluta::process
