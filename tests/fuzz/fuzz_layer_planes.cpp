// Layers and cuts given by the user, as JSON.
#include "fuzz_target.h"

#include "planar/given_cuts.h"
#include "planar/slicing/user_planes.h"

#include <cmath>

using namespace voluta;

std::vector<std::string> fuzz::seeds() {
  return {R"([{"point": [0, 0, 0.4], "normal": [0, 0, 1]}])",
          R"([{"corners": [[-1, -1, 0.4], [8, -1, 0.4], [8, 11, 0.4], [-1, 11, 0.4]]}])"};
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::takenOrRefused([&] {
    for (const planar::UserPlane& p : planar::readUserPlanes(fuzz::textOf(data, size), "planes")) {
      fuzz::expect(std::abs(p.plane.normal.norm() - 1.0) < 1e-9, "normals are unit vectors");
      fuzz::expect(std::isfinite(p.plane.offsetMm), "planes are somewhere");
      fuzz::expect(p.corners.empty() || p.corners.size() == 4, "quadrilaterals have four corners");
    }
  });
  fuzz::takenOrRefused([&] {
    const auto cuts = planar::readGivenCuts(fuzz::textOf(data, size), "planes");
    const auto again = planar::readGivenCuts(planar::givenCutsText(cuts), "written");
    fuzz::expect(again.size() == cuts.size(), "cuts come back as they were written");
    for (std::size_t i = 0; i < cuts.size() && i < again.size(); ++i)
      fuzz::expect((again[i].plane.normal - cuts[i].plane.normal).norm() < 1e-12 &&
                       again[i].point == cuts[i].point,
                   "cuts come back where they were");
  });
  return 0;
}
