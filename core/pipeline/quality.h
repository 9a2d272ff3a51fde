// How far a printed part may differ from the requested one: the limits of the second verdict,
// "prints as asked" (docs/design.md, Replay). They never change what is safe to run.
#pragma once

#include "base/parameters.h"
#include "base/text.h"
#include "plan/finding.h"
#include "replay/verification.h"

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::pipeline {

// A figure of the second verdict. One row per figure.
struct QualityFigure {
  std::string_view id; // as typed: "uncovered"
  base::Text label;
  plan::FindingKind kind, givenKind; // findings beyond the limit; of planned and of given paths
  double replay::ReplayThresholds::*limit;
  bool isMinimum = false; // the limit is 1 - share
};
std::span<const QualityFigure> qualityFigures();

// A set of limits. `shares` in the order of qualityFigures().
struct QualityLevel {
  std::string_view id;
  base::Text label;
  std::array<double, 5> shares;
  bool bridgesMaySag = false;
};
// From the strictest to the most lenient one.
std::span<const QualityLevel> qualityLevels();

// A share up to which the user accepts a figure.
struct AcceptedShare {
  const QualityFigure* figure = nullptr;
  double share = 0.0;
};

struct Quality {
  std::string level = "strict";
  std::vector<AcceptedShare> accepted;
};

// Parameters `quality` and `accept`.
base::ParameterTable qualityParameters();
// Throws Error{Usage} if `accept` is not a list such as "uncovered=0.05, mass=0.04".
Quality qualityOf(const base::ParameterValues& values);
std::string textOf(const std::vector<AcceptedShare>& accepted);
// Returns the accepted shares that replace a stricter limit of the level. The others accept
// nothing.
std::vector<AcceptedShare> beyondLevel(const Quality& quality);

// Returns the level's limits; an accepted share replaces a stricter limit.
replay::ReplayThresholds thresholdsOf(const Quality& quality);

// Returns the value of parameter `accept` with which this finding is within the limit: its share,
// rounded up to half a percent, with those accepted already. nullopt if no figure has this
// finding.
std::optional<std::string> acceptedWith(const Quality& quality, const plan::Finding& finding);

} // namespace voluta::pipeline
