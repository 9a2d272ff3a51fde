#include "layers/tool_assignment.h"

#include "base/error.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <optional>

namespace voluta::layers {

namespace {
constexpr const char *kTool = "tool", *kSupportTool = "supportTool", *kInfillTool = "infillTool",
                     *kPieceTools = "pieceTools";
constexpr auto kMaxTool = static_cast<long long>(kMaxTools);

// Returns the number of the text without spaces around it; 0 if it is none.
int numberOf(std::string_view text) {
  while (!text.empty() && text.front() == ' ')
    text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ')
    text.remove_suffix(1);
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size() ? number : 0;
}

int checkedTool(long long number, std::size_t tools, const char* key) {
  if (number < 1 || number > static_cast<long long>(tools))
    throw base::Error(
        base::ErrorCode::Usage,
        base::message("the job has no tool {number}, it has {tools}"_text, number, tools),
        std::string(key), "add a tool, or give the number of one"_text);
  return static_cast<int>(number) - 1;
}
} // namespace

std::vector<int> ToolAssignment::used() const {
  std::vector<int> tools{part, support, infill};
  tools.insert(tools.end(), pieces.begin(), pieces.end());
  for (const auto& [layer, tool] : fromLayer)
    tools.push_back(tool);
  std::ranges::sort(tools);
  tools.erase(std::ranges::unique(tools).begin(), tools.end());
  return tools;
}

base::ParameterTable toolParameters() {
  return base::ParameterTable({
      base::ofRegion(base::integerParameter(
          kTool, 1, 1, kMaxTool, "Tools"_text, "tool"_text,
          "Number of the tool that prints the part. The tips of all tools are in one "
          "place, that of the cell's nozzle."_text,
          true)),
      base::integerParameter(kSupportTool, 0, 0, kMaxTool, "Tools"_text, "support tool"_text,
                             "Number of the tool that prints supports; 0: that of the part."_text,
                             true),
      base::ofRegion(base::integerParameter(
          kInfillTool, 0, 0, kMaxTool, "Tools"_text, "infill tool"_text,
          "Number of the tool that fills the interior within walls and skins; 0: that of "
          "the part."_text,
          true)),
      base::textParameter(
          kPieceTools, "Tools"_text, "tools of the pieces"_text,
          "Mode planar: numbers of the tools that print the pieces, separated by commas. "
          "The list starts over if there are more pieces. Empty: the tool of the part."_text),
  });
}

ToolAssignment toolAssignment(const base::ParameterValues& values, std::size_t tools) {
  ToolAssignment out;
  out.part = checkedTool(values.integer(kTool), tools, kTool);
  const auto orPart = [&](const char* key) {
    const long long number = values.integer(key);
    return number == 0 ? out.part : checkedTool(number, tools, key);
  };
  out.support = orPart(kSupportTool);
  out.infill = orPart(kInfillTool);
  const std::string text = values.text(kPieceTools);
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t to = std::min(text.find(',', from), text.size());
    const int number = numberOf(std::string_view(text).substr(from, to - from));
    if (number == 0)
      throw base::Error(base::ErrorCode::Usage,
                        base::message("'{text}' is not a list of tools"_text, text),
                        std::string(kPieceTools), "give numbers, such as 1,2"_text);
    out.pieces.push_back(checkedTool(number, tools, kPieceTools));
    from = to + 1;
  }
  return out;
}

std::size_t partTool(const std::string& text, std::size_t tools) {
  const int number = numberOf(text);
  const bool isTool = number >= 1 && static_cast<std::size_t>(number) <= tools;
  return isTool ? static_cast<std::size_t>(number) - 1 : 0;
}

void forgetTool(std::map<std::string, std::string>& parameters, int number) {
  const auto without = [number](int tool) {
    return tool == number ? 1 : tool > number ? tool - 1 : tool;
  };
  for (const char* key : {kTool, kSupportTool, kInfillTool, kPieceTools}) {
    const auto found = parameters.find(key);
    if (found == parameters.end())
      continue;
    std::string text;
    for (std::size_t from = 0; from < found->second.size();) {
      const std::size_t to = std::min(found->second.find(',', from), found->second.size());
      const int tool = numberOf(std::string_view(found->second).substr(from, to - from));
      text += (text.empty() ? "" : ",") + std::to_string(without(tool));
      from = to + 1;
    }
    found->second = text;
  }
}

namespace {
// Returns the tool that an event of the layers sets; nullopt: none.
std::optional<int> toolFrom(const std::map<int, int>& fromLayer, int layer) {
  const auto behind = fromLayer.upper_bound(layer);
  return behind == fromLayer.begin() ? std::nullopt : std::optional(std::prev(behind)->second);
}

void requireLayers(const LayerStack& stack, const std::map<int, int>& fromLayer) {
  int layers = 0;
  for (const Patch& patch : stack.patches)
    layers = std::max(layers, patch.layer + 1);
  if (!fromLayer.empty() && fromLayer.rbegin()->first >= layers)
    throw base::Error(base::ErrorCode::Usage,
                      base::message("no change of the tool before layer {layer}: the part has "
                                    "{layers} layers"_text,
                                    fromLayer.rbegin()->first + 1, layers),
                      std::string("layerEvents"),
                      "correct the setting; layers are counted for each part"_text);
}
} // namespace

void assignTools(LayerStack& stack, const ToolAssignment& assignment) {
  requireLayers(stack, assignment.fromLayer);
  for (Patch& patch : stack.patches)
    if (patch.group == kSupportGroup)
      patch.tool = assignment.support;
    else if (const auto tool = toolFrom(assignment.fromLayer, patch.layer))
      patch.tool = *tool;
    else if (!assignment.pieces.empty() && patch.group >= 0 && patch.group < kRegionGroups)
      patch.tool =
          assignment.pieces[static_cast<std::size_t>(patch.group) % assignment.pieces.size()];
    else
      patch.tool = assignment.part;
  for (Pocket& pocket : stack.pockets)
    pocket.tool = assignment.part;
}

} // namespace voluta::layers
