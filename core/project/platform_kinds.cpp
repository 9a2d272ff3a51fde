#include "project/platform_kinds.h"

#include "base/error.h"
#include "base/nearest_name.h"
#include "curved/platform_polygon.h"
#include "geometry/convex_polygon.h"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

namespace voluta::project {

namespace {

using Eigen::Vector2d;
using Sizes = std::vector<double>;
using enum PlatformUse;

constexpr double kMinMm = 0.1, kMaxMm = 5000.0;

std::vector<Vector2d> aroundStanding(const Sizes& sizes, std::vector<Vector2d> standing) {
  return geometry::convexPolygon(std::move(standing), sizes[0]);
}

std::vector<Vector2d> taken(const Sizes&, std::vector<Vector2d> plate) {
  return plate;
}

std::vector<Vector2d> disc(const Sizes& sizes, std::vector<Vector2d>) {
  return curved::platformDisc(sizes[0]);
}

std::vector<Vector2d> rectangle(const Sizes& sizes, std::vector<Vector2d>) {
  return curved::platformRect(sizes[0], sizes[1]);
}

platform::RodShape rod(const Sizes& sizes, int sides) {
  return platform::straightRod(sizes[0], sizes[1], sides);
}

PlatformField length(std::string_view name, base::Text label, double usualMm) {
  return {name, label, kMinMm, kMaxMm, usualMm};
}

} // namespace

const std::vector<PlatformKind>& platformKinds() {
  static const std::vector<PlatformKind> kKinds{
      {.word = "fit",
       .uses = {{Plate, "Contact area, margin"_text}, {Rod, "Rod of the cell"_text, false}},
       .shown = "contact area + {sizes} mm"_text,
       .plain = "contact area"_text,
       .fields = {{"MARGIN", "Margin around the contact area"_text, 0.0, kMaxMm, 0.0}},
       .bare = true,
       .madeForPart = true,
       .plate = aroundStanding},
      {.word = "cell",
       .uses = {{Plate, "Plate of the cell"_text}},
       .shown = "plate of the cell"_text,
       .plain = "plate of the cell"_text,
       .bare = true,
       .ofCell = true,
       .plate = taken},
      {.word = "disc",
       .uses = {{Plate, "Disc, diameter"_text}},
       .shown = "disc, {sizes} mm"_text,
       .fields = {length("DIAMETER", "Diameter"_text, 200.0)},
       .plate = disc},
      {.word = "rect",
       .uses = {{Plate, "Rectangle"_text}},
       .shown = "{sizes} mm"_text,
       .fields = {length("WIDTH", "Width (X)"_text, 200.0),
                  length("DEPTH", "Depth (Y)"_text, 200.0)},
       .plate = rectangle},
      {.word = "rod",
       .uses = {{Rod, "Rod, diameter × length"_text}},
       .shown = "rod, {sizes} mm"_text,
       .fields = {length("DIAMETER", "Diameter"_text, 5.0), length("LENGTH", "Length"_text, 200.0)},
       .rod = rod},
      {.word = "mesh",
       .uses = {{Body, "Body from a file"_text}},
       .shown = "{file}"_text,
       .file = "FILE"},
  };
  return kKinds;
}

const PlatformKind& findPlatformKind(std::string_view word) {
  std::vector<std::string> words;
  for (const PlatformKind& kind : platformKinds()) {
    if (kind.word == word)
      return kind;
    words.emplace_back(kind.word);
  }
  throw base::Error(base::ErrorCode::Usage, base::message("unknown platform '{name}'"_text, word),
                    {}, base::didYouMean(word, words));
}

std::vector<const PlatformKind*> platformKindsFor(const std::vector<PlatformUse>& uses) {
  std::vector<const PlatformKind*> kinds;
  for (const PlatformUse use : uses)
    for (const PlatformKind& kind : platformKinds()) {
      const bool used = std::any_of(kind.uses.begin(), kind.uses.end(),
                                    [&](const PlatformKind::As& as) { return as.use == use; });
      if (used && std::find(kinds.begin(), kinds.end(), &kind) == kinds.end())
        kinds.push_back(&kind);
    }
  return kinds;
}

std::string platformForm(const PlatformKind& kind) {
  std::string sizes(kind.file);
  for (const PlatformField& field : kind.fields)
    sizes += fmt::format("{}{}", sizes.empty() ? "" : "x", field.name);
  if (sizes.empty())
    return std::string(kind.word);
  return kind.bare ? fmt::format("{}[:{}]", kind.word, sizes)
                   : fmt::format("{}:{}", kind.word, sizes);
}

std::string platformForms(const std::vector<PlatformUse>& uses) {
  std::string forms;
  for (const PlatformKind* kind : platformKindsFor(uses))
    forms += fmt::format("{}{}", forms.empty() ? "" : ", ", platformForm(*kind));
  return forms;
}

} // namespace voluta::project
