// layer_report [--pitch MM | --voxels N] [--threads N] [--scale F] [--keep DIR] [--vtp FILE] STL...
// Layers of real parts and figures measured from outside: volume, boundaries, support, triangles,
// coverage by sampling. --keep: decompositions are kept in DIR and read from there.
#include "base/stopwatch.h"
#include "curved/curved_layers.h"
#include "curved/decompose.h"
#include "curved/platform_polygon.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/measures.h"
#include "helpers/voxel_width.h"
#include "layers/stack_checker.h"
#include "layers/vtp_writer.h"
#include "plan/finding_kinds.h"
#include "voxel/solid_voxels.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <iostream>
#include <string>

using namespace voluta;

namespace {

geometry::TriangleMesh placed(geometry::TriangleMesh mesh, double scale) {
  for (auto& v : mesh.vertices)
    v *= scale;
  const Eigen::AlignedBox3d box = geometry::bounds(mesh);
  const Eigen::Vector3d shift(-box.center().x(), -box.center().y(), -box.min().z());
  for (auto& v : mesh.vertices)
    v += shift;
  return mesh;
}

void triangleQuality(const layers::LayerStack& stack) {
  std::size_t triangles = 0, below5 = 0, below15 = 0;
  double shortest = 1e9;
  for (const auto& p : stack.patches)
    for (std::size_t t = 0; t < p.surface.triangles.size(); ++t) {
      double minimum = 180.0;
      for (int k = 0; k < 3; ++k) {
        const Eigen::Vector3d a = p.surface.corner(t, (k + 1) % 3) - p.surface.corner(t, k),
                              b = p.surface.corner(t, (k + 2) % 3) - p.surface.corner(t, k);
        minimum = std::min(minimum, std::atan2(a.cross(b).norm(), a.dot(b)) * 57.29578);
        shortest = std::min(shortest, a.norm());
      }
      ++triangles;
      below5 += minimum < 5.0;
      below15 += minimum < 15.0;
    }
  std::printf("  %zu triangles; least angle below 5: %.4f, below 15: %.4f; shortest edge %.5f\n",
              triangles, static_cast<double>(below5) / static_cast<double>(triangles),
              static_cast<double>(below15) / static_cast<double>(triangles), shortest);
}

template <typename T> void put(std::ostream& out, const std::vector<T>& v) {
  out.write(reinterpret_cast<const char*>(v.data()),
            static_cast<std::streamsize>(v.size() * sizeof(T)));
}

template <typename T> bool get(std::istream& in, std::vector<T>& v, std::size_t n) {
  v.resize(n);
  return static_cast<bool>(
      in.read(reinterpret_cast<char*>(v.data()), static_cast<std::streamsize>(n * sizeof(T))));
}

curved::Decomposition decomposed(const voxel::SolidVoxels& solid, const std::string& file,
                                 const curved::CurvedOptions& growth, const base::RunContext& ctx) {
  const std::size_t n = solid.grid.cellCount();
  if (std::ifstream in(file, std::ios::binary); !file.empty() && in) {
    curved::Decomposition d;
    d.grid = solid.grid;
    if (get(in, d.rank, n) && get(in, d.field, n) && get(in, d.frontNormal, n)) {
      for (const std::int32_t r : d.rank) {
        d.voxels += r != 0;
        d.missedVoxels += r < 0;
      }
      return d;
    }
  }
  auto d = curved::decompose(solid, curved::platformFit(solid, 0.0), growth, ctx);
  if (!file.empty()) {
    std::ofstream out(file, std::ios::binary);
    put(out, d.rank);
    put(out, d.field);
    put(out, d.frontNormal);
  }
  return d;
}

} // namespace

int main(int argc, char** argv) try {
  double pitch = 0.8, scale = 1.0, wanted = 0.0;
  int threads = 2;
  std::string vtp, keep;
  curved::CurvedOptions growth;
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i) {
    const std::string a = argv[i];
    const auto next = [&] { return i + 1 < argc ? std::string(argv[++i]) : std::string(); };
    if (a == "--pitch")
      pitch = std::stod(next());
    else if (a == "--voxels")
      wanted = std::stod(next());
    else if (a == "--keep")
      keep = next();
    else if (a == "--scale")
      scale = std::stod(next());
    else if (a == "--threads")
      threads = std::stoi(next());
    else if (a == "--growth")
      growth.growth = curved::GrowthScheme(next());
    else if (a == "--rounds")
      growth.rounds = std::stoi(next());
    else if (a == "--vtp")
      vtp = next();
    else
      files.push_back(a);
  }
  const base::RunContext ctx({}, threads);
  for (const std::string& file : files) {
    const geometry::TriangleMesh part = placed(geometry::readMesh(file).mesh, scale);
    if (wanted > 0.0)
      pitch = test::voxelWidthFor(part, wanted, ctx);
    base::Stopwatch clock;
    const auto solid = voxel::solidVoxels(part, pitch, ctx);
    const std::string kept = keep.empty() ? keep
                                          : keep + "/" + file.substr(file.find_last_of('/') + 1) +
                                                "." + std::to_string(solid.count);
    const auto d = decomposed(solid, kept, growth, ctx);
    const double grown = clock.seconds();
    const std::clock_t before = std::clock();
    const auto r = curved::curvedLayers(d, part, {}, ctx);
    const double cpu = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
    const auto& s = r.statistics;
    const double volume = geometry::volume(part);
    std::printf(
        "%s: pitch %.3f, %zu voxels, missed %zu, decompose %.1f s, extract %.2f s, trim %.2f s "
        "(%.2f s of processor time)\n",
        file.c_str(), pitch, d.voxels, d.missedVoxels, grown, r.seconds.extract, r.seconds.trim,
        cpu);
    std::printf(
        "  area x thickness / volume %.4f (%.0f mm3), spacing %.4f, %d layers, %zu patches, "
        "area %.0f mm2\n",
        r.volumeMm3 / volume, volume, r.spacingMm, s.count, s.patches, s.areaMm2);
    std::printf("  thickness %.3f +- %.3f, P01 %.3f, P99 %.3f, within limits %.4f\n",
                s.thicknessMeanMm, s.thicknessStdMm, s.thicknessP01Mm, s.thicknessP99Mm,
                s.withinLimitsFraction);
    std::printf("  partial patches %zu, %.4f of the area; merged %zu pieces, %.1f mm3\n",
                r.partialPatches, r.partialAreaMm2 / s.areaMm2, r.mergedPieces, r.mergedVolumeMm3);
    std::printf("  dropped %zu pieces, %.1f mm3 (%.4f); unsupported patches %zu\n", r.droppedPieces,
                r.droppedVolumeMm3, r.droppedVolumeMm3 / volume, r.unsupportedPatches);
    const test::StackVerdict v = test::checkStack(r.stack, part, 0.4, 1.0);
    std::printf("  told: boundary farthest %.5f mm, unsupported %.5f of the area\n",
                r.boundaryFarthestMm, r.unsupportedFraction);
    std::printf(
        "  checked: volume %.4f; boundary farthest %.5f mm, on seams %zu, near %zu, loose %zu, not "
        "simple %zu%s\n",
        v.volumeRatio, v.boundaryFarthestMm, v.seamVertices, v.nearVertices, v.looseVertices,
        v.notSimple, v.layersRise ? "" : ", LAYERS OUT OF ORDER");
    std::printf("  thickness by distance %.3f, P01 %.3f, P99 %.3f, within %.4f, as told %.4f\n",
                v.thicknessMeanMm, v.thicknessP01Mm, v.thicknessP99Mm, v.within, v.asReported);
    std::printf("  unsupported %.4f of the area, patches in the air %zu, out of order %zu; points "
                "in none %.4f, in several %.4f; sharp edges %zu, P99 %.4f mm off, most %.4f\n",
                v.unsupported, v.patchesInTheAir, v.outOfOrder, v.inNone, v.inSeveral,
                v.sharpCrossings, v.sharpOffP99Mm, v.sharpOffMaxMm);
    std::printf(
        "  sharp most at %.2f %.2f %.2f; upward surface to tops: mean %.4f, P99 %.4f mm; plate "
        "to feet %.4f mm\n",
        v.sharpOffAt.x(), v.sharpOffAt.y(), v.sharpOffAt.z(), v.topMeanMm, v.topP99Mm,
        v.plateMaxMm);
    std::printf("  within 25 degrees of the layers (%.3f of the surface): mean %.4f, P99 %.4f mm\n",
                v.flatTopShare, v.flatTopMeanMm, v.flatTopP99Mm);
    for (const auto& a : v.air) {
      const layers::Patch& p = r.stack.patches[static_cast<std::size_t>(a.patch)];
      std::printf("  in the air: layer %d, patch %d, %.2f mm2, %.2f mm thick, at %.2f %.2f %.2f, "
                  "facing %.2f "
                  "%.2f %.2f\n",
                  p.layer, a.patch, a.areaMm2, p.thicknessMm[0], a.centre.x(), a.centre.y(),
                  a.centre.z(), p.direction[0].x(), p.direction[0].y(), p.direction[0].z());
    }
    triangleQuality(r.stack);
    for (const auto& f : r.findings)
      std::printf("  %s: %s at %.1f %.1f %.1f\n", voluta::plan::reportId(f).c_str(),
                  voluta::plan::englishReason(f).c_str(), f.where->x(), f.where->y(), f.where->z());
    std::fflush(stdout);
    if (!vtp.empty())
      std::ofstream(vtp, std::ios::binary) << layers::writeLayersVtp(r.stack);
  }
  return 0;
} catch (const std::exception& e) {
  std::cerr << e.what() << '\n';
  return 1;
}
