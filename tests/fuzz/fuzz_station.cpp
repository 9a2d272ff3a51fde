// Projects of stations. The sum of the header is put right first, so that changes reach its places,
// rules and lengths; the jobs in it are covered by fuzz_project.
#include "fuzz_target.h"

#include "pipeline/sample_job.h"
#include "pipeline/stage_options.h"
#include "project/file_frame.h"
#include "project/job_magic.h"
#include "project/station.h"

using namespace voluta;

namespace {

// How the header ends: no other line is a brace alone.
constexpr std::string_view kEnd = "\n}";

std::string stationWithSum(const std::string& input) {
  const std::size_t end = input.find(kEnd);
  if (end == std::string::npos)
    return input;
  const std::size_t body = end + kEnd.size();
  return project::fileHead(project::kStationMagic, 1, input.substr(0, body)) + input.substr(body);
}

} // namespace

std::vector<std::string> fuzz::seeds() {
  project::Station station;
  station.machines.push_back({"one", test::sampleJob()});
  station.machines.push_back({"two", test::sampleJob(), Eigen::Isometry3d::Identity()});
  station.rules.pauseInBeadsS = 2.0;
  const std::string bytes = project::stationBytes(station);
  const std::size_t sum = bytes.find('\n', bytes.find('\n') + 1) + 1; // behind two lines
  return {bytes.substr(sum)};
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::write("station.voluta", stationWithSum(fuzz::textOf(data, size)));
  fuzz::takenOrRefused([] {
    const project::Station station =
        project::readStation("station.voluta", pipeline::allParameters());
    fuzz::expect(!station.machines.empty(), "a station has machines");
    for (const project::Machine& machine : station.machines)
      fuzz::expect(machine.shared_T_world.matrix().allFinite(), "a place is finite");
    project::stationBytes(station);
  });
  return 0;
}
