// The parameters pauseLayers and layerEvents as texts.
#pragma once

#include "plan/layer_event.h"

#include <string>
#include <string_view>
#include <vector>

namespace voluta::base {
class ParameterValues;
}

namespace voluta::motion {

inline constexpr const char* kPauseLayers = "pauseLayers";
inline constexpr const char* kLayerEvents = "layerEvents";
inline constexpr std::size_t kOwnTextLength = plan::kPauseTextLength;

// Returns the layers that a value of pauseLayers lists, from 1, ascending. Throws Error{Usage} if
// it is no list of layers.
std::vector<int> pauseLayersOf(std::string_view text);
// The inverse: "12, 40".
std::string pauseLayersText(const std::vector<int>& layers);

// Returns the events that a value of layerEvents lists, of item 0. Each begins with a layer or a
// height, behind the first they are separated by semicolons:
//   12 pause; 20 pause Put in the nut; z5.5 wait 60; 30 output 3 on; 35 photo 4 0.5; 40 tool 2;
//   45 filament Change to red; 50 statement urscript set_tool_voltage(24)
// Statements of several formats at a place stand for each other: a program has those of its own.
// A semicolon that no event follows belongs to the text before it. Throws Error{Usage} that names
// the event that is none.
std::vector<plan::LayerEvent> layerEventsOf(std::string_view text);

// Returns a value of layerEvents for a job from which the tool of that number is removed: the first
// tool prints what it printed, later tools get the number before. A text that lists no events is
// returned as it is.
std::string eventsWithoutTool(std::string_view text, int number);

// Returns the events of both parameters, of item 0: pauses of pauseLayers first. Throws as
// pauseLayersOf() and layerEventsOf(). Precondition: as motionOptions().
std::vector<plan::LayerEvent> eventsAsked(const base::ParameterValues& values);

} // namespace voluta::motion
