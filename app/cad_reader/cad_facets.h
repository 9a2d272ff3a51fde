// The facets of a body of a CAD document.
#pragma once

#include "cad_bodies.h"

#include <array>
#include <string>
#include <vector>

namespace voluta::cad_reader {

struct BodyFacets {
  std::string name;
  std::array<double, 3> place{}; // of the coordinates' origin in the file
  std::vector<double> corners;   // nine for each facet, counter-clockwise seen from outside
};

// Neighbouring faces share their corners. Counts faces without facets in `omitted`.
BodyFacets facetsOf(const Body& body, double chordMm, double angleRad, Omitted& omitted);

} // namespace voluta::cad_reader
