// KRL fragments that several dialects write.
#pragma once

#include <Eigen/Core>
#include <array>
#include <string>
#include <string_view>

namespace voluta::program {

// A controller stores numbers with 24 bits: 180 degrees to 0.00002.
inline constexpr int kKrlMmDecimals = 4, kKrlDegDecimals = 5, kKrlFrameDecimals = 6;

// Of the tape's cutter, which cuts when it turns on.
inline constexpr std::string_view kKrlCutOutput = "$OUT[16]";

// The first lines of every program.
inline constexpr std::array<std::string_view, 5> kKrlInit = {
    ";FOLD INI", "GLOBAL INTERRUPT DECL 3 WHEN $STOPMESS==TRUE DO IR_STOPM ( )", "INTERRUPT ON 3",
    "BAS (#INITMOV,0 )", ";ENDFOLD (INI)"};

// Appends "{X 1,Y 2,Z 3,A 4,B 5,C 6" without the closing brace, so that external axes may follow.
// mm, degrees.
void appendKrlTarget(std::string& out, const Eigen::Vector3d& mm, const Eigen::Vector3d& degrees,
                     int mmDecimals = kKrlMmDecimals, int degDecimals = kKrlDegDecimals);
// Returns a frame with the closing brace.
std::string krlFrameText(const Eigen::Vector3d& mm, const Eigen::Vector3d& degrees);
// Returns the value of $LOAD.
std::string krlLoadText(double kg, const Eigen::Vector3d& centreMm);

} // namespace voluta::program
