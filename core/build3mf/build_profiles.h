// Profiles of a toolpath resource and what their modifiers make of a point's factors (Part I, 4.1
// and 4.2).
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

// How fine a modifier's values may be given, coarsest first.
enum class ModifierType : std::uint8_t { Constant, Linear, Nonlinear };

struct Modifier {
  ModifierType type = ModifierType::Constant;
  double least = 0.0, most = 0.0;
  std::size_t factor = 0; // in kFactors
};

struct Profile {
  std::string name;
  std::array<double, 3> nominal{}; // in the order of Modulated; 0: not given
  std::array<bool, 3> modified{};
  std::array<Modifier, 3> modifiers;
  plan::PathKind kind = plan::PathKind::Wall;
  bool waits = false; // it has waits before or after a segment
};

// Profiles by their UUID in small letters.
using Profiles = std::map<std::string, Profile>;

std::string smallLetters(std::string_view text);

// A profile without its modifiers. Throws Error{UnreadableFile}.
Profile profileOf(const geometry::XmlAttributes& attributes);
// Puts a modifier into the profile. Throws Error{UnreadableFile}: of an attribute that cannot be
// modified here or that the profile does not have, twice, of a range that is none.
void addModifier(Profile& profile, const geometry::XmlAttributes& attributes);

} // namespace voluta::build3mf
