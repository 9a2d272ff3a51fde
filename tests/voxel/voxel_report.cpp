// voxel_report [--voxels N | --pitch MM] [--threads N] STL... Prints the cost of voxelising real
// parts, and whether the cells contain them by the tests' own check.
#include "base/memory.h"
#include "base/stopwatch.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/measures.h"
#include "helpers/voxel_width.h"
#include "voxel/containment.h"
#include "voxel/solid_voxels.h"
#include "voxel/wall_thickness.h"

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

using namespace voluta;

namespace {} // namespace

int main(int argc, char** argv) try {
  double pitch = 0.8, wanted = 0.0;
  int threads = 2;
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i) {
    const std::string arg = argv[i];
    const auto next = [&] { return std::string(i + 1 < argc ? argv[++i] : ""); };
    if (arg == "--voxels")
      wanted = std::stod(next());
    else if (arg == "--pitch")
      pitch = std::stod(next());
    else if (arg == "--threads")
      threads = std::stoi(next());
    else
      files.push_back(arg);
  }
  const base::RunContext ctx(base::CancelToken{}, threads);
  for (const std::string& file : files) {
    const geometry::TriangleMesh mesh = geometry::readMesh(file).mesh;
    const double width = wanted > 0.0 ? test::voxelWidthFor(mesh, wanted, ctx) : pitch;
    double best = 1e9;
    voxel::SolidVoxels voxels;
    for (int run = 0; run < 5; ++run) {
      const base::Stopwatch watch;
      voxels = voxel::solidVoxels(mesh, width, ctx);
      best = std::min(best, watch.seconds());
    }
    const double peak = base::peakResidentMb();
    const test::Containment found = test::checkContainment(mesh, voxels, 40'000, 1);
    std::printf("%s: pitch %.4f, %zu of %zu cells, %.3f s (best of 5, %d threads), peak %.0f MB\n",
                file.substr(file.find_last_of('/') + 1).c_str(), width, voxels.count,
                voxels.grid.cellCount(), best, threads, peak);
    std::printf("  of %zu points of the surface %zu outside (deepest %.2g mm), of %zu inside %zu "
                "outside, of %zu far off %zu in cells\n",
                found.surface, found.surfaceOutside, found.deepestMm, found.inside,
                found.insideOutside, found.far, found.farInCells);
    const base::Stopwatch watch;
    const std::vector<voxel::ThinPlace> thin = voxel::thinPlaces(mesh, width, ctx);
    std::printf("  %zu places thinner than a voxel, found in %.3f s", thin.size(), watch.seconds());
    for (std::size_t i = 0; i < std::min<std::size_t>(3, thin.size()); ++i)
      std::printf("%s %.2f mm over %.1f mm2", i == 0 ? ":" : ",", thin[i].usualMm, thin[i].areaMm2);
    std::printf("\n");
  }
  return 0;
} catch (const std::exception& e) {
  std::fprintf(stderr, "%s\n", e.what());
  return 1;
}
