#include "build3mf/build_profiles.h"

#include "base/error.h"
#include "base/lower_case.h"

#include <algorithm>
#include <cctype>

namespace voluta::build3mf {

using base::Error;
using base::ErrorCode;
using geometry::XmlAttributes;

namespace {

constexpr double kMaxValue = 1e5; // [mm] or [mm/s]

bool holds(const std::string& text, std::string_view word) {
  return text.find(word) != std::string::npos;
}

// Other makers' profile names state the path's purpose too, in their own terms.
plan::PathKind kindOf(const XmlAttributes& attributes, const std::string& name) {
  using enum plan::PathKind;
  const std::string_view own = attributes.text("kind", kOwnSpace);
  for (std::size_t k = 0; k < kKindNames.size(); ++k)
    if (own == kKindNames[k])
      return static_cast<plan::PathKind>(k);
  const std::string word = base::lowerCase(name);
  if (holds(word, "support"))
    return Support;
  if (holds(word, "skirt") || holds(word, "brim"))
    return Skirt;
  if (holds(word, "prime") || holds(word, "purge"))
    return Prime;
  if (holds(word, "gap"))
    return GapFill;
  return holds(word, "fill") || holds(word, "hatch") ? Infill : Wall;
}

ModifierType typeOf(std::string_view word) {
  if (word == "constant")
    return ModifierType::Constant;
  if (word == "linear")
    return ModifierType::Linear;
  if (word == "nonlinear")
    return ModifierType::Nonlinear;
  throw Error(ErrorCode::UnreadableFile,
              base::message("a modifier of unknown type '{type}'"_text, word));
}

} // namespace

Profile profileOf(const XmlAttributes& attributes) {
  Profile profile;
  profile.name = attributes.text("name");
  for (std::size_t m = 0; m < kModulatedNames.size(); ++m)
    if (attributes.has(kModulatedNames[m])) {
      profile.nominal[m] = attributes.number(kModulatedNames[m]);
      if (!(profile.nominal[m] > 0.0) || profile.nominal[m] > kMaxValue)
        throw Error(
            ErrorCode::UnreadableFile,
            base::message("'{attribute}' is not above 0, or too large"_text, kModulatedNames[m]));
    }
  profile.kind = kindOf(attributes, profile.name);
  profile.waits = attributes.has("prewaittime") || attributes.has("postwaittime");
  return profile;
}

void addModifier(Profile& profile, const XmlAttributes& attributes) {
  const std::string_view of = attributes.text("attribute");
  const auto known = std::find(kModulatedNames.begin(), kModulatedNames.end(), of);
  if (known == kModulatedNames.end())
    throw Error(ErrorCode::UnreadableFile,
                base::message("an unsupported modifier of '{attribute}'"_text, of));
  const auto m = static_cast<std::size_t>(known - kModulatedNames.begin());
  if (!(profile.nominal[m] > 0.0))
    throw Error(ErrorCode::UnreadableFile,
                base::message("a modifier of '{attribute}', which its profile lacks"_text, of));
  const std::string_view factor = attributes.text("factor");
  const auto letter = factor.size() == 1
                          ? std::find(kFactors.begin(), kFactors.end(), factor.front())
                          : kFactors.end();
  const Modifier modifier{typeOf(attributes.text("type")), attributes.number("minvalue"),
                          attributes.number("maxvalue"),
                          static_cast<std::size_t>(letter - kFactors.begin())};
  if (letter == kFactors.end() || !(modifier.minimum > 0.0) ||
      !(modifier.minimum < modifier.maximum) || modifier.maximum > kMaxValue)
    throw Error(ErrorCode::UnreadableFile,
                base::message("a modifier of '{attribute}' without a range above 0 or without a "
                              "factor of e, f, g and h"_text,
                              of));
  for (std::size_t other = 0; other < profile.modified.size(); ++other)
    if (profile.modified[other] &&
        (other == m || profile.modifiers[other].factor == modifier.factor))
      throw Error(ErrorCode::UnreadableFile,
                  base::message("two modifiers of '{attribute}' or with the same factor"_text, of));
  profile.modified[m] = true;
  profile.modifiers[m] = modifier;
}

} // namespace voluta::build3mf
