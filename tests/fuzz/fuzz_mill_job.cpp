// Jobs of milled parts.
#include "fuzz_target.h"

#include "pipeline/mill_job.h"

using namespace voluta;

std::vector<std::string> fuzz::seeds() {
  pipeline::MillOrder order;
  order.name = "part";
  order.rule.data = *milling::cuttingDataFor("soft-plastic");
  geometry::TriangleMesh part;
  part.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  part.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  return {pipeline::writeMillJob(part, order)};
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::takenOrRefused([&] {
    const pipeline::MillJob job = pipeline::readMillJob(fuzz::textOf(data, size), "mill.json");
    for (const auto& triangle : job.part.triangles)
      for (const int corner : triangle)
        fuzz::expect(corner >= 0 && static_cast<std::size_t>(corner) < job.part.vertices.size(),
                     "indices are in range");
  });
  return 0;
}
