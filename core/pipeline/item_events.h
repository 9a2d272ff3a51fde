// Events of layers of a job's items: those that its parameters ask for, and the stops of a slicer's
// file.
#pragma once

#include "plan/layer_event.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::base {
class Error;
class ParameterValues;
} // namespace voluta::base
namespace voluta::plan {
struct ToolPlan;
}
namespace voluta::project {
struct Choices;
struct LoadedPart;
} // namespace voluta::project

namespace voluta::pipeline {

// Returns the events of one item: pauses where the tool-paths of its file stop, if it is printed
// along them, then those of the parameters but changes of the tool, which its tool-paths have.
// Throws Error{Usage} as motion::eventsAsked(), for a change of the tool in a file's tool-paths,
// and for a statement with a word that it must not have (program/refused_statements.h).
std::vector<plan::LayerEvent> eventsOfItem(const project::LoadedPart& loaded,
                                           const base::ParameterValues& values, int item);

// Returns the reason why programs of the job cannot have the events of a text of layerEvents:
// a text that lists none, a refused word, an output or a command that a format to be written lacks.
// nullopt: they can.
std::optional<base::Error> eventRefusal(const project::Choices& choices, std::string_view text);

// Returns their part of a stage's key; empty if there are none.
std::string eventsKey(const std::vector<plan::LayerEvent>& events);
// Returns that part of a key in which it is the last; empty if it has none.
std::string_view eventsIn(std::string_view key);

// Throws Error{Usage} if an item lacks a layer before which something is to happen: it would never
// come.
void requireEventPlaces(const plan::ToolPlan& plan, const std::vector<plan::LayerEvent>& events);

} // namespace voluta::pipeline
