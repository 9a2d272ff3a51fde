#include "program/krl/krl_text.h"

#include "program/common/program_text.h"

namespace voluta::program {

void appendKrlTarget(std::string& out, const Eigen::Vector3d& mm, const Eigen::Vector3d& degrees,
                     int mmDecimals, int degDecimals) {
  static constexpr std::string_view kNames[] = {"{X ", ",Y ", ",Z ", ",A ", ",B ", ",C "};
  for (int k = 0; k < 6; ++k) {
    out += kNames[k];
    appendFixed(out, k < 3 ? mm[k] : degrees[k - 3], k < 3 ? mmDecimals : degDecimals, true);
  }
}

std::string krlFrameText(const Eigen::Vector3d& mm, const Eigen::Vector3d& degrees) {
  std::string out;
  appendKrlTarget(out, mm, degrees, kKrlFrameDecimals, kKrlFrameDecimals);
  return out + "}";
}

std::string krlLoadText(double kg, const Eigen::Vector3d& centreMm) {
  return joined({"{M ", fixedText(kg, 3), ",CM {X ", fixedText(centreMm.x(), 1), ",Y ",
                 fixedText(centreMm.y(), 1), ",Z ", fixedText(centreMm.z(), 1),
                 ",A 0,B 0,C 0},J {X 0,Y 0,Z 0}}"});
}

} // namespace voluta::program
