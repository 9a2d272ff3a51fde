// One of the parts that a file holds.
#pragma once

#include "geometry/formats/mesh_reader.h"

#include <Eigen/Core>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace voluta::geometry {

constexpr std::size_t kMaxPartsOfFile = 255;

// A place within a part to which its file gives settings of its own. A support enforcer or blocker
// has "volume_type", paint has the setting of paintSetting() with its state.
struct ModifierOfFile {
  std::string name;                // of its volume; empty: none
  TriangleMesh mesh;               // as read, in the coordinates of the part's mesh; empty: heights
  double fromMm = 0.0, toMm = 0.0; // heights over the lowest point of the part
  // Keys and values of the slicer, each key once. "extruder" is from 1, and differs from the
  // part's.
  std::vector<std::pair<std::string, std::string>> settings;
  bool isPainted = false; // the mesh is a surface of the part
};

// What a slicer is to do before a layer.
enum class EventOfFileKind { Colour, Pause, Tool };
struct EventOfFile {
  EventOfFileKind kind = EventOfFileKind::Pause;
  double heightMm = 0.0; // over the plate, where the layer begins
  int extruder = 1;      // Tool: from 1
  std::string text = {}; // Pause: for the operator; Colour: the colour; empty: none
};

struct PartOfFile {
  std::string name; // of its object or product; empty: none
  MeshFile file;
  Eigen::Vector3d placeMm{0.0, 0.0, 0.0};     // of the mesh's origin in the file
  std::vector<ModifierOfFile> modifiers = {}; // where two overlap, the later one holds
  std::vector<EventOfFile> events = {};       // ascending
};

// Throws Error{UnusableInput} if the file holds more than kMaxPartsOfFile parts.
void requirePrintable(std::size_t parts, const std::string& file);

} // namespace voluta::geometry
