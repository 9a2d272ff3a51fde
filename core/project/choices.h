// What the user chose for a part.
#pragma once

#include "curved/growth_scheme.h"
#include "geometry/placement.h"
#include "layers/print_order.h"
#include "project/platform.h"

#include <map>
#include <string>
#include <vector>

namespace voluta::project {

// What the user chose for one part of a job.
struct ItemChoices {
  // Planning searches for the way of building; mode and platform are then those of the last search.
  // The other choices stay.
  bool automatic = false;
  bool platformStays = false; // with automatic: the platform is the user's
  std::string automaticWay;   // with automatic: the way that the last search chose
                              // (pipeline/automatic.h)
  std::string mode = "curved";
  curved::GrowthScheme growth;
  Platform platform;
  std::string scale = "1";  // a number or "fit"
  std::string units = "mm"; // of a mesh's file: length_unit.h
  geometry::Placement placement;
  bool repair = true;                            // false: the mesh as it was read
  std::map<std::string, std::string> parameters; // changed ones, as text
};

struct ToolChoice {
  std::string process = "fdm-1.0"; // an id, or the text of a process's file
};

// What the user chose for a job; together with the meshes it decides every result.
struct Choices {
  std::string cell = "ur5-fixed";                 // an id, or the text of a cell's file
  std::vector<ToolChoice> tools = {ToolChoice{}}; // one or more; paths name them by index
  std::vector<std::string> formats;               // empty: the cell's controller, gcode-extended
  int seed = 1;
  layers::PrintOrder printOrder = layers::PrintOrder::OneAfterAnother; // of several items
  std::vector<ItemChoices> items = {ItemChoices{}}; // one or more, in the order of the job's items

  ItemChoices& item(std::size_t i = 0) { return items.at(i); }
  const ItemChoices& item(std::size_t i = 0) const { return items.at(i); }
  ToolChoice& tool(std::size_t i = 0) { return tools.at(i); }
  const ToolChoice& tool(std::size_t i = 0) const { return tools.at(i); }
};

// The same job with only that item: what the stages of one item (Load to Layers) take.
// Precondition: item < choices.items.size().
Choices onlyItem(const Choices& choices, std::size_t item);

// A number > 0, or "fit" (returns 0). Throws Error{Usage}.
double parsedScale(const std::string& scale);

} // namespace voluta::project
