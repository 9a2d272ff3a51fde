// The text of --platform, and what it comes to where it is a plate.
#pragma once

#include "voxel/solid_voxels.h"

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::modes {

enum class PlatformKind { Fit, Disc, Rect, Rod, Mesh };
inline constexpr std::array<std::string_view, 5> kPlatformWords{"fit", "disc", "rect", "rod",
                                                                "mesh"};

// "fit", "fit:MARGIN", "disc:D", "rect:WxD", "rod:DxL" or "mesh:FILE". mm.
struct PlatformChoice {
  PlatformKind kind = PlatformKind::Fit;
  double marginMm = 0.0;                   // Fit
  double widthMm = 0.0, depthMm = 0.0;     // Disc: its diameter is the width; Rect
  double diameterMm = 0.0, lengthMm = 0.0; // Rod
  std::string file;                        // Mesh
};

// Throws Error{Usage} that names what there is.
PlatformChoice platformChoice(const std::string& platform);

// The polygon of "fit", "fit:MARGIN", "disc:D" or "rect:WxD". `own`: the platform that the part
// brought along, which "fit" then stands for; empty: none, and "fit" is the hull of what stands on
// the plate. Throws Error{Usage}, also for what is no plate; Error{UnusableInput} when nothing of
// the part stands on the plate.
std::vector<Eigen::Vector2d> platformPolygon(const std::string& platform,
                                             const voxel::SolidVoxels& voxels,
                                             const std::vector<Eigen::Vector2d>& own = {});
// The margin of "fit" or "fit:MARGIN", mm; none for other platforms. Throws Error{Usage}.
std::optional<double> fitMargin(const std::string& platform);
// The same where what stands on the plate is given by points of it; they do not matter to a disc or
// a rectangle. Throws Error{UnusableInput} where "fit" has none.
std::vector<Eigen::Vector2d> platformAround(const std::string& platform,
                                            std::vector<Eigen::Vector2d> standing);

} // namespace voluta::modes
