// Cutters, and the speeds and loads with which they cut a material (Castelli 7.2.4, table 7.2).
#pragma once

#include "base/text.h"

#include <span>
#include <string_view>

namespace voluta::milling {

// With a round end.
struct Cutter {
  double diameterMm = 3.175;
  int teeth = 1;

  double radiusMm() const { return 0.5 * diameterMm; }
};

struct CuttingData {
  std::string_view id;
  base::Text label;
  double rpm = 0.0;
  double feedPerToothMm = 0.0;
  double sideLoad = 0.0;   // distance of neighbouring lines, in diameters
  double depthOfCut = 0.0; // of one pass, in diameters
};

// Returns the table of materials.
std::span<const CuttingData> cuttingData();
// Returns nullptr if there is no such material.
const CuttingData* cuttingDataFor(std::string_view id);

// Returns the feed of the table [mm/min].
double feedMmPerMin(const Cutter& cutter, const CuttingData& data);
// Returns the distance of lines, h_layer, and the depth of a fine pass, p_adv [mm].
double lineDistanceMm(const Cutter& cutter, const CuttingData& data);
double finePassMm(const Cutter& cutter, const CuttingData& data);

// Returns the height of the ridge between two lines of a round cutter on a plane [mm].
double ridgeOnPlaneMm(double radiusMm, double distanceMm);
// Returns the height of the ridge, along the sphere's normal, between two lines on a sphere of that
// radius that are `atMm` and `atMm` + distanceMm from its middle. Precondition: the cutter touches
// the sphere on both lines.
double ridgeOnSphereMm(double radiusMm, double sphereMm, double atMm, double distanceMm);

} // namespace voluta::milling
