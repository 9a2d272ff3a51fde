// What the user asks for before a layer of a part: a pause, a wait, another tool, an output, a
// statement of his own, a photo.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace voluta::plan {

enum class LayerEventKind : std::uint8_t {
  Pause,     // the arm waits beside the part until the operator continues
  Wait,      // the arm waits beside the part for `seconds`
  Output,    // the machine's digital output `number` is set to `on`
  Tool,      // from here on tool `number` prints, from 1
  Statement, // `text` is a line of programs of `format`
  Photo      // the arm waits beside the part while output `number` is on for `seconds`
};

// The first of `layer`, `heightMm` and `bead` that is positive says where.
struct LayerEvent {
  int item = 0;          // index in the job's items
  int layer = 0;         // before this layer of the item, from 1
  double heightMm = 0.0; // before the first layer of the item that ends above this height [mm]
  int bead = 0;          // before this bead of the item, from 1: a stop of a file's tool-paths
  LayerEventKind kind = LayerEventKind::Pause;
  double seconds = 0.0;
  int number = 0;
  bool on = false;
  bool isListed = false;        // Pause: of the list pauseLayers
  bool changesFilament = false; // Pause: the nozzle is purged as after a change of the tool
  std::string text = {};        // Pause: shown to the operator; empty: the usual text
  std::string format = {};
};

// A pause's own text is at most this long, so that its layer has room beside it.
inline constexpr std::size_t kPauseTextLength = 44;

} // namespace voluta::plan
