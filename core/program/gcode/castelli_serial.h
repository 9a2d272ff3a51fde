// The extruder of Castelli 2020, 2.1.4, table 2.2: a board with a stepper motor that accepts short
// texts over TCP, each ended by an 'n': G<half period of a step, us>, M<nozzle, degrees C>, T0
// (queries the temperature), F<fan, 0..255>, R0 (restarts its software). A negative G runs the
// motor backwards. We assume that G0 stops it, as the table has no command for that.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace voluta::program {

inline constexpr double kCastelliStepsPerMm = 1674.18, kCastelliFilamentMm = 3.0;
inline constexpr std::size_t kCastelliMaxBytes = 16;
inline constexpr double kCastelliFullFan = 255.0;
// Default address of the board in programs.
inline constexpr std::string_view kCastelliAddress = "192.168.0.30";
inline constexpr int kCastelliPort = 5000;

// Returns the half period for a flow, a whole number of us, at least 1; negative for retraction; 0:
// no flow.
long long castelliHalfPeriodUs(double mm3PerS);
double castelliFlowMm3PerS(long long halfPeriodUs);
// Returns the flow that is really written for a requested one.
double castelliWritten(double mm3PerS);

// E.g. "G1394n" for a bead of 0.1514 mm² at 10 mm/s.
std::string castelliFlowText(double mm3PerS);

// E.g. "F128n" for half the fan's full speed; a nozzle temperature: "M210n", 0: off.
std::string castelliFanText(double share);
std::string castelliHeatText(int celsius);

struct CastelliCommand {
  char word = 'G'; // one of G, M, T, F, R
  long long value = 0;
};
// Returns nullopt if the text is not in the table or longer than the board accepts.
std::optional<CastelliCommand> readCastelli(std::string_view text);

} // namespace voluta::program
