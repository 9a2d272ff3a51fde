// Arms as URDF text, for tests: public dimensions, cylinders of our own for links.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <string>
#include <vector>

namespace voluta::test {

struct UrdfTube { // metres, in the link's frame
  std::array<double, 3> p0, p1;
  double radius;
};
struct UrdfAxis { // metres, rad
  std::string xyz, axis;
  double lower, upper, velocity;
};
struct UrdfArm {
  std::string name;
  std::vector<UrdfAxis> axes;               // six, about x, y or z of frames that are not turned
  std::vector<std::vector<UrdfTube>> links; // seven
};

inline std::string urdfTube(const UrdfTube& tube) {
  const Eigen::Vector3d p0(tube.p0.data()), p1(tube.p1.data()), d = p1 - p0, m = 0.5 * (p0 + p1);
  return fmt::format("<collision><origin xyz=\"{} {} {}\" rpy=\"0 {} {}\"/><geometry><cylinder "
                     "radius=\"{}\" length=\"{}\"/></geometry></collision>",
                     m.x(), m.y(), m.z(), std::atan2(std::hypot(d.x(), d.y()), d.z()),
                     std::atan2(d.y(), d.x()), tube.radius, d.norm());
}

// `solid` gives the solids of a link; of link 0 (base_link) to 6.
template <typename Solid> std::string urdfOf(const UrdfArm& arm, Solid&& solid) {
  std::string text = "<?xml version=\"1.0\"?>\n<robot name=\"" + arm.name + "\">\n";
  const auto link = [](std::size_t i) { return i == 0 ? "base_link" : fmt::format("link_{}", i); };
  for (std::size_t i = 0; i < 7; ++i)
    text += "<link name=\"" + link(i) + "\">" + solid(i) + "</link>\n";
  for (std::size_t i = 0; i < 6; ++i) {
    const UrdfAxis& a = arm.axes[i];
    text += fmt::format("<joint name=\"joint_{}\" type=\"revolute\"><parent link=\"{}\"/><child "
                        "link=\"{}\"/><origin xyz=\"{}\"/><axis xyz=\"{}\"/><limit effort=\"1\" "
                        "lower=\"{}\" upper=\"{}\" velocity=\"{}\"/></joint>\n",
                        i + 1, link(i), link(i + 1), a.xyz, a.axis, a.lower, a.upper, a.velocity);
  }
  return text + "<link name=\"tool0\"/><joint name=\"flange\" type=\"fixed\"><parent "
                "link=\"link_6\"/><child link=\"tool0\"/><origin rpy=\"0 1.5707963267948966 0\"/>"
                "</joint></robot>\n";
}
inline std::string urdfOf(const UrdfArm& arm) {
  return urdfOf(arm, [&](std::size_t i) {
    std::string solids;
    for (const UrdfTube& tube : arm.links[i])
      solids += urdfTube(tube);
    return solids;
  });
}

inline UrdfArm irb1200() {
  return {"IRB 1200 by its public figures",
          {{"0 0 0.3991", "0 0 1", -2.967, 2.967, 5.027},
           {"0 0 0", "0 1 0", -1.745, 2.269, 4.189},
           {"0 0 0.35", "0 1 0", -3.491, 1.222, 5.236},
           {"0 0 0.042", "1 0 0", -4.712, 4.712, 6.981},
           {"0.351 0 0", "0 1 0", -2.269, 2.269, 7.069},
           {"0.082 0 0", "1 0 0", -6.283, 6.283, 10.472}},
          {{{{0, 0, 0}, {0, 0, 0.23}, 0.13}},
           {{{0, 0, -0.16}, {0, 0, 0.02}, 0.11}, {{0, -0.1, 0}, {0, 0.1, 0}, 0.1}},
           {{{0, 0, 0}, {0, 0, 0.35}, 0.09}},
           {{{-0.05, 0, 0.03}, {0.15, 0, 0.042}, 0.085}},
           {{{0.2, 0, 0}, {0.34, 0, 0}, 0.06}},
           {{{0, 0, 0}, {0.05, 0, 0}, 0.04}},
           {{{-0.02, 0, 0}, {0, 0, 0}, 0.03}}}};
}

// After the KR 6 R900: axes 1, 4 and 6 the other way round, an offset at the shoulder.
inline UrdfArm kukaLike() {
  return {"like a KR 6",
          {{"0 0 0.4", "0 0 -1", -2.967, 2.967, 6.28},
           {"0.025 0 0", "0 1 0", -3.316, 0.785, 5.236},
           {"0.455 0 0", "0 1 0", -2.094, 2.723, 6.28},
           {"0 0 0.035", "-1 0 0", -3.229, 3.229, 6.65},
           {"0.42 0 0", "0 1 0", -2.094, 2.094, 6.77},
           {"0.08 0 0", "-1 0 0", -6.109, 6.109, 10.73}},
          {{{{0, 0, 0}, {0, 0, 0.2}, 0.13}},
           {{{0, 0, -0.17}, {0, 0, 0}, 0.12}, {{0.025, -0.12, 0}, {0.025, 0.1, 0}, 0.1}},
           {{{0, 0, 0}, {0.455, 0, 0}, 0.085}},
           {{{-0.05, 0, 0.03}, {0.12, 0, 0.035}, 0.085}},
           {{{0.15, 0, 0}, {0.36, 0, 0}, 0.06}},
           {{{0, 0, 0}, {0.04, 0, 0}, 0.045}},
           {{{-0.015, 0, 0}, {0, 0, 0}, 0.03}}}};
}

// Axes 4 and 5 pass each other, and so do 5 and 6: no closed form.
inline UrdfArm oddArm() {
  return {"odd",
          {{"0 0 0.35", "0 0 1", -3, 3, 3.5},
           {"0.03 0 0", "0 1 0", -2, 2.3, 3.5},
           {"0 0 0.42", "0 1 0", -3.6, 1.3, 3.5},
           {"0 0 0.04", "1 0 0", -3.1416, 3.1416, 5},
           {"0.38 0 0.045", "0 1 0", -2.2, 2.2, 5},
           {"0.09 0.06 0", "1 0 0", -6.283, 6.283, 7}},
          {{{{0, 0, 0}, {0, 0, 0.2}, 0.1}},
           {{{0, 0, -0.14}, {0, 0, 0}, 0.1}, {{0.03, -0.09, 0}, {0.03, 0.09, 0}, 0.08}},
           {{{0, 0, 0}, {0, 0, 0.42}, 0.07}},
           {{{-0.05, 0, 0.03}, {0.12, 0, 0.035}, 0.07}},
           {{{0.14, 0, 0}, {0.36, 0, 0.02}, 0.055}},
           {{{0, 0, 0}, {0.04, 0.03, 0}, 0.04}},
           {{{-0.015, 0, 0}, {0, 0, 0}, 0.03}}}};
}

// As `oddArm`, but axes 4 and 5 meet.
inline UrdfArm bentArm() {
  UrdfArm arm = oddArm();
  arm.name = "bent";
  arm.axes[4].xyz = "0.38 0 0";
  arm.axes[5].xyz = "0.09 0 0.07";
  return arm;
}

} // namespace voluta::test
