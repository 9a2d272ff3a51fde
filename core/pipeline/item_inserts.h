// What the operator puts into the parts of a job while they are printed.
#pragma once

#include "geometry/triangle_mesh.h"
#include "plan/finding.h"
#include "plan/layer_event.h"
#include "plan/tool_plan.h"

#include <span>
#include <string>
#include <vector>

namespace voluta::pipeline {

// An insert of an item.
struct PlacedInsert {
  std::string name;  // may be empty
  std::string shape; // of its region
  int layer =
      0; // of the item, from 1, before which it is put in; 0: the first one that ends above it
  geometry::TriangleMesh body; // closed; work frame
};

// Returns the pauses in which they are put in, without those that insertsAmong() leaves out.
std::vector<plan::LayerEvent> insertPauses(const plan::ToolPlan& plan,
                                           std::span<const PlacedInsert> inserts, int item);

// Returns them as they belong to the tool-paths of the job, without those before which nothing of
// the item is left to print.
std::vector<plan::Insert> insertsAmong(const plan::ToolPlan& plan,
                                       std::span<const PlacedInsert> inserts, int item);

// Returns findings about inserts of an item that do not fit to the tool-paths: beads lie above them
// before they are put in, or in their place; they stand above the next layer, or are thinner than
// one; nothing carries them; nothing is printed after them; they reach below the plate, if the item
// stands on one; two take one place.
plan::Findings insertFindings(const plan::ToolPlan& plan, std::span<const PlacedInsert> inserts,
                              int item, bool isOnPlate);

} // namespace voluta::pipeline
