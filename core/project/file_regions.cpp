#include "project/file_regions.h"

#include "base/error.h"
#include "base/number_list.h"
#include "geometry/repair/repair.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <tuple>
#include <utility>

namespace voluta::project {

namespace {
using geometry::ModifierOfFile;
using Converted = std::optional<std::string>;

std::optional<double> numberIn(std::string_view text, double least, double most) {
  double number = 0.0;
  if (!base::readNumbers(text, ',', {&number}) || !(number >= least && number <= most))
    return std::nullopt;
  return number;
}

template <int kLeast, int kMost> Converted wholeNumber(std::string_view text) {
  const std::optional<double> number = numberIn(text, kLeast, kMost);
  if (!number || *number != std::floor(*number))
    return std::nullopt;
  return fmt::format("{:.0f}", *number);
}

// Percent of the whole, with or without the sign.
Converted share(std::string_view text) {
  if (text.ends_with('%'))
    text.remove_suffix(1);
  const std::optional<double> percent = numberIn(text, 0.0, 100.0);
  return percent ? Converted(fmt::format("{:.6g}", *percent / 100.0)) : std::nullopt;
}

Converted thickness(std::string_view text) {
  const std::optional<double> mm = numberIn(text, 0.0, 100.0);
  return mm ? Converted(fmt::format("{:.6g}", *mm)) : std::nullopt;
}

// Lines have no sense.
Converted direction(std::string_view text) {
  constexpr double kHalfTurn = 180.0;
  const std::optional<double> degrees = numberIn(text, -2.0 * kHalfTurn, 2.0 * kHalfTurn);
  if (!degrees)
    return std::nullopt;
  const double turned = std::fmod(*degrees, kHalfTurn);
  return fmt::format("{:.6g}", turned < 0.0 ? turned + kHalfTurn : turned);
}

Converted pattern(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 11> kPatterns{
      {{"gyroid", "gyroid"},
       {"rectilinear", "lines"},
       {"line", "lines"},
       {"lines", "lines"},
       {"zig-zag", "lines"},
       {"zigzag", "lines"},
       {"grid", "grid"},
       {"triangles", "triangles"},
       {"cubic", "cubic"},
       {"honeycomb", "honeycomb"},
       {"concentric", "concentric"}}};
  const auto* row = std::ranges::find(kPatterns, text, [](const auto& r) { return r.first; });
  return row == kPatterns.end() ? std::string() : std::string(row->second);
}

Converted supportVolume(std::string_view text) {
  if (text == "SupportEnforcer")
    return "always";
  return text == "SupportBlocker" ? Converted("none") : std::nullopt;
}

// Of an enforcer, 1, or a blocker, 2.
template <const char* kBlocked> Converted painted(std::string_view text) {
  const std::optional<double> state = numberIn(text, 1.0, 2.0);
  if (!state)
    return std::nullopt;
  return *state == 1.0 ? "always" : kBlocked;
}
constexpr char kNone[] = "none", kNever[] = "never";

constexpr std::string_view kSkin = "skinMm";

// PrusaSlicer's; Bambu Studio's and OrcaSlicer's; Cura's; kinds of volumes and paint.
constexpr std::array<SlicerSetting, 26> kSettings{
    {{"perimeters", "walls", wholeNumber<0, 20>},
     {"wall_loops", "walls", wholeNumber<0, 20>},
     {"wall_line_count", "walls", wholeNumber<0, 20>},
     {"fill_density", "infillDensity", share},
     {"sparse_infill_density", "infillDensity", share},
     {"infill_sparse_density", "infillDensity", share},
     {"fill_pattern", "sparsePattern", pattern},
     {"sparse_infill_pattern", "sparsePattern", pattern},
     {"infill_pattern", "sparsePattern", pattern},
     {"top_solid_layers", "topLayers", wholeNumber<0, 100>},
     {"top_shell_layers", "topLayers", wholeNumber<0, 100>},
     {"top_layers", "topLayers", wholeNumber<0, 100>},
     {"bottom_solid_layers", "bottomLayers", wholeNumber<0, 100>},
     {"bottom_shell_layers", "bottomLayers", wholeNumber<0, 100>},
     {"bottom_layers", "bottomLayers", wholeNumber<0, 100>},
     {"top_solid_min_thickness", kSkin, thickness},
     {"bottom_solid_min_thickness", kSkin, thickness},
     {"top_shell_thickness", kSkin, thickness},
     {"bottom_shell_thickness", kSkin, thickness},
     {"fill_angle", "infillAngle", direction},
     {"infill_direction", "infillAngle", direction},
     {"extruder", "tool", wholeNumber<1, 1000>},
     {"volume_type", "supports", supportVolume},
     {"paint_supports", "supports", painted<kNone>},
     {"paint_seam", "seamHere", painted<kNever>},
     {"paint_color", "tool", wholeNumber<1, 1000>}}};

// Depths of painted surfaces: places of supports and seams are at the surface, a colour is seen
// through a thinner layer.
constexpr double kMarkDepthMm = 0.5, kColourDepthMm = 2.0;

// Takes the value of a row. Returns whether it counts: of the thicknesses of top and bottom, which
// are one here, the larger one.
bool take(std::map<std::string, std::string>& parameters, std::string_view key,
          const std::string& value) {
  const auto [known, isNew] = parameters.try_emplace(std::string(key), value);
  if (isNew || key != kSkin) {
    known->second = value;
    return true;
  }
  const double before = numberIn(known->second, 0.0, 100.0).value_or(0.0);
  const double now = numberIn(value, 0.0, 100.0).value_or(0.0);
  known->second = now > before ? value : known->second;
  return now == before;
}

std::string listed(const std::vector<std::string>& settings) {
  return fmt::format("'{}'", fmt::join(settings, "', '"));
}

void takeSettings(const ModifierOfFile& modifier, const std::string& name, Region& region,
                  std::vector<base::Message>& notes) {
  std::vector<std::string> others, invalid;
  for (const auto& [key, value] : modifier.settings) {
    const auto* row = std::ranges::find(kSettings, key, &SlicerSetting::key);
    const Converted converted = row == kSettings.end() ? std::string() : row->convert(value);
    if (!converted)
      invalid.push_back(fmt::format("{} = {}", key, value));
    else if (converted->empty())
      others.push_back(fmt::format("{} = {}", key, value));
    else if (!take(region.parameters, row->parameter, *converted))
      notes.push_back(base::message("region '{region}' from the file: the skin is as thick as the "
                                    "larger one of top and bottom"_text,
                                    name));
  }
  if (!others.empty())
    notes.push_back(base::message("not used: settings of region '{region}' from the file without a "
                                  "counterpart: {settings}"_text,
                                  name, listed(others)));
  if (!invalid.empty())
    notes.push_back(base::message("not used: invalid settings of region '{region}' from the file: "
                                  "{settings}"_text,
                                  name, listed(invalid)));
}

// Returns the shape of a range of heights; empty, with a note, if it is none.
std::string rangeOf(const ModifierOfFile& modifier, std::vector<base::Message>& notes) {
  constexpr double kFarMm = 1e5;
  const double from = std::clamp(modifier.fromMm, -kFarMm, kFarMm);
  const double to = std::clamp(modifier.toMm, -kFarMm, kFarMm);
  const std::string shape = fmt::format("height:{:.9g},{:.9g}", from, to);
  if (from < to)
    return shape;
  notes.push_back(base::message("not used: the range of heights from {from} to {to} in the file, "
                                "which is empty"_text,
                                base::mm(modifier.fromMm), base::mm(modifier.toMm)));
  return {};
}

// Returns the closed body; null, with a note, if it cannot be closed.
std::shared_ptr<const geometry::TriangleMesh> bodyOf(const ModifierOfFile& modifier,
                                                     const std::string& name,
                                                     std::vector<base::Message>& notes,
                                                     const base::RunContext& ctx) {
  try {
    geometry::RepairResult repaired = geometry::repair(modifier.mesh, ctx);
    if (geometry::isWatertight(repaired.mesh)) {
      if (!geometry::isWatertight(modifier.mesh))
        notes.push_back(base::message(
            "region '{region}' from the file: its mesh is open, and was closed"_text, name));
      return std::make_shared<const geometry::TriangleMesh>(std::move(repaired.mesh));
    }
  } catch (const base::Error&) {
    // Nothing with volume
  }
  notes.push_back(base::message(
      "not used: region '{region}' from the file: its mesh is not closed"_text, name));
  return nullptr;
}

// Returns the name and the shape of a painted surface.
std::pair<std::string, std::string> paintOf(const ModifierOfFile& modifier) {
  const auto& [setting, state] = modifier.settings.front();
  const auto* row = std::ranges::find(kSettings, setting, &SlicerSetting::key);
  const double depth = setting == "paint_color" ? kColourDepthMm : kMarkDepthMm;
  const std::string value = row == kSettings.end() ? state : row->convert(state).value_or(state);
  return {fmt::format("{}{}{}={}", modifier.name, modifier.name.empty() ? "" : ", ",
                      row == kSettings.end() ? std::string_view(setting) : row->parameter, value),
          fmt::format("painted:{}", depth)};
}
} // namespace

std::span<const SlicerSetting> slicerSettings() {
  return kSettings;
}

std::vector<Region> regionsOfFile(const std::vector<ModifierOfFile>& modifiers,
                                  std::vector<base::Message>& notes, const base::RunContext& ctx) {
  std::vector<Region> regions;
  std::size_t omitted = 0;
  for (const ModifierOfFile& modifier : modifiers) {
    ctx.checkpoint();
    const bool isRange = modifier.mesh.empty();
    Region region;
    region.name = modifier.name;
    if (modifier.isPainted && !modifier.settings.empty())
      std::tie(region.name, region.shape) = paintOf(modifier);
    else if (isRange)
      region.shape = rangeOf(modifier, notes);
    else
      region.shape = fmt::format("mesh:{}", modifier.name.empty() ? "modifier" : modifier.name);
    if (region.shape.empty())
      continue;
    if (regions.size() == kMaxRegionsOfFile) {
      ++omitted;
      continue;
    }
    const std::string name = region.name.empty() ? region.shape : region.name;
    takeSettings(modifier, name, region, notes);
    if (region.parameters.empty()) {
      if (modifier.settings.empty())
        notes.push_back(base::message(
            "not used: region '{region}' from the file, which has no settings"_text, name));
      continue;
    }
    if (modifier.isPainted)
      region.mesh = std::make_shared<const geometry::TriangleMesh>(modifier.mesh);
    else if (!isRange && !(region.mesh = bodyOf(modifier, name, notes, ctx)))
      continue;
    notes.emplace_back("region '{region}' from the file: {count} setting|"
                       "region '{region}' from the file: {count} settings"_plural,
                       std::vector<base::Value>{name, region.parameters.size()});
    regions.push_back(std::move(region));
  }
  if (omitted > 0)
    notes.emplace_back("not used: {count} further region of the file|"
                       "not used: {count} further regions of the file"_plural,
                       std::vector<base::Value>{omitted});
  return regions;
}

} // namespace voluta::project
