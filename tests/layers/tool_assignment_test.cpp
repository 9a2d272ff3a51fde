// Which tool prints which patch, and lists of tools that cannot be read.
#include "base/error.h"
#include "layers/tool_assignment.h"

#include <gtest/gtest.h>

namespace voluta::layers {
namespace {

base::ParameterValues valuesOf(const std::vector<std::string>& assignments) {
  base::ParameterValues values(toolParameters());
  for (const std::string& assignment : assignments)
    values.setAssignment(assignment);
  return values;
}

LayerStack stackOf(const std::vector<int>& groups) {
  LayerStack stack;
  for (const int group : groups) {
    Patch patch;
    patch.group = group;
    stack.patches.push_back(patch);
  }
  return stack;
}

std::vector<int> toolsOf(const LayerStack& stack) {
  std::vector<int> tools;
  for (const Patch& patch : stack.patches)
    tools.push_back(patch.tool);
  return tools;
}

TEST(ToolAssignment, TheFirstToolPrintsEverythingByDefault) {
  const ToolAssignment assignment = toolAssignment(valuesOf({}), 1);
  EXPECT_EQ(assignment, ToolAssignment{});
  EXPECT_EQ(assignment.used(), std::vector<int>{0});
}

TEST(ToolAssignment, SupportsAndInteriorFollowThePart) {
  const ToolAssignment assignment = toolAssignment(valuesOf({"tool=2"}), 2);
  EXPECT_EQ(assignment.used(), std::vector<int>{1});
  LayerStack stack = stackOf({0, kSupportGroup, 3});
  assignTools(stack, assignment);
  EXPECT_EQ(toolsOf(stack), (std::vector<int>{1, 1, 1}));
}

TEST(ToolAssignment, PiecesTakeTheToolsOfTheListInTurn) {
  const ToolAssignment assignment =
      toolAssignment(valuesOf({"supportTool=3", "pieceTools=1, 2"}), 3);
  EXPECT_EQ(assignment.used(), (std::vector<int>{0, 1, 2}));
  LayerStack stack = stackOf({0, 1, kSupportGroup, 2, 3});
  assignTools(stack, assignment);
  EXPECT_EQ(toolsOf(stack), (std::vector<int>{0, 1, 2, 0, 1}));
}

TEST(ToolAssignment, RefusesToolsThatTheJobDoesNotHave) {
  for (const char* text : {"tool=2", "supportTool=2", "infillTool=4", "pieceTools=1,2",
                           "pieceTools=0", "pieceTools=red", "pieceTools=1,,1", "pieceTools=1 1"})
    EXPECT_THROW(toolAssignment(valuesOf({text}), 1), base::Error) << text;
  EXPECT_NO_THROW(toolAssignment(valuesOf({"pieceTools=1,1"}), 1));
}

TEST(ToolAssignment, ReadsTheToolOfAPart) {
  EXPECT_EQ(partTool("2", 2), 1u);
  for (const char* text : {"", "0", "3", "two", "1.5"})
    EXPECT_EQ(partTool(text, 2), 0u) << text;
}

} // namespace
} // namespace voluta::layers
