#include "robot/cell/shape_reader.h"

#include "base/json_node.h"
#include "robot/cell/json_pose.h"

#include "base/nearest_name.h"

#include <algorithm>
#include <fmt/format.h>

namespace voluta::robot {

namespace {

Shape readShape(const base::JsonNode& node) {
  node.allowOnly({"capsule", "box", "frustum"});
  if (node.has("capsule")) {
    const base::JsonNode c = node.at("capsule");
    c.allowOnly({"p0Mm", "p1Mm", "radiusMm"});
    return Capsule{readVector3(c.at("p0Mm")), readVector3(c.at("p1Mm")),
                   c.at("radiusMm").positive()};
  }
  if (node.has("box")) {
    const base::JsonNode b = node.at("box");
    b.allowOnly({"pose", "sizeMm"});
    const Eigen::Vector3d size = readVector3(b.at("sizeMm"));
    if (!(size.minCoeff() > 0.0))
      b.at("sizeMm").fail("must be greater than 0"_text);
    return Box{readPose(b.at("pose")), 0.5 * size};
  }
  if (node.has("frustum")) {
    const base::JsonNode f = node.at("frustum");
    f.allowOnly({"p0Mm", "p1Mm", "r0Mm", "r1Mm"});
    Frustum frustum{readVector3(f.at("p0Mm")), readVector3(f.at("p1Mm")), f.at("r0Mm").number(),
                    f.at("r1Mm").number()};
    if (frustum.r0 < 0.0 || frustum.r1 < 0.0 || frustum.r0 + frustum.r1 <= 0.0)
      f.fail("needs radii that are not negative, one of them greater than 0"_text);
    if (frustum.p0 == frustum.p1)
      f.fail("must not have zero length"_text);
    return frustum;
  }
  node.fail("must be a capsule, a box or a frustum"_text);
}

} // namespace

std::vector<Shape> readShapes(const base::JsonNode& list) {
  std::vector<Shape> shapes;
  for (const base::JsonNode& item : list.items())
    shapes.push_back(readShape(item));
  if (shapes.empty())
    list.fail("must have at least one shape"_text);
  return shapes;
}

std::vector<std::pair<int, int>> readBodyPairs(const base::JsonNode& list,
                                               const std::vector<Body>& bodies) {
  const auto indexOf = [&](const base::JsonNode& node) {
    const std::string name = node.text();
    std::vector<std::string> names;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (bodies[i].name == name)
        return static_cast<int>(i);
      names.push_back(bodies[i].name);
    }
    node.fail(base::message("names an unknown body: '{name}'; did you mean '{nearest}'?"_text, name,
                            base::nearestName(name, names)));
  };
  std::vector<std::pair<int, int>> pairs;
  for (const base::JsonNode& node : list.items()) {
    node.allowOnly({"pair", "why"});
    node.at("why").text();
    const std::vector<base::JsonNode> names = node.at("pair").items();
    if (names.size() != 2)
      node.at("pair").fail("must have two names"_text);
    const int a = indexOf(names[0]), b = indexOf(names[1]);
    if (a == b)
      node.at("pair").fail("pairs a body with itself"_text);
    pairs.emplace_back(std::min(a, b), std::max(a, b));
  }
  return pairs;
}

} // namespace voluta::robot
