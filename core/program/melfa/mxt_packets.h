// Packets of MELFA's real-time control (Mxt), which a computer sends to a CR750 or CR800 each cycle
// over UDP (BFP-A3379, Ethernet function; docs/programs.md has the table). 196 bytes,
// little-endian, with the joints in radians as floats.
#pragma once

#include "program/stream/joint_rows.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace voluta::program {

inline constexpr std::size_t kMxtBytes = 196;
// A packet sets 16 outputs from this one on, as a number.
inline constexpr int kMxtFirstOutput = 16;
// In that number: the maximum flow, and the value added while the extruder is on.
inline constexpr double kMxtFullFlow = 10000.0;
inline constexpr unsigned kMxtOn = 0x8000;

// Returns a packet that moves to these joints (Command 1), or, if `ends`, ends the control (255).
// `count`: number of packets before it.
std::string mxtPacket(const JointRow& at, std::uint32_t count, bool ends);

// Returns a row's flow share as rounded in the packets.
double mxtShare(double share);

// Returns the packets of the rows at a cycle time [s]: the start's joints, then the joints after
// each cycle, and the end. The remainder of a row's last cycle is part of the next cycle.
std::string mxtPackets(std::span<const JointRow> rows, double cycleS);
// Returns their number.
std::size_t mxtPacketCount(std::span<const JointRow> rows, double cycleS);

// Returns whether a file begins with a packet.
bool isMxtPackets(std::string_view bytes);

} // namespace voluta::program
