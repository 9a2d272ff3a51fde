// The user's choices for a part.
#pragma once

#include "curved/growth_scheme.h"
#include "geometry/placement.h"
#include "layers/print_order.h"
#include "project/platform.h"
#include "project/region.h"

#include <map>
#include <string>
#include <vector>

namespace voluta::project {

// The user's choices for one part of a job.
struct ItemChoices {
  // True: planning searches for the way of building and sets mode and platform to the chosen way's.
  // All other choices stay.
  bool automatic = false;
  bool platformStays = false;    // with automatic: keep the user's platform
  std::string automaticStrategy; // with automatic: the way chosen last (pipeline/automatic.h)
  std::string mode = "curved";
  curved::GrowthScheme growth;
  Platform platform;
  std::string scale = "1";  // a number or "fit"
  std::string units = "mm"; // of the mesh's file, see length_unit.h
  geometry::Placement placement;
  bool repair = true; // false: use the mesh as read
  // Non-default values as text, of parameters with a value for each item
  std::map<std::string, std::string> parameters;
  std::vector<Region> regions; // in their order: the later one holds where two overlap
};

struct ToolChoice {
  std::string process = "fdm-1.0"; // an id, or the text of a process's file

  bool operator==(const ToolChoice&) const = default;
};

// The user's choices for a job; together with the meshes they determine every result.
struct Choices {
  std::string cell = "ur5-fixed";                 // an id, or the text of a cell's file
  std::vector<ToolChoice> tools = {ToolChoice{}}; // one or more; paths name them by index
  std::vector<std::string> formats;               // empty: the cell's controller, gcode-extended
  int seed = 1;
  layers::PrintOrder printOrder = layers::PrintOrder::OneAfterAnother; // of several items
  // Preset that the parameters began with: an id, or the text of an own one (pipeline/presets). The
  // parameters alone determine the results.
  std::string preset = "usual";
  // Non-default values as text, of parameters that all items share
  std::map<std::string, std::string> parameters;
  std::vector<ItemChoices> items = {ItemChoices{}}; // one or more, in the order of the job's items

  ItemChoices& item(std::size_t i = 0) { return items.at(i); }
  const ItemChoices& item(std::size_t i = 0) const { return items.at(i); }
  ToolChoice& tool(std::size_t i = 0) { return tools.at(i); }
  const ToolChoice& tool(std::size_t i = 0) const { return tools.at(i); }
};

// Returns the choices of a job with only that item, as the stages of one item (Load to Layers) take
// them. Precondition: item < choices.items.size().
Choices onlyItem(const Choices& choices, std::size_t item);

// Returns the number, which is > 0, or 0 for "fit". Throws Error{Usage}.
double parsedScale(const std::string& scale);

} // namespace voluta::project
