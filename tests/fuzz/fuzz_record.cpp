// Records of runs.
#include "fuzz_target.h"

#include "process/process.h"
#include "record/formats.h"

#include <filesystem>

using namespace voluta;

namespace {
const robot::Cell& cell() {
  static const robot::Cell kCell =
      robot::loadCell("ur5-fixed", process::loadProcess("fdm-1.0"), {{-9, -9}, {9, -9}, {0, 9}});
  return kCell;
}
} // namespace

std::vector<std::string> fuzz::seeds() {
  ::setenv("VOLUTA_RESOURCES", VOLUTA_SOURCE_DIR "/resources", 1);
  return {"timestamp actual_q_0 actual_q_1 actual_q_2 actual_q_3 actual_q_4 actual_q_5\n"
          "0.0 0 -1.5 1.5 0 0.1 0\n0.008 0 -1.5 1.5 0 0.1 0.1\n",
          "timestamp,actual_TCP_pose_0,actual_TCP_pose_1,actual_TCP_pose_2,actual_TCP_pose_3,"
          "actual_TCP_pose_4,actual_TCP_pose_5\n0,0.1,0.2,0.3,0,3.1,0\n1,0.1,0.2,0.3,0,3.1,0\n",
          "time[ms];X;Y;Z;A;B;C\n0;1;2;3;4;5;6\n7.11;1;2;3;4;5;6\n",
          "# joints\ntime_s,j1_deg,j2_deg,j3_deg,j4_deg,j5_deg,j6_deg,extruded_mm3,move\n"
          "0,1,2,3,4,5,6,0,print\n1,1,2,3,4,5,6,2,print\n# end\n"};
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = fuzz::textOf(data, size);
  fuzz::takenOrRefused([&] {
    const record::RecordedRun run = record::readRecord(text, "record.csv", {cell(), 40.0});
    fuzz::expect(run.timeS.size() > 1, "a record has samples");
    fuzz::expect(run.tip.size() == run.timeS.size(), "every sample has its tip");
    for (std::size_t i = 1; i < run.timeS.size(); ++i)
      fuzz::expect(run.timeS[i - 1] < run.timeS[i], "times increase");
  });
  return 0;
}
