// URDF as text, for tests.
#pragma once

#include <string>

namespace voluta::test {

// A UR5 as its maker describes it, with simple solids; `inside` is inserted before the end, `last`
// are the limits of its last joint.
inline std::string ur5Urdf(
    const std::string& inside = "",
    const std::string& last = R"(<limit lower="-6.2831853" upper="6.2831853" velocity="3.14"/>)") {
  const auto joint = [](const std::string& name, const std::string& parent,
                        const std::string& child, const std::string& origin,
                        const std::string& limit) {
    return "<joint name=\"" + name + "\" type=\"revolute\"><parent link=\"" + parent +
           "\"/><child link=\"" + child + "\"/><origin " + origin + "/><axis xyz=\"0 0 1\"/>" +
           limit + "</joint>\n";
  };
  const std::string
      full = R"(<limit effort="1" lower="-6.2831853" upper="6.2831853" velocity="3.1415927"/>)",
      elbow = R"(<limit effort="1" lower="-3.1415927" upper="3.1415927" velocity="3.1415927"/>)";
  const std::string quarter = "1.5707963267948966";
  return R"(<?xml version="1.0"?>
<robot name="My UR5, left">
  <link name="world"/>
  <link name="base_link"><collision><origin xyz="0 0 0.04"/><geometry>
    <cylinder radius="0.07" length="0.08"/></geometry></collision></link>
  <joint name="stand" type="fixed"><parent link="world"/><child link="base_link"/></joint>
  <link name="base"/>
  <joint name="controller" type="fixed"><parent link="base_link"/><child link="base"/>
    <origin rpy="0 0 3.141592653589793"/></joint>
  <link name="inertia"/>
  <joint name="inertial" type="fixed"><parent link="base_link"/><child link="inertia"/>
    <origin rpy="0 0 3.141592653589793"/></joint>
  <link name="shoulder"><collision><geometry><sphere radius="0.075"/></geometry></collision></link>
  <link name="upper_arm"><collision><origin xyz="-0.2125 0 0.132" rpy="0 1.5707963267948966 0"/>
    <geometry><cylinder radius="0.06" length="0.5"/></geometry></collision></link>
  <link name="forearm"><collision><origin xyz="-0.196 0 0.027"/><geometry>
    <box size="0.36 0.07 0.07"/></geometry></collision></link>
  <link name="wrist_1"><visual><geometry><sphere radius="0.055"/></geometry></visual></link>
  <link name="wrist_2"><collision><geometry><sphere radius="0.04"/></geometry></collision></link>
  <link name="wrist_3"><collision><origin xyz="0 0 -0.021"/><geometry>
    <sphere radius="0.035"/></geometry></collision></link>
  <link name="tool0"/>
  <joint name="flange" type="fixed"><parent link="wrist_3"/><child link="tool0"/></joint>
)" + joint("pan", "inertia", "shoulder", R"(xyz="0 0 0.089159")", full) +
         joint("lift", "shoulder", "upper_arm", "rpy=\"" + quarter + " 0 0\"", full) +
         joint("elbow", "upper_arm", "forearm", R"(xyz="-0.425 0 0")", elbow) +
         joint("wrist_1_joint", "forearm", "wrist_1", R"(xyz="-0.39225 0 0.10915")", full) +
         joint("wrist_2_joint", "wrist_1", "wrist_2",
               "xyz=\"0 -0.09465 0\" rpy=\"" + quarter + " 0 0\"", full) +
         joint("wrist_3_joint", "wrist_2", "wrist_3",
               "xyz=\"0 0.0823 0\" rpy=\"" + quarter + " 3.141592653589793 3.141592653589793\"",
               last) +
         inside + "</robot>\n";
}

} // namespace voluta::test
