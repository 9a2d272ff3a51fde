// Profiles of a toolpath resource and how their modifiers apply a point's factors (Part I, 4.1 and
// 4.2).
#pragma once

#include "build3mf/build_names.h"
#include "geometry/formats/xml_scan.h"
#include "plan/tool_plan.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace voluta::build3mf {

// Resolution of a modifier's values, coarsest first.
enum class ModifierType : std::uint8_t { Constant, Linear, Nonlinear };

struct Modifier {
  ModifierType type = ModifierType::Constant;
  double minimum = 0.0, maximum = 0.0;
  std::size_t factor = 0; // Index in kFactors
};

struct Profile {
  std::string name;
  std::array<double, 3> nominal{}; // In the order of Modulated; 0: not given
  std::array<bool, 3> modified{};
  std::array<Modifier, 3> modifiers;
  plan::PathKind kind = plan::PathKind::Wall;
  bool waits = false; // It has waits before or after a segment
};

// Profiles by their UUID in lower case.
using Profiles = std::map<std::string, Profile>;

// Returns a profile without its modifiers. Throws Error{UnreadableFile}.
Profile profileOf(const geometry::XmlAttributes& attributes);
// Adds a modifier to the profile. Throws Error{UnreadableFile} for an attribute that cannot be
// modified or that the profile lacks, for a duplicate, and for an invalid range.
void addModifier(Profile& profile, const geometry::XmlAttributes& attributes);

} // namespace voluta::build3mf
