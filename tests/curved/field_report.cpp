// field_report [--voxels N | --pitch MM] [--growth G] [--rounds N] [--threads N] [--vti FILE]
// STL... Prints figures of growth and field on real parts, judged by the tests' own checkers.
#include "base/stopwatch.h"
#include "curved/decompose.h"
#include "curved/platform_polygon.h"
#include "curved/rank_checker.h"
#include "curved/vti_writer.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/measures.h"
#include "helpers/voxel_width.h"
#include "plan/finding_kinds.h"
#include "process/process.h"
#include "voxel/solid_voxels.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

using namespace voluta;

namespace {

// Share of the surface, by area, that leans over by more than 60 degrees against `direction`.
template <typename Direction>
double overhang(const geometry::TriangleMesh& mesh, double plateMm, Direction&& direction) {
  double all = 0.0, over = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Eigen::Vector3d centre =
        (mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0;
    const double area = geometry::triangleArea(mesh, t);
    all += area;
    const Eigen::Vector3d n = geometry::triangleNormal(mesh, t);
    // Surfaces on the plate, to within a voxel, are supported by it.
    if (centre.z() < plateMm && n.z() < 0.0)
      continue;
    if (n.dot(direction(centre)) < -std::sin(std::acos(-1.0) / 3.0))
      over += area;
  }
  return over / all;
}

// Direction of growth at a point from values of the printed cells within two cells of it.
template <typename Value>
Eigen::Vector3d growthAt(const curved::Decomposition& d, const Eigen::Vector3d& p, Value&& value) {
  const Eigen::Vector3i at = d.grid.cellOf(p);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  double meanValue = 0.0, n = 0.0;
  const auto each = [&](auto&& visit) {
    for (int k = -2; k <= 2; ++k)
      for (int j = -2; j <= 2; ++j)
        for (int i = -2; i <= 2; ++i)
          if (d.grid.contains(at.x() + i, at.y() + j, at.z() + k)) {
            const std::size_t c = d.grid.index(at.x() + i, at.y() + j, at.z() + k);
            if (d.rank[c] > 0)
              visit(Eigen::Vector3d(i, j, k), value(c));
          }
  };
  each([&](const Eigen::Vector3d& x, double v) {
    mean += x;
    meanValue += v;
    n += 1.0;
  });
  if (n < 4.0)
    return Eigen::Vector3d::UnitZ();
  mean /= n;
  meanValue /= n;
  Eigen::Matrix3d a = 1e-6 * Eigen::Matrix3d::Identity();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  each([&](const Eigen::Vector3d& x, double v) {
    a += (x - mean) * (x - mean).transpose();
    b += (x - mean) * (v - meanValue);
  });
  return (a.inverse() * b).normalized();
}

} // namespace

int main(int argc, char** argv) try {
  double pitch = 0.8, wanted = 0.0;
  int threads = 2;
  bool check = true;
  std::string vti;
  curved::CurvedOptions options;
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i) {
    const std::string arg = argv[i];
    const auto next = [&] { return std::string(i + 1 < argc ? argv[++i] : ""); };
    if (arg == "--voxels")
      wanted = std::stod(next());
    else if (arg == "--pitch")
      pitch = std::stod(next());
    else if (arg == "--growth")
      options.growth = curved::GrowthScheme(next());
    else if (arg == "--rounds")
      options.rounds = std::stoi(next());
    else if (arg == "--threads")
      threads = std::stoi(next());
    else if (arg == "--no-check")
      check = false;
    else if (arg == "--nozzle")
      options.head = process::erodedHead(process::loadProcess("fdm-1.0").head, 0.4);
    else if (arg == "--vti")
      vti = next();
    else
      files.push_back(arg);
  }
  const base::RunContext ctx(base::CancelToken{}, threads);
  for (const std::string& file : files) {
    const geometry::TriangleMesh mesh = geometry::readMesh(file).mesh;
    const double width = wanted > 0.0 ? test::voxelWidthFor(mesh, wanted, ctx) : pitch;
    base::Stopwatch watch;
    const voxel::SolidVoxels voxels = voxel::solidVoxels(mesh, width, ctx);
    const double voxelise = watch.seconds();
    const curved::Decomposition d =
        curved::decompose(voxels, curved::platformFit(voxels, 0.0), options, ctx);
    std::printf("%s: pitch %.3f, %zu voxels, %d ranks, missed %zu (shadowed %zu, unreached %zu)\n",
                file.substr(file.find_last_of('/') + 1).c_str(), width, d.voxels, d.layers,
                d.missedVoxels, d.shadowedVoxels, d.unreachedVoxels);
    std::printf("  s: voxelise %.2f peel %.2f grow %.2f smooth %.2f total %.2f\n", voxelise,
                d.seconds.peel, d.seconds.grow, d.seconds.smooth, watch.seconds());
    if (check) {
      const test::RankVerdict ranks = test::checkRanks(d, voxels.solid);
      std::printf("  ranks: unsupported %zu, inside %zu (deepest %.3f voxels), wrong cells %zu\n",
                  ranks.unsupported, ranks.inside, ranks.deepest, ranks.wrongCells);
      const double flat = overhang(mesh, d.grid.pitch,
                                   [](const Eigen::Vector3d&) { return Eigen::Vector3d::UnitZ(); });
      const double rank = overhang(mesh, d.grid.pitch, [&](const Eigen::Vector3d& p) {
        return growthAt(d, p, [&](std::size_t c) { return static_cast<double>(d.rank[c]); });
      });
      if (!d.field.empty()) {
        const test::FieldVerdict f =
            test::checkField(d, options.layerHeightMm, options.heightMinMm, options.heightMaxMm);
        const double field = overhang(mesh, d.grid.pitch, [&](const Eigen::Vector3d& p) {
          return growthAt(d, p, [&](std::size_t c) { return static_cast<double>(d.field[c]); });
        });
        std::printf("  field: within %.2f %%, thickness %.3f +- %.3f (%.2f-%.2f), inaccessible "
                    "%.3f %% (deepest %.2f), levels %d, patches %zu, islands %zu (%zu voxels)\n",
                    100 * f.within, f.mean, f.deviation, f.p01, f.p99, 100 * f.inaccessible,
                    f.deepest, f.levels, f.patches, f.islands, f.islandVoxels);
        std::printf("  beyond 60 degrees: field %.2f %%, ranks %.2f %%, planar %.2f %%\n",
                    100 * field, 100 * rank, 100 * flat);
      } else {
        std::printf("  beyond 60 degrees: ranks %.2f %%, planar %.2f %%\n", 100 * rank, 100 * flat);
      }
    }
    for (const plan::Finding& f : d.findings)
      std::printf("  finding %s: %s\n", voluta::plan::reportId(f).c_str(),
                  voluta::plan::englishReason(f).c_str());
    if (!vti.empty())
      std::ofstream(vti, std::ios::binary) << curved::voxelsVti(d);
    std::fflush(stdout);
  }
} catch (const std::exception& e) {
  std::cerr << e.what() << '\n';
  return 1;
}
