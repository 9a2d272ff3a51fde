// Edits of the events before layers: pauses and all others, as settings of the part that has the
// layer.
#pragma once

#include "window/pages/page.h"

#include <QString>
#include <string>
#include <vector>

namespace voluta::window {

// Layers of the whole print, from 0, before which it pauses; as the slider counts them.
std::vector<int> pausedLayers(const Workspace& workspace);

// The same, before which the shown plan has another event, or a part is put in.
std::vector<int> eventLayers(const Workspace& workspace);

// Adds a pause before a layer of the print, or removes it.
void setPause(const Workspace& workspace, int layer, bool pause);

// Adds an event before a layer of the print: a text of layerEvents behind its place, for example
// "wait 60". Throws Error{Usage} if it is none, or if no part has the layer.
void addEvent(const Workspace& workspace, int layer, const std::string& event);

// Asks for an event before a layer of the print and adds it.
void askForEvent(const Workspace& workspace, int layer, QWidget* parent);

} // namespace voluta::window
