// growth_table [--voxels N[,N...]] [--growth SCHEME] [--threads N] [--repeat N] [--nozzle] STL...
// One row of Markdown for each part and number of voxels: best time of all runs for the order of
// growth (everything but voxelising), missed voxels, ranks, peak memory of the process so far; and
// for each part the exponent of time over voxels, fitted over the rows with at least 20 ms.
#include "base/memory.h"
#include "base/stopwatch.h"
#include "curved/grow.h"
#include "curved/platform_polygon.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/measures.h"
#include "helpers/voxel_width.h"
#include "process/process.h"
#include "voxel/solid_voxels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

using namespace voluta;

namespace {

// Slope of log(seconds) over log(voxels), least squares.
double exponent(const std::vector<std::array<double, 2>>& rows) {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const auto& [voxels, seconds] : rows) {
    const double u = std::log(voxels), v = std::log(seconds);
    n += 1.0;
    x += u;
    y += v;
    xx += u * u;
    xy += u * v;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

} // namespace

int main(int argc, char** argv) try {
  std::vector<double> counts{100000};
  curved::GrowthScheme scheme;
  int threads = 2, repeat = 5;
  process::HeadShape head;
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i) {
    const std::string arg = argv[i];
    const auto next = [&] { return std::string(i + 1 < argc ? argv[++i] : ""); };
    if (arg == "--voxels") {
      counts.clear();
      std::istringstream list(next());
      for (std::string item; std::getline(list, item, ',');)
        counts.push_back(std::stod(item));
    } else if (arg == "--growth") {
      scheme = curved::GrowthScheme(next());
    } else if (arg == "--threads") {
      threads = std::stoi(next());
    } else if (arg == "--repeat") {
      repeat = std::max(1, std::stoi(next()));
    } else if (arg == "--nozzle") {
      const process::Process fdm = process::loadProcess("fdm-1.0");
      head = process::erodedHead(fdm.head, fdm.contactToleranceMm);
    } else {
      files.push_back(arg);
    }
  }
  const base::RunContext ctx(base::CancelToken{}, threads);
  std::printf("%s, %d threads, best of %d\n\n", scheme.id().c_str(), threads, repeat);
  std::printf("| part | voxels | s | missed | relaxed | ranks | peak MB |\n"
              "|---|---|---|---|---|---|---|\n");
  for (const std::string& file : files) {
    const geometry::TriangleMesh mesh = geometry::readMesh(file).mesh;
    const std::string name = file.substr(file.find_last_of('/') + 1);
    std::vector<std::array<double, 2>> rows;
    for (const double wanted : counts) {
      const voxel::SolidVoxels voxels =
          voxel::solidVoxels(mesh, test::voxelWidthFor(mesh, wanted, ctx), ctx);
      const auto platform = curved::platformFit(voxels, 0.0);
      double best = 0.0;
      curved::Growth growth;
      for (int run = 0; run < repeat; ++run) {
        const base::Stopwatch watch;
        const curved::VoxelGraph graph =
            curved::voxelGraph(voxels.grid, voxels.solid, voxels.plateLayer(), platform);
        growth = curved::grow(graph, scheme, {}, ctx, head.sections.empty() ? nullptr : &head);
        best = run == 0 ? watch.seconds() : std::min(best, watch.seconds());
      }
      if (best >= 0.02)
        rows.push_back({static_cast<double>(voxels.count), best});
      std::printf("| %s | %zu | %.3f | %zu | %zu | %d | %.0f |\n", name.c_str(), voxels.count, best,
                  voxels.count - growth.printed, growth.relaxed, growth.ranks,
                  base::peakResidentMb());
      std::fflush(stdout);
    }
    if (rows.size() >= 2)
      std::printf("| %s | exponent | %.2f | | | | |\n", name.c_str(), exponent(rows));
  }
} catch (const std::exception& e) {
  std::cerr << e.what() << '\n';
  return 1;
}
