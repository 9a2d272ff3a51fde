// Names of the 3MF Toolpath Extension 1.0 (release candidate), of the specifications it builds on,
// and of Voluta's namespace.
#pragma once

#include "plan/tool_plan.h"

#include <array>
#include <string_view>

namespace voluta::build3mf {

inline constexpr std::string_view kCoreSpace =
    "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
inline constexpr std::string_view kProductionSpace =
    "http://schemas.microsoft.com/3dmanufacturing/production/2015/06";
inline constexpr std::string_view kToolpathSpace =
    "http://schemas.3mf.io/3dmanufacturing/toolpath/2026/03";
inline constexpr std::string_view kModelRelation =
    "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";

// Attributes of segments and profiles in Voluta's namespace; other readers may ignore them.
inline constexpr std::string_view kOwnSpace = "urn:voluta:toolpath:2026";

// In the order of plan::PathKind; also the names of profiles.
inline constexpr std::array<std::string_view, plan::kPathKinds> kKindNames{
    "wall",  "infill",        "gap fill", "skirt", "support",
    "prime", "sparse infill", "bridge",   "tape",  "shot"};
static_assert(!kKindNames.back().empty(), "a name for each kind");

// Properties that a profile's modifiers may change, by the profile's attribute.
enum class Modulated { Width, Height, Speed };
inline constexpr std::array<std::string_view, 3> kModulatedNames{"beadwidth", "beadheight",
                                                                 "depositionspeed"};
inline constexpr std::array<char, 4> kFactors{'e', 'f', 'g', 'h'};

} // namespace voluta::build3mf
