// Robots described in URDF.
#include "fuzz_target.h"

#include "robot/urdf/urdf_reader.h"

#include <sstream>

using namespace voluta;

namespace {

// Six axes in turn about z and y, each with limits, and a solid of every kind.
std::string arm() {
  std::ostringstream xml;
  xml << "<?xml version=\"1.0\"?>\n<robot name=\"arm\">\n<link name=\"base_link\"/>\n";
  constexpr const char* kSolids[] = {
      "<box size=\"0.1 0.1 0.2\"/>", "<cylinder radius=\"0.05\" length=\"0.2\"/>",
      "<sphere radius=\"0.06\"/>", "<mesh filename=\"package://arm/link.stl\" scale=\"1 1 1\"/>"};
  for (int k = 1; k <= 6; ++k)
    xml << "<link name=\"link_" << k
        << "\"><collision><origin xyz=\"0 0 0.1\" rpy=\"0 0 0\"/><geometry>" << kSolids[k % 4]
        << "</geometry></collision></link>\n<joint name=\"joint_" << k
        << "\" type=\"revolute\"><parent link=\""
        << (k == 1 ? std::string("base_link") : "link_" + std::to_string(k - 1))
        << "\"/><child link=\"link_" << k
        << "\"/><origin xyz=\"0 0 0.2\" rpy=\"0 0 0\"/><axis xyz=\"" << (k % 2 ? "0 0 1" : "0 1 0")
        << "\"/><limit lower=\"-3\" upper=\"3\" velocity=\"2\" effort=\"50\"/></joint>\n";
  xml << "<link name=\"tool0\"/>\n<joint name=\"flange\" type=\"fixed\"><parent link=\"link_6\"/>"
         "<child link=\"tool0\"/><origin xyz=\"0 0 0.05\" rpy=\"0 0.1 0\"/></joint>\n</robot>\n";
  return xml.str();
}

} // namespace

std::vector<std::string> fuzz::seeds() {
  ::setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1);
  return {arm()};
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::write("arm.urdf", fuzz::textOf(data, size));
  fuzz::takenOrRefused([] {
    const robot::UrdfRobot read = robot::readUrdf("arm.urdf", {});
    fuzz::expect(read.model.dof() == 6 && read.model.limits.size() == 6,
                 "an arm of six axes has their limits");
    const robot::JointVector rest = robot::JointVector::Zero(6);
    fuzz::expect(read.model.kinematics->flange(rest).matrix().allFinite(), "its flange is a place");
  });
  return 0;
}
