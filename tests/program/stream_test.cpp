// Streams of joints: rows, packets, and the programs beside them.
#include "program_fixture.h"

#include "base/error.h"
#include "program/dialect.h"
#include "program/melfa/mxt_packets.h"
#include "program/stream/urscript_stream_texts.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <sstream>

namespace voluta::program {
namespace {

class Streams : public test::Programs {
protected:
  plan::Program program(std::string_view id, std::size_t points = 60) {
    randomFor(findDialect(id), 3, points);
    return writeProgram(id, input());
  }
  plan::ReadProgram read(const plan::Program& p) const {
    return readProgram(p.format, p.files, process::Tooling(process_));
  }
};

std::string hex(std::string_view bytes) {
  std::string text;
  for (const char c : bytes) {
    char two[3];
    std::snprintf(two, sizeof two, "%02x", static_cast<unsigned char>(c));
    text += two;
  }
  return text;
}

// The table of docs/programs.md, packed apart from the project (Python's struct,
// '<HHHH8f8xHHHHHHI').
TEST(MxtPackets, HaveTheirBytes) {
  JointRow row;
  row.joints = {0.1, -0.2, 0.3, -0.4, 0.5, -0.6};
  row.on = true;
  row.flow = 0.4113;
  const std::string packet = mxtPacket(row, 7, false);
  ASSERT_EQ(packet.size(), 196u);
  EXPECT_EQ(hex(packet.substr(0, 64)),
            "0100020000000000cdcccc3dcdcc4cbe9a99993ecdccccbe0000003f9a9919bf"
            "000000000000000000000000000000000100000010"
            "00ffff11900000"
            "07000000");
  EXPECT_EQ(packet.find_first_not_of('\0', 64), std::string::npos);
  row.on = false;
  row.flow = 0.0;
  EXPECT_EQ(hex(mxtPacket(row, 258, true).substr(0, 2)), "ff00");
  EXPECT_EQ(hex(mxtPacket(row, 258, true).substr(56, 8)), "0000000002010000");
}

float jointIn(std::string_view packet, std::size_t k) {
  std::uint32_t bits = 0;
  for (std::size_t b = 0; b < 4; ++b)
    bits |= static_cast<std::uint32_t>(static_cast<unsigned char>(packet[8 + 4 * k + b]))
            << (8 * b);
  return std::bit_cast<float>(bits);
}

// At each cycle the joints are where the rows have them then, for any times of the rows: no cycle
// is lost where one row ends and the next begins.
TEST(MxtPackets, FollowTheRowsAtEachCycle) {
  for (const double cycle : {0.00711, 0.0035}) {
    std::vector<JointRow> rows(1);
    rows[0].kind = RowKind::Start;
    const auto at = [](double t) { return 0.3 * t - 0.5; }; // all rows at one speed
    rows[0].joints[2] = at(0.0);
    double time = 0.0;
    for (int i = 1; i < 200; ++i) {
      JointRow row;
      row.kind = RowKind::Move;
      row.seconds = 0.001 + 0.0137 * (i % 7);
      row.joints[2] = at(time += row.seconds);
      row.on = i % 2 == 0;
      row.flow = row.on ? 0.001 * i : 0.0;
      rows.push_back(row);
    }
    rows.push_back(rows.back());
    rows.back().kind = RowKind::End;
    rows.back().seconds = 0.0;
    const std::string packets = mxtPackets(rows, cycle);
    const std::size_t count = packets.size() / kMxtBytes;
    EXPECT_EQ(count, mxtPacketCount(rows, cycle));
    EXPECT_NEAR(static_cast<double>(count - 2), time / cycle, 1.0);
    for (std::size_t n = 0; n + 1 < count; ++n)
      ASSERT_NEAR(jointIn(std::string_view(packets).substr(n * kMxtBytes), 2),
                  at(static_cast<double>(n) * cycle), 1e-6)
          << n;
    EXPECT_TRUE(isMxtPackets(packets));
    EXPECT_FALSE(isMxtPackets(packets.substr(1)));
  }
}

TEST_F(Streams, AreReadWithTheFilesBesideThem) {
  for (const char* id : {"urscript-stream", "melfa-stream"}) {
    const plan::Program p = program(id);
    ASSERT_GE(p.files.size(), 3u);
    const plan::ReadProgram back = read(p);
    EXPECT_TRUE(back.complete && back.defects.empty()) << id;
    EXPECT_TRUE(back.beadsByJoints);
    // The rows' head names every file beside them.
    std::vector<std::string> named = continuationFiles(findDialect(id), p.files[0].text), beside;
    for (std::size_t f = 1; f < p.files.size(); ++f)
      beside.push_back(p.files[f].name);
    EXPECT_EQ(named, beside) << id;
  }
  EXPECT_TRUE(read(program("urscript-stream")).load.has_value());
}

// A long straight travel, on which few pieces would be far apart, is straight all the same.
TEST_F(Streams, GoStraightOverLongTravels) {
  useArmFor(findDialect("urscript-stream"));
  append(plan::MoveKind::Joint, {0.1, -1.9, 1.7, -1.2, -1.4, 0.3}, 0, 0);
  append(plan::MoveKind::Linear, {0.9, -1.5, 1.3, -0.8, -1.1, 1.2}, 3.0, 0.0);
  const plan::ReadProgram back = read(writeProgram("urscript-stream", input()));
  ASSERT_GT(back.motions.size(), 10u);
  const auto tipAt = [&](std::size_t m, double share) {
    const Eigen::Map<const Eigen::VectorXd> a(back.motions[m - 1].joints.data(), 6),
        b(back.motions[m].joints.data(), 6);
    return Eigen::Vector3d(
        cell_->work_T_tool(robot::JointVector(a + share * (b - a))).translation());
  };
  const Eigen::Vector3d from = tipAt(1, 0.0), to = tipAt(back.motions.size() - 1, 1.0);
  ASSERT_GT((to - from).norm(), 100.0);
  for (std::size_t m = 1; m < back.motions.size(); ++m)
    for (const double share : {0.2, 0.5, 0.8, 1.0}) {
      const Eigen::Vector3d p = tipAt(m, share) - from, direction = (to - from).normalized();
      EXPECT_LT((p - p.dot(direction) * direction).norm(), 0.021) << m;
    }
}

// The files beside the rows are the same for every job: a line that is missing, doubled or
// different is found at its place.
TEST_F(Streams, RefuseOtherTextsBeside) {
  for (const char* id : {"urscript-stream", "melfa-stream"}) {
    const plan::Program whole = program(id);
    for (std::size_t f = 1; f < whole.files.size(); ++f) {
      if (isMxtPackets(whole.files[f].text))
        continue;
      std::vector<std::string> lines;
      std::istringstream in(whole.files[f].text);
      for (std::string line; std::getline(in, line);)
        lines.push_back(line);
      std::size_t tried = 0, free = 0;
      for (std::size_t l = 0; l < lines.size(); ++l)
        for (int harm = 0; harm < 3; ++harm) {
          std::vector<std::string> changed = lines;
          if (harm == 0)
            changed.erase(changed.begin() + static_cast<std::ptrdiff_t>(l));
          else if (harm == 1)
            changed.insert(changed.begin() + static_cast<std::ptrdiff_t>(l), lines[l]);
          else
            changed[l].insert(changed[l].find_first_not_of(" 0123456789") == std::string::npos
                                  ? 0
                                  : changed[l].find_first_not_of(" 0123456789"),
                              "x");
          plan::Program p = whole;
          p.files[f].text.clear();
          for (const std::string& line : changed)
            p.files[f].text += line + "\n";
          const plan::ReadProgram back = read(p);
          const bool remark = lines[l].find("# ") < 3 || lines[l].find(" ' ") < 4 || l == 0;
          ++tried;
          if (back.defects.empty()) {
            ++free;
            // The same payload twice is one.
            EXPECT_TRUE(remark || (harm == 1 && lines[l].find("set_payload") != std::string::npos))
                << id << " " << whole.files[f].name << " " << harm << ": " << lines[l];
            continue;
          }
          if (!remark) {
            EXPECT_EQ(back.defects[0].file, f);
            EXPECT_NEAR(static_cast<double>(back.defects[0].line), static_cast<double>(l + 1), 3.0)
                << id << " " << lines[l];
          }
        }
      EXPECT_LT(free, tried / 2) << whole.files[f].name;
    }
  }
}

TEST_F(Streams, RefuseOtherPackets) {
  const plan::Program whole = program("melfa-stream");
  const auto packets = std::ranges::find_if(
      whole.files, [](const plan::ProgramFile& f) { return isMxtPackets(f.text); });
  ASSERT_NE(packets, whole.files.end());
  const auto f = static_cast<std::size_t>(packets - whole.files.begin());
  for (std::size_t at = 8; at < packets->text.size(); at += 997) {
    plan::Program p = whole;
    p.files[f].text[at] = static_cast<char>(p.files[f].text[at] ^ 0x10);
    const plan::ReadProgram back = read(p);
    ASSERT_FALSE(back.defects.empty()) << at;
    EXPECT_EQ(back.defects[0].file, f);
    EXPECT_EQ(back.defects[0].line, at / kMxtBytes + 1);
  }
  plan::Program p = whole;
  p.files[f].text.resize(p.files[f].text.size() - kMxtBytes);
  EXPECT_FALSE(read(p).defects.empty());
  p.files[f].text = packets->text + packets->text.substr(0, kMxtBytes);
  EXPECT_FALSE(read(p).defects.empty());
  // Of the other controller's cycle.
  ProgramInput in = input();
  in.options.own["mxtController"] = std::string("cr800");
  const plan::Program fast = writeProgram("melfa-stream", in);
  EXPECT_TRUE(read(fast).defects.empty());
  EXPECT_NEAR(static_cast<double>(fast.files[f].text.size()) /
                  static_cast<double>(packets->text.size()),
              7.11 / 3.5, 0.02);
  p.files[f].text = fast.files[f].text;
  EXPECT_FALSE(read(p).defects.empty());
}

// The start's address may be set, and nothing else.
TEST_F(Streams, TakeTheAddressThatAUserSets) {
  plan::Program p = program("melfa-stream");
  std::string& text =
      std::ranges::find_if(p.files, [](const auto& f) { return f.name.ends_with(".prg"); })->text;
  text.replace(text.find("192.168.0.2"), 11, "10.0.0.17");
  EXPECT_TRUE(read(p).defects.empty());
  text.replace(text.find("Mxt 1,1"), 7, "Mxt 1,0");
  EXPECT_FALSE(read(p).defects.empty());
}

TEST_F(Streams, AreOfTheirMakersArmsOnly) {
  append(plan::MoveKind::Joint, {0.1, -1.9, 1.7, -1.2, -1.4, 0.3}, 0, 0);
  try {
    writeProgram("melfa-stream", input());
    FAIL();
  } catch (const base::Error& e) {
    EXPECT_EQ(e.code(), base::ErrorCode::Usage);
    EXPECT_NE(std::string(e.what()).find("melfa-stream"), std::string::npos);
  }
  EXPECT_NO_THROW(writeProgram("urscript-stream", input()));
}

// The rows may be far more than fits the operator's time; the fixed texts are consistent.
TEST(StreamTexts, SenderAndReceiverSpeakOfTheSamePort) {
  for (const std::string_view text : {urscriptReceiver(), urscriptSender()}) {
    EXPECT_NE(text.find("50012"), std::string_view::npos);
    EXPECT_NE(text.find("SENDER_ADDRESS"), std::string_view::npos);
  }
}

} // namespace
} // namespace voluta::program
