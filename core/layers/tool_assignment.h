// Which tool of a job prints which patch of a part.
#pragma once

#include "base/parameters.h"
#include "layers/layer_stack.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace voluta::layers {

inline constexpr std::size_t kMaxTools = 4; // outputs of controllers select three besides the first

// Indices in the job's tooling.
struct ToolAssignment {
  int part = 0;    // the part, where nothing else is assigned
  int support = 0; // support patches
  int infill = 0;  // the interior within walls and skins
  // By Patch::group, starting over if there are more groups; empty: `part`.
  std::vector<int> pieces = {};
  // By Patch::layer: the tool that prints the part from there on, whatever prints it below.
  std::map<int, int> fromLayer = {};

  bool operator==(const ToolAssignment&) const = default;
  // Returns the tools in use, ascending, each once.
  std::vector<int> used() const;
};

// Keys: tool, supportTool, infillTool, pieceTools. Users count tools from 1.
base::ParameterTable toolParameters();
// fromLayer is empty. Precondition: `values` are over a table with toolParameters(). Throws
// Error{Usage} if pieceTools is not a list of numbers from 1, or a tool is not one of `tools`.
ToolAssignment toolAssignment(const base::ParameterValues& values, std::size_t tools);
// Returns the tool of the text of parameter `tool` (empty: the first), as an index; the first if it
// is no number from 1 to `tools`, which toolAssignment() reports.
std::size_t partTool(const std::string& text, std::size_t tools);

// Changes the assignments (texts by key, as project files store them) for a job from which the tool
// of that number is removed: the first tool prints its patches, later tools get the number before.
void forgetTool(std::map<std::string, std::string>& parameters, int number);

// Sets the tool of every patch. Throws Error{Usage} if the stack lacks a layer of
// assignment.fromLayer.
void assignTools(LayerStack& stack, const ToolAssignment& assignment);

} // namespace voluta::layers
