// Packets of MELFA's real-time control (Mxt): what a computer sends a CR750 or CR800 each cycle
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
// The outputs that a packet sets: 16 from here on, as a number.
inline constexpr int kMxtFirstOutput = 16;
// Of that number: the flow's share, and what is added while the extruder is on.
inline constexpr double kMxtFullFlow = 10000.0;
inline constexpr unsigned kMxtOn = 0x8000;

// One that moves to these joints (Command 1), or, `ends`, that ends the control (255). `count`: of
// the packets before it.
std::string mxtPacket(const JointRow& at, std::uint32_t count, bool ends);

// What a row's flow is as the packets say it.
double mxtShare(double share);

// The rows played at a cycle, s: the start's joints, then where the joints are each cycle later,
// what a row's last cycle leaves over being part of the next; and the end.
std::string mxtPackets(std::span<const JointRow> rows, double cycleS);
// How many these are.
std::size_t mxtPacketCount(std::span<const JointRow> rows, double cycleS);

// Does a file begin as one of packets?
bool isMxtPackets(std::string_view bytes);

} // namespace voluta::program
