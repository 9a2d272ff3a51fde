#include "program/rapid/rapid_text.h"

#include "program/common/extruder_outputs.h"
#include "program/common/program_text.h"
#include "program/common/tcp_motions.h"

#include <array>
#include <cstddef>

namespace voluta::program {

namespace {
// 1e-9 in a quaternion moves a point of the part 300 mm away by less than a millionth of a mm.
constexpr int kFrameDecimals = 6, kFrameRotationDecimals = 9;

bool heldPlate(const ProgramInput& input) {
  return input.cell.nozzleMount() == robot::Mount::World;
}
} // namespace

void appendRapidPosition(std::string& out, const Eigen::Vector3d& mm, int decimals) {
  for (int k = 0; k < 3; ++k) {
    out += k ? ',' : '[';
    appendFixed(out, mm[k], decimals, true);
  }
  out += ']';
}

void appendRapidRotation(std::string& out, const Eigen::Quaterniond& q, int decimals) {
  const double sign = q.w() < 0.0 ? -1.0 : 1.0;
  const std::array<double, 4> parts = {q.w(), q.x(), q.y(), q.z()};
  for (std::size_t k = 0; k < 4; ++k) {
    out += k ? ',' : '[';
    appendFixed(out, sign * parts[k], decimals, true);
  }
  out += ']';
}

std::string rapidFrame(const Eigen::Isometry3d& pose) {
  std::string out = "[";
  appendRapidPosition(out, pose.translation(), kFrameDecimals);
  out += ',';
  appendRapidRotation(out, Eigen::Quaterniond(pose.linear()), kFrameRotationDecimals);
  return out + "]";
}

std::string rapidToolSignal(int output) {
  if (output >= kMarkOutput)
    return joined({"doMark", std::to_string(output - kMarkOutput + 1)});
  return output == kChangerOutput ? std::string("doToolLocked")
                                  : joined({"doTool", std::to_string(output + 1)});
}

std::string rapidMarkInput(int input) {
  return joined({"diMark", std::to_string(input - kMarkOutput + 1)});
}

std::string rapidToolLine(const ProgramInput& input) {
  const bool held = heldPlate(input);
  std::string out =
      joined({"  PERS tooldata ", kRapidTool, ":=[", held ? "FALSE," : "TRUE,",
              rapidFrame(held ? input.cell.base_T_fixed() : input.cell.flange_T_moved()), ",["});
  appendFixed(out, assumedLoadKg(input), 3, true);
  out += ',';
  appendRapidPosition(out, input.cell.flange_T_moved().translation(), 1);
  return out + ",[1,0,0,0],0,0,0]];";
}

std::string rapidObjectLine(const ProgramInput& input, std::string_view name) {
  const bool held = heldPlate(input);
  return joined({"  PERS wobjdata ", name, ":=[", held ? "TRUE," : "FALSE,", "TRUE,\"\",",
                 rapidFrame(held ? input.cell.flange_T_moved() : input.cell.base_T_fixed()),
                 ",[[0,0,0],[1,0,0,0]]];"});
}

} // namespace voluta::program
