// Data of RAPID as text, for what is written in that language.
#pragma once

#include "program/program_input.h"

#include <Eigen/Geometry>
#include <string>
#include <string_view>

namespace voluta::program {

inline constexpr std::string_view kRapidTool = "tNozzle";
// No external axis.
inline constexpr std::string_view kRapidNoAxes = "[9E9,9E9,9E9,9E9,9E9,9E9]";
// Of the first motion, which goes to where the arm may be far from.
inline constexpr double kRapidStartMmPerS = 50.0, kRapidStartDegPerS = 20.0;

void appendRapidPosition(std::string& out, const Eigen::Vector3d& mm, int decimals);
void appendRapidTurn(std::string& out, const Eigen::Quaterniond& q, int decimals);
std::string rapidFrame(const Eigen::Isometry3d& pose);

// Declarations, without line ends: the nozzle, held or stationary, with the load that is assumed;
// and the work object where it stands or is held by the flange.
std::string rapidToolLine(const ProgramInput& input);
std::string rapidObjectLine(const ProgramInput& input, std::string_view name);

} // namespace voluta::program
