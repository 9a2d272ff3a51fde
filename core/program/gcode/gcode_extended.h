// Extended G-code (Dai 2020, appendix): RepRap G-code with the nozzle's direction as a vector in
// the workpiece frame: G1 X6.338 Y8.390 Z46.300 nX-0.094 nY0.127 nZ0.987 E4.324
//
// X Y Z: the nozzle's tip in the work frame [mm]. nX nY nZ: from the bead into the nozzle (0 0 1 on
// a flat first layer). E: length of filament [mm] since the last G92 E0 (M82); the filament's
// diameter is in the header ("; filament diameter 1.75 mm", the default). F: speed of the tip in
// the work frame [mm/min], on every motion. G1: printing; G0: travels, straight. All words are
// absolute and modal. Prime: material extruded at home, before the first motion, then G92 E0.
#pragma once

#include "base/run_context.h"
#include "plan/program.h"
#include "program/program_input.h"

#include <string>
#include <string_view>
#include <vector>

namespace voluta::program {

// Tolerance of a direction's length from 1 (the appendix's own rounding leaves 2e-3).
inline constexpr double kDirectionTolerance = 2e-3;

// Whether to write a RAPID module that reads the program on the controller
// (program/gcode/gcode_rapid.h).
std::vector<base::ParameterSpec> extendedGcodeOptions();

// Throws as rapidRunner if that module is requested.
plan::Program writeExtendedGcode(const ProgramInput& input, const base::RunContext& ctx);

// Also accepts G4, G92 E, M82 M83 (E per motion), M104 M109 (with T: of that tool), T0 and
// gcodeWords(); line numbers and checksums, comments by ; and ( ), CR LF. Directions are
// normalised; a length off by more than kDirectionTolerance is a defect. Material that is retracted
// and returned counts once. `complete`: M104 S0, M84 and the line "; end" follow the last motion.
plan::ReadProgram readExtendedGcode(const std::vector<plan::ProgramFile>& files,
                                    const process::Tooling& tooling, const base::RunContext& ctx);
std::vector<std::string> filesOfExtendedGcode(std::string_view text); // Dialect
bool looksLikeExtendedGcode(std::string_view text);
bool mayBeMissingInExtendedGcode(const std::vector<std::string>& lines, std::size_t i); // Dialect

} // namespace voluta::program
