#include "program/melfa/mxt_packets.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace voluta::program {

namespace {

constexpr std::uint16_t kMove = 1, kEnd = 255, kJoints = 2, kOutputs = 1;
constexpr std::size_t kCommand = 0, kSendType = 2, kJointsAt = 8, kSendIoType = 48, kBitTop = 52,
                      kBitMask = 54, kIoData = 56, kCount = 60;

template <typename Value> void put(std::string& packet, std::size_t at, Value value) {
  for (std::size_t k = 0; k < sizeof value; ++k)
    packet[at + k] = static_cast<char>((value >> (8 * k)) & 0xffU);
}

// Calls visit(row, ended) for each packet.
template <typename Visit> void play(std::span<const JointRow> rows, double cycleS, Visit&& visit) {
  JointRow last;
  double into = 0.0;
  for (const JointRow& row : rows) {
    if (row.kind == RowKind::Start || row.kind == RowKind::End) {
      visit(row, row.kind == RowKind::End);
      into = 0.0;
    } else {
      while (into + cycleS <= row.seconds) {
        into += cycleS;
        JointRow at = row;
        for (std::size_t k = 0; k < kRowJoints; ++k)
          at.joints[k] = last.joints[k] + into / row.seconds * (row.joints[k] - last.joints[k]);
        visit(at, false);
      }
      into -= row.seconds;
    }
    last = row;
  }
}

} // namespace

std::string mxtPacket(const JointRow& at, std::uint32_t count, bool ends) {
  std::string packet(kMxtBytes, '\0');
  put(packet, kCommand, ends ? kEnd : kMove);
  put(packet, kSendType, kJoints);
  for (std::size_t k = 0; k < kRowJoints; ++k)
    put(packet, kJointsAt + 4 * k, std::bit_cast<std::uint32_t>(static_cast<float>(at.joints[k])));
  put(packet, kSendIoType, kOutputs);
  put(packet, kBitTop, static_cast<std::uint16_t>(kMxtFirstOutput));
  put(packet, kBitMask, std::uint16_t{0xffff});
  const auto flow = static_cast<unsigned>(std::lround(at.flow * kMxtFullFlow));
  put(packet, kIoData, static_cast<std::uint16_t>(flow | (at.on ? kMxtOn : 0U)));
  put(packet, kCount, count);
  return packet;
}

double mxtShare(double share) {
  return std::clamp(std::max(1.0, std::round(share * kMxtFullFlow)) / kMxtFullFlow, 0.0, 1.0);
}

std::string mxtPackets(std::span<const JointRow> rows, double cycleS) {
  std::string packets;
  packets.reserve(kMxtBytes * mxtPacketCount(rows, cycleS));
  std::uint32_t count = 0;
  play(rows, cycleS,
       [&](const JointRow& at, bool ends) { packets += mxtPacket(at, count++, ends); });
  return packets;
}

std::size_t mxtPacketCount(std::span<const JointRow> rows, double cycleS) {
  double seconds = 0.0;
  std::size_t others = 0;
  for (const JointRow& row : rows) {
    seconds += row.seconds;
    others += row.kind == RowKind::Start || row.kind == RowKind::End ? 1 : 0;
  }
  return others + static_cast<std::size_t>(seconds / cycleS);
}

bool isMxtPackets(std::string_view bytes) {
  constexpr std::string_view kBegin("\x01\0\x02\0\0\0\0\0", 8);
  return bytes.size() % kMxtBytes == 0 && bytes.starts_with(kBegin);
}

} // namespace voluta::program
