// Speed, flow and width by feature: how a process prints walls, infill, supports and the first
// layer.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace voluta::base {
class JsonNode;
}

namespace voluta::process {

// FirstLayer adds to the feature that a bead of the first layer has otherwise.
enum class Feature : std::uint8_t {
  OuterWall,
  InnerWall,
  Infill, // Solid: gap fill and skins included
  SparseInfill,
  Bridge, // Its speed is the process's bridgeSpeedMmPerS
  Support,
  FirstLayer
};
inline constexpr std::size_t kFeatures = 7;

struct FeatureSettings {
  double speedMmPerS = 0.0; // 0: the process's speed
  double flow = 1.0;        // Factor of the bead's section
  double widthMm = 0.0;     // 0: the process's bead width
};

class FeatureTable {
public:
  const FeatureSettings& of(Feature feature) const {
    return settings_[static_cast<std::size_t>(feature)];
  }
  FeatureSettings& of(Feature feature) { return settings_[static_cast<std::size_t>(feature)]; }
  std::span<const FeatureSettings> all() const { return settings_; }

private:
  std::array<FeatureSettings, kFeatures> settings_{};
};

// A feature's key in the process's file, and the settings that it may have there besides its flow.
struct FeatureRow {
  Feature feature;
  std::string_view key;
  bool hasSpeed = true, hasWidth = false;
};
std::span<const FeatureRow> featureRows();

// Range of bead widths [mm].
struct WidthRange {
  double minMm = 0.0, usualMm = 0.0, maxMm = 0.0;
};

// Shares of the speed of a wall that overhangs the layer below by a quarter, a half, three quarters
// of its width, and altogether. Between them, and from 1 without an overhang, linear.
struct OverhangSpeed {
  std::array<double, 4> shares{1.0, 1.0, 1.0, 1.0};

  // `overhang`: share of the width, 0..1.
  double at(double overhang) const;
  bool operator==(const OverhangSpeed&) const = default;
};
// Returns the shares in [1, 0.8, 0.6, 0.5]. Throws Error{UnusableInput} unless there are four, none
// below 0.05, above 1 or above the share before it.
OverhangSpeed readOverhangSpeed(const base::JsonNode& node);

// Returns the settings in {"outerWall": {"speedMmPerS": 15, "flow": 1, "widthMm": 1.4}, ...}; those
// that are missing keep their defaults. Throws Error{UnusableInput} naming the key for an unknown
// key, a value that is not positive, a flow outside 0.5 to 2, or a width outside the range. Outer
// walls may not be narrower than other beads.
FeatureTable readFeatures(const base::JsonNode& node, const WidthRange& widths);

} // namespace voluta::process
