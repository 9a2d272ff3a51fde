// scheme_report [--voxels N] [--scheme S] [--isp N] [--queue flooding|insertion] [--boundary
// outside|inside] [--sacrifice layer|least] [--step N] [--no-check] STL... Prints figures of the
// sources' growth schemes on real parts, judged by the tests' own checker.
#include "base/stopwatch.h"
#include "curved/forward_growth.h"
#include "curved/peeling_field.h"
#include "curved/platform_polygon.h"
#include "curved/rank_checker.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/measures.h"
#include "helpers/voxel_width.h"
#include "voxel/solid_voxels.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

using namespace voluta;

namespace {

curved::Decomposition asDecomposition(const curved::VoxelGraph& graph,
                                      const voxel::SolidVoxels& voxels,
                                      const std::vector<Eigen::Vector2d>& platform,
                                      const std::vector<std::int32_t>& rank) {
  curved::Decomposition d;
  d.grid = voxels.grid;
  d.platform = platform;
  d.rank.assign(voxels.grid.cellCount(), 0);
  for (std::size_t c = 0; c < d.rank.size(); ++c)
    d.rank[c] = voxels.solid[c] ? -1 : 0;
  for (std::size_t v = 0; v < graph.size(); ++v)
    if (rank[v] > 0)
      d.rank[graph.grid.index(graph.cell[v][0], graph.cell[v][1], graph.cell[v][2])] = rank[v];
  return d;
}

} // namespace

int main(int argc, char** argv) try {
  double wanted = 20000.0;
  bool check = true;
  std::string only;
  std::vector<std::string> files;
  curved::ForwardOptions options;
  for (int i = 1; i < argc; ++i) {
    const std::string arg = argv[i];
    const auto next = [&] { return std::string(i + 1 < argc ? argv[++i] : ""); };
    if (arg == "--voxels")
      wanted = std::stod(next());
    else if (arg == "--scheme")
      only = next();
    else if (arg == "--isp")
      options.ispThreshold = std::stoi(next());
    else if (arg == "--queue")
      options.queue =
          next() == "insertion" ? curved::QueueOrder::Insertion : curved::QueueOrder::Flooding;
    else if (arg == "--boundary")
      options.boundary = next() == "inside" ? curved::Boundary::Inside : curved::Boundary::Outside;
    else if (arg == "--step")
      options.fieldStep = std::stoi(next());
    else if (arg == "--sacrifice")
      options.sacrifice = next() == "least" ? curved::Sacrifice::Fewest : curved::Sacrifice::Layer;
    else if (arg == "--no-check")
      check = false;
    else
      files.push_back(arg);
  }
  const base::RunContext ctx(base::CancelToken{}, 1);
  constexpr std::pair<const char*, curved::ForwardScheme> kSchemes[] = {
      {"greedy", curved::ForwardScheme::Greedy},
      {"incremental", curved::ForwardScheme::Incremental},
      {"adaptive", curved::ForwardScheme::Adaptive},
      {"guided", curved::ForwardScheme::Guided}};
  for (const std::string& file : files) {
    const geometry::TriangleMesh mesh = geometry::readMesh(file).mesh;
    const voxel::SolidVoxels voxels =
        voxel::solidVoxels(mesh, test::voxelWidthFor(mesh, wanted, ctx), ctx);
    const std::vector<Eigen::Vector2d> platform = curved::platformFit(voxels, 0.0);
    const curved::VoxelGraph graph =
        curved::voxelGraph(voxels.grid, voxels.solid, voxels.plateLayer(), platform);
    base::Stopwatch peeling;
    const std::vector<std::int32_t> field = curved::peelingField(graph, ctx);
    std::printf("%s: %zu voxels; peeling field %.3f s, %d sheets\n",
                file.substr(file.find_last_of('/') + 1).c_str(), graph.size(), peeling.seconds(),
                *std::max_element(field.begin(), field.end()));
    for (const auto& [name, scheme] : kSchemes) {
      if (!only.empty() && only != name)
        continue;
      base::Stopwatch watch;
      const curved::ForwardGrowth grown = curved::forwardGrowth(graph, scheme, options, ctx);
      const double seconds = watch.seconds();
      std::printf("  %-11s layers %5d, missed %6td, reduced %5zu, sacrificed %3zu, s %.2f", name,
                  grown.ranks, std::count(grown.rank.begin(), grown.rank.end(), 0), grown.reduced,
                  grown.sacrificed, seconds);
      if (check) {
        const test::RankVerdict verdict =
            test::checkRanks(asDecomposition(graph, voxels, platform, grown.rank), voxels.solid);
        std::printf("; unsupported %zu, inside %zu (%.3f)", verdict.unsupported, verdict.inside,
                    verdict.deepest);
      }
      std::printf("\n");
      std::fflush(stdout);
    }
  }
} catch (const std::exception& e) {
  std::cerr << e.what() << '\n';
  return 1;
}
