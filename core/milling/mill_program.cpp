#include "milling/mill_program.h"

#include <fmt/format.h>
#include <iterator>

namespace voluta::milling {

namespace {

std::string_view nameOf(MillSide side) {
  switch (side) {
  case MillSide::A:
    return "side A";
  case MillSide::B:
    return "side B";
  case MillSide::Contour:
    break;
  }
  return "contour";
}

// A comment ends at its bracket.
std::string withoutBrackets(std::string text) {
  std::erase_if(text, [](char c) { return c == '(' || c == ')' || c == '\n' || c == '\r'; });
  return text;
}

} // namespace

Eigen::Vector3d originOf(MillSide side, const Eigen::AlignedBox3d& block) {
  const Eigen::Vector3d middle = block.center();
  if (side == MillSide::A)
    return {middle.x(), middle.y(), block.max().z()};
  return {middle.x(), -middle.y(), -block.min().z()};
}

std::string writeMilling(const MillPlan& plan, const MillRule& rule, const std::string& name) {
  std::string out;
  const auto to = std::back_inserter(out);
  const Eigen::Vector3d size = plan.block.sizes();
  fmt::format_to(to, "({}, {}, cutter {:g} mm)\n", withoutBrackets(name), rule.data.id,
                 rule.cutter.diameterMm);
  fmt::format_to(to, "(block {:.3f} x {:.3f} x {:.3f} mm)\n", size.x(), size.y(), size.z());
  fmt::format_to(to, "G21\nG90\nG94\nG53 G0 Z0\nG0 A0\nS{:.0f} M3\n", rule.data.rpm);
  for (const MillPasses& passes : plan.sides) {
    if (passes.side == MillSide::B)
      out += "G53 G0 Z0\nG0 A180\n";
    fmt::format_to(to, "({})\n{}\nF{:.3f}\n", nameOf(passes.side),
                   passes.side == MillSide::A ? "G54" : "G55",
                   feedMmPerMin(rule.cutter, rule.data));
    const Eigen::Vector3d origin = originOf(passes.side, plan.block);
    for (const MillMove& move : passes.moves) {
      const Eigen::Vector3d at = move.to - origin;
      fmt::format_to(to, "{} X{:.3f} Y{:.3f} Z{:.3f}\n", move.step == MillStep::Rapid ? "G0" : "G1",
                     at.x(), at.y(), at.z());
    }
  }
  out += "G53 G0 Z0\nM5\nM30\n";
  return out;
}

} // namespace voluta::milling
