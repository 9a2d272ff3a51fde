// The numbers of a process's file, one row each: the reader checks them, the window's editor shows
// them.
#pragma once

#include "base/text.h"
#include "process/process.h"

#include <array>
#include <span>
#include <string_view>

namespace voluta::process {

struct ProcessNumber {
  std::string_view key; // In the file; "layerHeightMm.min" is a member of "layerHeightMm"
  std::string_view unit;
  double Process::*value;
  double maximum = 0.0; // Inclusive; more is a wrong unit
  base::Text group, label, help;
  bool mayBeZero = false, optional = false;
  // Minimum of a number that may be negative or has a range of its own; else 0
  double minimum = 0.0;
  bool omitDefault = false; // The file is written without it while it has its default
};
std::span<const ProcessNumber> processNumbers();
// Returns whether the number of a process that lays tape follows from its tape and is not in its
// file.
bool isOfTape(const ProcessNumber& row);

// A setting of a feature: the key of its feature, and its own.
struct FeatureNumber {
  Feature feature;
  std::string_view featureKey, key, unit;
  double FeatureSettings::*value;
  double minimum = 0.0, maximum = 0.0;
  base::Text label;
};
std::span<const FeatureNumber> featureNumbers();

} // namespace voluta::process
