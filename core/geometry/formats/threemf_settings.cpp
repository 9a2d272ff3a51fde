#include "geometry/formats/threemf_settings.h"

#include "base/error.h"
#include "base/lower_case.h"
#include "geometry/formats/text_scanner.h"
#include "geometry/formats/threemf_package.h"
#include "geometry/formats/xml_scan.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace voluta::geometry {

namespace {

using Kind = ThreemfVolumeKind;

// Words of PrusaSlicer, and of Bambu Studio and OrcaSlicer.
constexpr std::array<std::pair<std::string_view, Kind>, 8> kKinds{
    {{"NegativeVolume", Kind::Negative},
     {"ParameterModifier", Kind::Modifier},
     {"SupportEnforcer", Kind::SupportEnforcer},
     {"SupportBlocker", Kind::SupportBlocker},
     {"negative_part", Kind::Negative},
     {"modifier_part", Kind::Modifier},
     {"support_enforcer", Kind::SupportEnforcer},
     {"support_blocker", Kind::SupportBlocker}}};

// Keys of objects, volumes and plates that change nothing in the print, or that are read here.
bool isPlain(std::string_view key) {
  constexpr std::array<std::string_view, 24> kPlain{"",
                                                    "name",
                                                    "extruder",
                                                    "volume_type",
                                                    "modifier",
                                                    "matrix",
                                                    "module",
                                                    "plater_id",
                                                    "plater_name",
                                                    "locked",
                                                    "gcode_file",
                                                    "pattern_file",
                                                    "pattern_bbox_file",
                                                    "top_file",
                                                    "pick_file",
                                                    "object_id",
                                                    "instance_id",
                                                    "identify_id",
                                                    "filament_maps",
                                                    "filament_map_mode",
                                                    "subtype",
                                                    "filament_volume_maps",
                                                    "from_backup",
                                                    "text"};
  return key.starts_with("source_") || key.starts_with("thumbnail") ||
         std::ranges::find(kPlain, key) != kPlain.end();
}

int extruderOf(std::string_view text) {
  constexpr long long kMaxCount = 1000;
  const std::optional<long long> number = integerOf(text);
  return number && *number > 0 && *number <= kMaxCount ? static_cast<int>(*number) : 0;
}

// Reads the settings of the objects in one member.
class SettingsReader {
public:
  SettingsReader(std::string member, ThreemfSettings& settings)
      : member_(std::move(member)), settings_(settings) {}

  void read(const std::string& text) {
    XmlHandler handler;
    handler.begin = [&](XmlName name, const XmlAttributes& attributes) { begin(name, attributes); };
    handler.end = [&](XmlName name) { end(name); };
    scanXml(text, member_, handler);
    if (plates_ > 1)
      settings_.notes.push_back(base::message(
          "not used: the division into {plates} plates ({where}): the parts of all are read"_text,
          plates_, member_));
    if (!plateKeys_.empty())
      settings_.notes.push_back(base::message("not used: settings of plates ({where}): {keys}"_text,
                                              member_, keysInQuotes(plateKeys_)));
  }

private:
  void begin(XmlName name, const XmlAttributes& attributes) {
    ++depth_;
    if (depth_ == 2 && name.word == "object") {
      object_ = &settings_.objects[std::string(attributes.text("id"))];
      object_->member = member_;
    } else if (depth_ == 2 && name.word == "plate") {
      isPlate_ = true;
      hasParts_ = false;
    } else if (isPlate_ && name.word == "model_instance") {
      hasParts_ = true;
    } else if (object_ && (name.word == "volume" || name.word == "part")) {
      beginVolume(attributes);
    } else if (name.word == "metadata") {
      take(attributes.text("key"), attributes.text("value"));
    }
  }
  void end(XmlName name) {
    --depth_;
    if (name.word == "volume" || name.word == "part")
      volume_ = nullptr;
    if (depth_ == 1) {
      plates_ += isPlate_ && hasParts_ ? 1 : 0;
      object_ = nullptr;
      isPlate_ = false;
    }
  }

  void beginVolume(const XmlAttributes& attributes) {
    ThreemfVolume volume;
    if (attributes.has("firstid")) {
      volume.firstTriangle = attributes.integer("firstid");
      volume.lastTriangle = attributes.integerOr("lastid", -1);
    } else {
      volume.objectId = attributes.text("id");
    }
    takeKind(volume, attributes.text("subtype"));
    object_->volumes.push_back(std::move(volume));
    volume_ = &object_->volumes.back();
  }

  void takeKind(ThreemfVolume& volume, std::string_view word) {
    constexpr std::array<std::string_view, 4> kPart{"", "0", "ModelPart", "normal_part"};
    if (std::ranges::find(kPart, word) != kPart.end())
      return;
    const auto* row = std::ranges::find(kKinds, word, [](const auto& r) { return r.first; });
    if (row != kKinds.end())
      volume.kind = row->second;
    else
      settings_.notes.push_back(base::message(
          "printed like the part: a volume of the unknown kind '{kind}' ({where})"_text, word,
          member_));
  }

  void take(std::string_view key, std::string_view value) {
    if (volume_) {
      if (key == "name")
        volume_->name = value;
      else if (key == "volume_type")
        takeKind(*volume_, value);
      else if (key == "modifier" && value == "1" && volume_->kind == Kind::Part)
        volume_->kind = Kind::Modifier; // before the kinds had words
      else if (key == "extruder")
        volume_->extruder = extruderOf(value);
      addSetting(volume_->settings, key, value);
    } else if (object_) {
      if (key == "name" && object_->name.empty())
        object_->name = value;
      else if (key == "extruder")
        object_->extruder = extruderOf(value);
      addSetting(object_->settings, key, value);
    } else if (isPlate_) {
      addSetting(plateKeys_, key, value);
    }
  }

  std::string member_;
  ThreemfSettings& settings_;
  int depth_ = 0;
  ThreemfObjectSettings* object_ = nullptr;
  ThreemfVolume* volume_ = nullptr;
  bool isPlate_ = false, hasParts_ = false;
  std::size_t plates_ = 0; // with parts
  ThreemfValues plateKeys_;
};

constexpr std::array<std::string_view, 2> kObjectSettings{"Metadata/Slic3r_PE_model.config",
                                                          "Metadata/model_settings.config"};

struct MemberRow {
  std::string_view begin; // of its name
  base::Text what;        // empty: changes nothing in the print
};

// The first row that fits decides.
const std::array kMembers = {
    MemberRow{"Metadata/Slic3r_PE.config", "the slicer's settings"_text},
    MemberRow{"Metadata/project_settings.config", "the slicer's settings"_text},
    MemberRow{"Metadata/print_profile.config", "the slicer's settings"_text},
    MemberRow{"Metadata/process_settings", "the slicer's settings"_text},
    MemberRow{"Metadata/filament_settings", "the slicer's settings"_text},
    MemberRow{"Metadata/machine_settings", "the slicer's settings"_text},
    MemberRow{"Cura/", "the slicer's settings"_text},
    MemberRow{"Metadata/Slic3r_PE_layer_heights_profile.txt", "variable layer heights"_text},
    MemberRow{"Metadata/layer_heights_profile.txt", "variable layer heights"_text},
    MemberRow{"Metadata/Prusa_Slicer_layer_config_ranges.xml", {}}, // Read with their heights
    MemberRow{"Metadata/layer_config_ranges.xml", {}},
    MemberRow{"Metadata/Prusa_Slicer_custom_gcode_per_print_z.xml", {}},
    MemberRow{"Metadata/custom_gcode_per_layer.xml", {}},
    MemberRow{"Metadata/Slic3r_PE_sla_support_points.txt", "points of support"_text},
    MemberRow{"Metadata/Slic3r_PE_sla_drain_holes.txt", "drain holes"_text},
    MemberRow{"Metadata/brim_ear_points.txt", "ears of the brim"_text},
    MemberRow{"[Content_Types].xml", {}},
    MemberRow{"_rels/", {}},
    MemberRow{"3D/", {}}, // Models and their textures
    MemberRow{"Auxiliaries/", {}},
    MemberRow{"docProps/", {}},
    MemberRow{"Metadata/slice_info", {}},
    MemberRow{"Metadata/cut_information", {}},
    MemberRow{"Metadata/Prusa_Slicer_cut_information", {}},
    MemberRow{"Metadata/Prusa_Slicer_wipe_tower_information", {}},
    MemberRow{"Metadata/plate_", {}}, // Previews and sliced G-code
};

bool isPicture(const std::string& member) {
  const std::string small = base::lowerCase(member);
  constexpr std::array<std::string_view, 5> kEndings{".png", ".jpg", ".jpeg", ".svg", ".rels"};
  return std::ranges::any_of(kEndings, [&](std::string_view e) { return small.ends_with(e); });
}

// Returns the layers of tool-paths, as paths; none if the relations to them are damaged.
std::set<std::string> layersOf(const ZipPackage& package, const std::string& model) {
  try {
    return toolpathLayers(package, model, {});
  } catch (const base::Error&) {
    return {}; // Reported by the reader of tool-paths
  }
}

// Names the members that are not acted on; unknown ones as well.
void noteMembers(const ZipPackage& package, const std::string& model,
                 std::vector<base::Message>& notes) {
  const std::set<std::string> layers = layersOf(package, model);
  constexpr std::size_t kMaxNamed = 20;
  std::vector<std::string> unknown;
  for (const std::string& member : package.names()) {
    if (std::ranges::find(kObjectSettings, member) != kObjectSettings.end() ||
        member.ends_with('/') || isPicture(member) || layers.contains("/" + member))
      continue;
    const auto* row = std::ranges::find_if(
        kMembers, [&](const MemberRow& r) { return member.starts_with(r.begin); });
    if (row == kMembers.end())
      unknown.push_back(member);
    else if (!row->what.empty())
      notes.push_back(base::message("not used: {what} ('{member}')"_text, row->what, member));
  }
  if (unknown.size() > kMaxNamed) {
    notes.push_back(base::message("not used: {count} further members of the package"_text,
                                  unknown.size() - kMaxNamed));
    unknown.resize(kMaxNamed);
  }
  for (const std::string& member : unknown)
    notes.push_back(base::message("not used: '{member}' in the package"_text, member));
}

constexpr std::array<std::pair<std::string_view, Kind>, 4> kCuraKinds{
    {{"infill_mesh", Kind::Modifier},
     {"cutting_mesh", Kind::Modifier},
     {"support_mesh", Kind::SupportEnforcer},
     {"anti_overhang_mesh", Kind::SupportBlocker}}};

bool isTrue(std::string_view value) {
  const std::string small = base::lowerCase(value);
  return small == "true" || small == "1";
}

} // namespace

std::string inQuotes(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names)
    all += (all.empty() ? "'" : ", '") + name + "'";
  return all;
}

std::string keysInQuotes(const ThreemfValues& settings) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : settings)
    keys.push_back(key);
  return inQuotes(keys);
}

void addSetting(ThreemfValues& settings, std::string_view key, std::string_view value) {
  if (isPlain(key))
    return;
  const auto known = std::ranges::find(settings, key, [](const auto& s) { return s.first; });
  if (known == settings.end())
    settings.emplace_back(key, value);
  else
    known->second = value;
}

ThreemfSettings slicerSettings(const ZipPackage& package, const std::string& model) {
  ThreemfSettings settings;
  for (const std::string_view name : kObjectSettings) {
    const std::string member(name);
    if (!package.has(member))
      continue;
    try {
      SettingsReader(member, settings).read(package.member(member));
    } catch (const base::Error& e) {
      settings.objects.clear();
      settings.notes.push_back(
          base::message("not used, as they are damaged: kinds and settings of objects ({where}): "
                        "modifiers and negative volumes may be printed as parts: {why}"_text,
                        member, e.message()));
    }
  }
  noteMembers(package, model, settings.notes);
  return settings;
}

ThreemfObjectSettings
curaSettings(const std::vector<std::pair<std::string, std::string>>& settings) {
  ThreemfObjectSettings object;
  for (const auto& [key, value] : settings) {
    const auto* kind = std::ranges::find(kCuraKinds, key, [](const auto& r) { return r.first; });
    if (kind != kCuraKinds.end()) {
      if (isTrue(value))
        object.volumes.emplace_back().kind = kind->second;
    } else if (key == "extruder_nr") {
      const std::optional<long long> number = integerOf(value);
      object.extruder =
          number && *number >= 0 && *number < 1000 ? static_cast<int>(*number) + 1 : 0;
    } else if (key != "drop_to_buildplate" || !isTrue(value)) {
      addSetting(object.settings, key, value);
    }
  }
  return object;
}

} // namespace voluta::geometry
