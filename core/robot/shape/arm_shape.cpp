#include "robot/shape/arm_shape.h"

#include "base/json_node.h"
#include "base/units.h"
#include "robot/cell/json_pose.h"

#include <algorithm>
#include <cmath>

namespace voluta::robot {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kUsualRoundMm = 2.0;
constexpr int kMaxCopies = 64;

Rgb readColour(const base::JsonNode& node) {
  const std::string text = node.text();
  const auto isHex = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F');
  };
  if (text.size() != 7 || text[0] != '#' || !std::all_of(text.begin() + 1, text.end(), isHex))
    node.fail("must be a colour like \"#d0d4d8\""_text);
  Rgb colour;
  for (std::size_t k = 0; k < 3; ++k)
    colour[k] = std::stoi(text.substr(1 + 2 * k, 2), nullptr, 16) / 255.0;
  return colour;
}

Vector3d readDirection(const base::JsonNode& node) {
  const Vector3d direction = readVector3(node);
  if (direction.norm() == 0.0)
    node.fail("must not have zero length"_text);
  return direction.normalized();
}

std::vector<base::JsonNode> itemsOf(const base::JsonNode& node, std::size_t count) {
  std::vector<base::JsonNode> items = node.items();
  if (items.size() != count)
    node.fail(base::message("must hold {wanted} values, holds {found}"_text, count, items.size()));
  return items;
}

LoftSection readCircle(const base::JsonNode& node) {
  const auto values = itemsOf(node, 2);
  return circleSection(values[0].number(), values[1].positive());
}

LoftSection readHull(const base::JsonNode& node) {
  const auto values = itemsOf(node, 2);
  LoftSection section{values[0].number(), {}};
  for (const base::JsonNode& item : values[1].items()) {
    const auto disc = itemsOf(item, 3);
    section.discs.push_back({Vector2d(disc[0].number(), disc[1].number()), disc[2].positive()});
  }
  for (std::size_t i = 0; i < section.discs.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if ((section.discs[i].centre - section.discs[j].centre).norm() <=
          std::abs(section.discs[i].radius - section.discs[j].radius))
        values[1].fail("has a disc inside another"_text);
  return section;
}

std::vector<LoftSection> readSections(const base::JsonNode& node, bool turned) {
  std::vector<LoftSection> sections;
  for (const base::JsonNode& item : node.items()) {
    sections.push_back(turned ? readCircle(item) : readHull(item));
    const LoftSection &first = sections.front(), &last = sections.back();
    if (last.discs.empty() || last.discs.size() != first.discs.size())
      item.fail("must hold as many discs as the first, at least one"_text);
    if (sections.size() > 1 && last.at < sections[sections.size() - 2].at)
      item.fail("must not be before the previous one"_text);
  }
  if (sections.size() < 2 || sections.back().at <= sections.front().at)
    node.fail("must not have zero length"_text);
  return sections;
}

Loft readLoft(const base::JsonNode& node) {
  const bool turned = node.has("turnedMm");
  Loft loft;
  const Vector3d axis = readDirection(node.at("axis"));
  Vector3d across = Vector3d::Zero();
  if (!turned) {
    across = readDirection(node.at("across"));
    if (across.cross(axis).norm() < 1e-6)
      node.at("across").fail("must not be along the axis"_text);
  }
  loft.frame_T_loft = loftPose(readVector3(node.at("fromMm")), axis, across);
  loft.sections = readSections(node.at(turned ? "turnedMm" : "sectionsMm"), turned);
  loft.roundMm = node.has("roundMm") ? node.at("roundMm").notNegative() : kUsualRoundMm;
  return loft;
}

void addCopies(const base::JsonNode& node, const ShapeSolid& solid,
               std::vector<ShapeSolid>& solids) {
  const int count = node.has("count") ? node.at("count").integer() : 1;
  if (count < 1 || count > kMaxCopies)
    node.at("count").fail(base::message("must be in 1..{most}"_text, kMaxCopies));
  const Vector3d about = count > 1 ? readDirection(node.at("about")) : Vector3d::UnitZ();
  for (int i = 0; i < count; ++i) {
    solids.push_back(solid);
    solids.back().loft.frame_T_loft =
        Eigen::AngleAxisd(base::kTwoPi * i / count, about) * solid.loft.frame_T_loft;
  }
}

} // namespace

std::vector<ShapeSolid> readArmShape(const base::JsonNode& shape, int lastFrame) {
  shape.allowOnly({"colours", "solids"});
  const base::JsonNode colours = shape.at("colours");
  std::vector<ShapeSolid> solids;
  for (const base::JsonNode& node : shape.at("solids").items()) {
    node.allowOnly({"frame", "colour", "fromMm", "axis", "turnedMm", "sectionsMm", "across",
                    "roundMm", "count", "about"});
    ShapeSolid solid;
    solid.frame = node.at("frame").integer();
    if (solid.frame < 0 || solid.frame > lastFrame)
      node.at("frame").fail(base::message("must be in 0..{dof}"_text, lastFrame));
    const base::JsonNode name = node.at("colour");
    if (!colours.has(name.text()))
      name.fail(base::message("is not one of the colours: '{name}'"_text, name.text()));
    solid.colour = readColour(colours.at(name.text()));
    solid.loft = readLoft(node);
    addCopies(node, solid, solids);
  }
  if (solids.empty())
    shape.at("solids").fail("must hold at least one solid"_text);
  return solids;
}

} // namespace voluta::robot
