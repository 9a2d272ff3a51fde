// The extruder of Castelli 2020, 2.1.4, table 2.2: a board with a stepper motor that takes short
// texts over TCP, each ended by an 'n': G<half period of a step, us>, M<nozzle, degrees C>, T0
// (asks for the temperature), F<fan, 0..255>, R0 (starts its software anew). A G below zero runs
// the motor back. That G0 stops it is assumed: the table has no word for that.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace voluta::program {

inline constexpr double kCastelliStepsPerMm = 1674.18, kCastelliFilamentMm = 3.0;
inline constexpr std::size_t kCastelliMostBytes = 16;
// Where a program looks for it until somebody sets its own.
inline constexpr std::string_view kCastelliAddress = "192.168.0.30";
inline constexpr int kCastelliPort = 5000;

// The half period that gives a flow, a whole number of us and 1 at least; below zero for one that
// draws back; 0: none.
long long castelliHalfPeriodUs(double mm3PerS);
double castelliFlowMm3PerS(long long halfPeriodUs);
// The flow that is said for one that is wanted.
double castelliWritten(double mm3PerS);

// A bead of 0.1514 mm2 at 10 mm/s is "G1394n".
std::string castelliFlowText(double mm3PerS);

struct CastelliCommand {
  char word = 'G'; // of G, M, T, F, R
  long long value = 0;
};
// nullopt: no text of the table, or one that is longer than the board takes.
std::optional<CastelliCommand> readCastelli(std::string_view text);

} // namespace voluta::program
