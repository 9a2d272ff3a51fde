// 3MF packages of parts with modifiers and settings at heights, as slicers write them.
#pragma once

#include "helpers/package_3mf.h"

#include <Eigen/Core>
#include <array>
#include <fmt/format.h>
#include <string>
#include <utility>
#include <vector>

namespace voluta::test {

// In the order of the words below.
enum class SlicerKind { Part, Negative, Modifier, Enforcer, Blocker };

using SlicerSettings = std::vector<std::pair<std::string, std::string>>;

struct SlicerVolume {
  std::string name;
  Eigen::Vector3d from, to; // of a box
  SlicerKind kind = SlicerKind::Part;
  SlicerSettings settings = {}; // "extruder" among them
  int openTriangles = 0;        // left out at the end
};

struct SlicerRange {
  double fromMm = 0.0, toMm = 0.0;
  SlicerSettings settings;
};

struct SlicerEvent {
  double heightMm = 0.0;
  int type = 1; // 0: colour, 1: pause, 2: tool, 3: template, 4: G-code
  int extruder = 1;
  std::string extra = {}, color = {};
};

// One object.
struct SlicerPart {
  std::vector<SlicerVolume> volumes;
  std::vector<SlicerRange> ranges = {};
  std::vector<SlicerEvent> events = {};
  std::string onTriangle = {}; // attributes of the first triangle of each volume
  double layerHeightMm = 0.0;  // in the slicer's settings; 0: not stated
};

inline std::string boxesMesh(const std::vector<SlicerVolume>& boxes,
                             const std::string& onTriangle = {}) {
  constexpr std::array<std::array<int, 3>, 12> kFaces{{{0, 2, 1},
                                                       {1, 2, 3},
                                                       {4, 5, 6},
                                                       {5, 7, 6},
                                                       {0, 1, 4},
                                                       {1, 5, 4},
                                                       {2, 6, 3},
                                                       {3, 6, 7},
                                                       {0, 4, 2},
                                                       {2, 4, 6},
                                                       {1, 3, 5},
                                                       {3, 7, 5}}};
  std::string vertices, triangles;
  int first = 0;
  for (const SlicerVolume& box : boxes) {
    for (int i = 0; i < 8; ++i)
      vertices +=
          fmt::format(R"(<vertex x="{}" y="{}" z="{}"/>)", i & 1 ? box.to.x() : box.from.x(),
                      i & 2 ? box.to.y() : box.from.y(), i & 4 ? box.to.z() : box.from.z());
    for (int t = 0; t < 12 - box.openTriangles; ++t) {
      const auto& face = kFaces[static_cast<std::size_t>(t)];
      triangles += fmt::format(R"(<triangle v1="{}" v2="{}" v3="{}"{}/>)", first + face[0],
                               first + face[1], first + face[2], t == 0 ? " " + onTriangle : "");
    }
    first += 8;
  }
  return "<mesh><vertices>" + vertices + "</vertices><triangles>" + triangles +
         "</triangles></mesh>";
}

inline std::string slicerModel(const std::string& resources, const std::string& build) {
  return "<model unit=\"millimeter\" "
         "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
         "xmlns:slic3rpe=\"http://schemas.slic3r.org/3mf/2017/06\"><resources>" +
         resources + "</resources><build>" + build + "</build></model>";
}

inline std::string rangesText(const std::vector<SlicerPart>& parts) {
  std::string xml = "<objects>";
  for (std::size_t i = 0; i < parts.size(); ++i) {
    xml += fmt::format(R"(<object id="{}">)", i + 1);
    for (const SlicerRange& range : parts[i].ranges) {
      xml += fmt::format(R"(<range min_z="{}" max_z="{}">)", range.fromMm, range.toMm);
      for (const auto& [key, value] : range.settings)
        xml += fmt::format(R"(<option opt_key="{}">{}</option>)", key, value);
      xml += "</range>";
    }
    xml += "</object>";
  }
  return xml + "</objects>";
}

inline std::string eventsText(const SlicerPart& part, const char* element, const char* height) {
  std::string xml;
  for (const SlicerEvent& event : part.events)
    xml += fmt::format(
        R"(<{} {}="{}" type="{}" extruder="{}" color="{}" extra="{}" gcode="M601"/>)", element,
        height, event.heightMm, event.type, event.extruder, event.color, event.extra);
  return xml;
}

// Volumes are stretches of one mesh. `instances`: of each object, 80 mm apart along y; objects are
// 120 mm apart along x.
inline std::string prusaPackage(const std::vector<SlicerPart>& parts, int instances = 1) {
  constexpr std::array<const char*, 5> kWords{"ModelPart", "NegativeVolume", "ParameterModifier",
                                              "SupportEnforcer", "SupportBlocker"};
  std::string resources, build, config = "<config>";
  int id = 1;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const int original = id;
    for (int i = 0; i < instances; ++i, ++id) {
      resources += fmt::format(
          R"(<object id="{}">{}</object>)", id,
          i == 0 ? boxesMesh(parts[p].volumes, parts[p].onTriangle)
                 : fmt::format("<components><component objectid=\"{}\"/></components>", original));
      build += fmt::format(R"(<item objectid="{}" transform="1 0 0 0 1 0 0 0 1 {} {} 0"/>)", id,
                           120 * p, 80 * i);
    }
    config += fmt::format(
        R"(<object id="{}" instances_count="{}"><metadata type="object" key="name" value="part {}"/>)",
        original, instances, p + 1);
    int first = 0;
    for (const SlicerVolume& volume : parts[p].volumes) {
      const int last = first + 11 - volume.openTriangles;
      config += fmt::format(
          R"(<volume firstid="{}" lastid="{}"><metadata type="volume" key="name" value="{}"/>)"
          R"(<metadata type="volume" key="volume_type" value="{}"/>)",
          first, last, volume.name, kWords[static_cast<std::size_t>(volume.kind)]);
      for (const auto& [key, value] : volume.settings)
        config += fmt::format(R"(<metadata type="volume" key="{}" value="{}"/>)", key, value);
      config += "</volume>";
      first = last + 1;
    }
    config += "</object>";
  }
  ZipWriter zip(true);
  addRelations(zip);
  zip.add("3D/3dmodel.model", slicerModel(resources, build));
  zip.add("Metadata/Slic3r_PE_model.config", config + "</config>");
  zip.add("Metadata/Prusa_Slicer_layer_config_ranges.xml", rangesText(parts));
  zip.add("Metadata/Prusa_Slicer_custom_gcode_per_print_z.xml",
          "<custom_gcodes_per_print_z>" + eventsText(parts.front(), "code", "print_z") +
              "<mode value=\"SingleExtruder\"/></custom_gcodes_per_print_z>");
  if (parts.front().layerHeightMm > 0.0)
    zip.add(
        "Metadata/Slic3r_PE.config",
        fmt::format("; generated by PrusaSlicer\n; first_layer_height = 0.9\n; layer_height = {}\n",
                    parts.front().layerHeightMm));
  return zip.bytes();
}

// Volumes are components; `ownModel`: in a model beside the main one, as OrcaSlicer and newer
// versions of Bambu Studio write them. Objects are 120 mm apart along x.
inline std::string bambuPackage(const std::vector<SlicerPart>& parts, bool ownModel) {
  constexpr std::array<const char*, 5> kWords{"normal_part", "negative_part", "modifier_part",
                                              "support_enforcer", "support_blocker"};
  const std::string path =
      ownModel
          ? R"( xmlns:p="http://schemas.microsoft.com/3dmanufacturing/production/2015/06" p:path="/3D/Objects/object_1.model")"
          : "";
  std::string meshes, objects, build, config = "<config>";
  int id = 1;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    std::string components, volumes;
    for (const SlicerVolume& volume : parts[p].volumes) {
      meshes += fmt::format(R"(<object id="{}">{}</object>)", id,
                            boxesMesh({volume}, parts[p].onTriangle));
      components += fmt::format(R"(<component{} objectid="{}"/>)", path, id);
      volumes += fmt::format(
          R"(<part id="{}" subtype="{}"><metadata key="name" value="{}"/><metadata key="matrix" value="1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"/>)",
          id, kWords[static_cast<std::size_t>(volume.kind)], volume.name);
      for (const auto& [key, value] : volume.settings)
        volumes += fmt::format(R"(<metadata key="{}" value="{}"/>)", key, value);
      volumes += "<mesh_stat edges_fixed=\"0\"/></part>";
      ++id;
    }
    objects +=
        fmt::format(R"(<object id="{}"><components>{}</components></object>)", id, components);
    build +=
        fmt::format(R"(<item objectid="{}" transform="1 0 0 0 1 0 0 0 1 {} 0 0"/>)", id, 120 * p);
    config += fmt::format(
        R"(<object id="{}"><metadata key="name" value="part {}"/><metadata key="extruder" value="1"/>{}</object>)",
        id, p + 1, volumes);
    ++id;
  }
  ZipWriter zip(true);
  addRelations(zip);
  zip.add("3D/3dmodel.model", slicerModel(ownModel ? objects : meshes + objects, build));
  if (ownModel)
    zip.add("3D/Objects/object_1.model", slicerModel(meshes, ""));
  zip.add("Metadata/model_settings.config", config + "</config>");
  zip.add("Metadata/layer_config_ranges.xml", rangesText(parts));
  zip.add("Metadata/custom_gcode_per_layer.xml",
          "<custom_gcodes_per_layer><plate><plate_info id=\"1\"/>" +
              eventsText(parts.front(), "layer", "top_z") +
              "<mode value=\"SingleExtruder\"/></plate></custom_gcodes_per_layer>");
  if (parts.front().layerHeightMm > 0.0)
    zip.add("Metadata/project_settings.config",
            fmt::format("{{\"initial_layer_print_height\": \"0.9\", \"layer_height\": \"{}\"}}",
                        parts.front().layerHeightMm));
  return zip.bytes();
}

} // namespace voluta::test
