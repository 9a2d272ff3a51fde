// Words of KRL that more than one dialect writes.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <string_view>

namespace voluta::program {

// A controller keeps a number to 24 bits: 180 degrees to 0.00002.
inline constexpr int kKrlMmDecimals = 4, kKrlDegDecimals = 5, kKrlFrameDecimals = 6;

// What every program begins with.
inline constexpr std::array<std::string_view, 5> kKrlInit = {
    ";FOLD INI", "GLOBAL INTERRUPT DECL 3 WHEN $STOPMESS==TRUE DO IR_STOPM ( )", "INTERRUPT ON 3",
    "BAS (#INITMOV,0 )", ";ENDFOLD (INI)"};

// "{X 1,Y 2,Z 3,A 4,B 5,C 6", without its end, so that external axes may follow. mm, degrees.
void appendKrlTarget(std::string& out, const Eigen::Vector3d& mm, const Eigen::Vector3d& degrees,
                     int mmDecimals = kKrlMmDecimals, int degDecimals = kKrlDegDecimals);
// A frame, with it.
std::string krlFrameText(const Eigen::Vector3d& mm, const Eigen::Vector3d& degrees);
// $LOAD's value.
std::string krlLoadText(double kg, const Eigen::Vector3d& centreMm);

} // namespace voluta::program
