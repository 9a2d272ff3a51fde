// RAPID data as text, shared by the writers of that language.
#pragma once

#include "program/program_input.h"

#include <Eigen/Geometry>
#include <string>
#include <string_view>

namespace voluta::program {

inline constexpr std::string_view kRapidTool = "tNozzle";
// Of the tape's cutter.
inline constexpr std::string_view kRapidCutSignal = "doCut";
// No external axes.
inline constexpr std::string_view kRapidNoAxes = "[9E9,9E9,9E9,9E9,9E9,9E9]";
// Of the first motion, which may start far from its target.
inline constexpr double kRapidStartMmPerS = 50.0, kRapidStartDegPerS = 20.0;

void appendRapidPosition(std::string& out, const Eigen::Vector3d& mm, int decimals);
void appendRapidRotation(std::string& out, const Eigen::Quaterniond& q, int decimals);
std::string rapidFrame(const Eigen::Isometry3d& pose);

// Returns the name of the signal of an input of marks (ProgramEmitter::awaitInput).
std::string rapidMarkInput(int input);
// Returns the name of the signal of an output (ProgramEmitter::setOutput).
std::string rapidToolSignal(int output);

// Return the declarations, without line ends: the nozzle, held or stationary, with the assumed
// load; and the work object, stationary or held by the flange.
std::string rapidToolLine(const ProgramInput& input);
std::string rapidObjectLine(const ProgramInput& input, std::string_view name);

} // namespace voluta::program
