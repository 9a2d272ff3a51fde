#include "sliced/slicer_comments.h"

#include "base/lower_case.h"
#include "program/common/program_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace voluta::sliced {

namespace {
using enum plan::PathKind;
using program::trimmed;

// PrusaSlicer and slic3r, OrcaSlicer and Bambu Studio, Cura, Simplify3D.
constexpr std::array kFeatures = {
    Feature{"External perimeter", Wall, true, true},
    Feature{"Perimeter", Wall},
    Feature{"Overhang perimeter", Wall},
    Feature{"Thin wall", Wall},
    Feature{"Internal infill", SparseInfill},
    Feature{"Solid infill", Infill},
    Feature{"Top solid infill", Infill},
    Feature{"Ironing", Infill},
    Feature{"Bridge infill", Bridge},
    Feature{"Internal bridge infill", Bridge},
    Feature{"Gap fill", GapFill},
    Feature{"Skirt", Skirt},
    Feature{"Brim", Skirt},
    Feature{"Skirt/Brim", Skirt},
    Feature{"Support material", Support, false},
    Feature{"Support material interface", Support, false},
    Feature{"Wipe tower", Support, false},
    Feature{"Custom", Skirt, false, false, true},
    Feature{"Outer wall", Wall, true, true},
    Feature{"Inner wall", Wall},
    Feature{"Overhang wall", Wall},
    Feature{"Sparse infill", SparseInfill},
    Feature{"Internal solid infill", Infill},
    Feature{"Top surface", Infill},
    Feature{"Bottom surface", Infill},
    Feature{"Bridge", Bridge},
    Feature{"Internal bridge", Bridge},
    Feature{"Gap infill", GapFill},
    Feature{"Support", Support, false},
    Feature{"Support interface", Support, false},
    Feature{"Support transition", Support, false},
    Feature{"Prime tower", Support, false},
    Feature{"WALL-OUTER", Wall, true, true},
    Feature{"WALL-INNER", Wall},
    Feature{"SKIN", Infill},
    Feature{"FILL", SparseInfill},
    Feature{"SUPPORT-INTERFACE", Support, false},
    Feature{"PRIME-TOWER", Support, false},
    Feature{"Outer perimeter", Wall, true, true},
    Feature{"Inner perimeter", Wall},
    Feature{"Infill", SparseInfill},
    Feature{"Solid layer", Infill},
};

// Returns the rest behind `head`, ignoring case and blanks; nullopt if the text begins otherwise.
std::optional<std::string_view> behind(std::string_view text, std::string_view head) {
  if (text.size() < head.size() || base::lowerCase(text.substr(0, head.size())) != head)
    return std::nullopt;
  return trimmed(text.substr(head.size()));
}

// Returns the value of a setting, "head = value".
std::optional<std::string_view> valueBehind(std::string_view text, std::string_view head) {
  std::optional<std::string_view> rest = behind(text, head);
  while (rest && !rest->empty() &&
         (rest->front() == '=' || rest->front() == ':' || rest->front() == ',' ||
          rest->front() == ' '))
    rest->remove_prefix(1);
  return rest;
}

std::optional<double> numberBehind(std::string_view text, std::string_view head) {
  std::optional<std::string_view> rest = valueBehind(text, head);
  double value = 0.0;
  return rest && program::takeNumber(*rest, value) ? std::optional(value) : std::nullopt;
}

constexpr double kMinMm = 0.01, kMaxMm = 50.0;

void take(double& value, std::optional<double> found) {
  if (found && *found >= kMinMm && *found <= kMaxMm)
    value = *found;
}

// Takes diameters by tool, "1.75,2.85".
void takeDiameters(SlicedHeader& header, std::string_view text) {
  constexpr std::size_t kShown = 40;
  std::vector<double> all;
  const std::string_view stated = text.substr(0, kShown);
  double value = 0.0;
  bool continues = !text.empty() && text.front() != '_'; // otherwise a setting of another name
  while (continues) {
    if (!program::takeNumber(text, value) || !(value >= kMinMm && value <= kMaxMm)) {
      header.oddDiameters = stated;
      break;
    }
    all.push_back(value);
    text = trimmed(text);
    continues = text.starts_with(',');
    text = trimmed(text.substr(continues ? 1 : 0));
    continues = continues && !text.empty();
  }
  if (all.empty())
    return;
  header.filamentMm = all.front();
  header.filamentsMm = std::move(all);
}
} // namespace

double SlicedHeader::amountShare(int tool, bool isVolume) const {
  const auto at = static_cast<std::size_t>(tool);
  if (isVolume || at >= filamentsMm.size())
    return 1.0;
  const double share = filamentsMm[at] / filamentsMm.front();
  return share * share;
}

std::optional<int> toolNumber(double number) {
  constexpr double kMaxTools = 16.0;
  if (!(number >= 0.0) || number >= kMaxTools || number != std::floor(number))
    return std::nullopt;
  return static_cast<int>(number);
}

const Feature* findFeature(std::string_view name) {
  const std::string small = base::lowerCase(trimmed(name));
  const auto found = std::ranges::find_if(
      kFeatures, [&](const Feature& f) { return base::lowerCase(f.name) == small; });
  return found == kFeatures.end() ? nullptr : &*found;
}

CommentFacts factsOf(std::string_view comment) {
  CommentFacts facts;
  const std::string_view text = trimmed(comment);
  for (const std::string_view head : {"type:", "feature:", "feature "})
    if (const auto name = behind(text, head)) {
      facts.feature = findFeature(*name);
      return facts;
    }
  if (numberBehind(text, "layer:") || numberBehind(text, "layer ")) {
    facts.layerChange = true;
  } else if (behind(text, "layer_change") || behind(text, "change_layer")) {
    facts.layerChange = true;
  } else if (const auto height = numberBehind(text, "height:")) {
    facts.heightMm = height;
  }
  return facts;
}

SlicedHeader headerOf(std::string_view text) {
  SlicedHeader header;
  program::LineReader lines(text);
  std::string_view line;
  while (lines.next(line)) {
    if (line.empty() || line.front() != ';')
      continue;
    const std::string_view words = trimmed(line.substr(1));
    const CommentFacts facts = factsOf(words);
    header.hasLayers = header.hasLayers || facts.layerChange;
    header.hasKinds = header.hasKinds || facts.feature;
    for (const std::string_view head :
         {"filament_diameter", "filamentdiameters", "filament diameter", "material_diameter"})
      if (const auto value = valueBehind(words, head))
        takeDiameters(header, *value);
    for (const std::string_view head : {"layer_height", "layer height", "layerheight"})
      take(header.layerHeightMm, numberBehind(words, head));
    for (const std::string_view head :
         {"first_layer_height", "initial_layer_print_height", "initial_layer_height"})
      take(header.firstLayerHeightMm, numberBehind(words, head));
    if (const auto value = numberBehind(words, "use_volumetric_e"))
      header.volumetric = *value == 1.0;
    if (const auto flavor = behind(words, "flavor:");
        flavor && base::lowerCase(trimmed(*flavor)) == "ultigcode")
      header.volumetric = header.ultiGcode = true;
    if (const auto value = numberBehind(words, "single_extruder_multi_material"))
      header.oneNozzle = header.oneNozzle || *value == 1.0;
    for (const std::string_view head : {"generated by ", "generated with ", "sliced by "})
      if (const auto name = behind(words, head); name && header.slicer.empty())
        header.slicer = name->substr(0, name->find(' '));
  }
  return header;
}

} // namespace voluta::sliced
