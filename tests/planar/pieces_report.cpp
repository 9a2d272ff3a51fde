// pieces_report [--scheme greedy|beam] [--clusters N] [--angle DEG] [--threads N] [--beam N]
// [--triangles N] [--no-head] [--stem] [--stl DIR] [--brief] STL... Planar decomposition of real
// parts and the verdict of a checker that is independent of the planner: a row each. --stem: the
// plate is carried as in the bundled UR5 cell.
#include "base/stopwatch.h"
#include "base/units.h"
#include "geometry/formats/mesh_reader.h"
#include "geometry/measures.h"
#include "planar/plan_check_of.h"
#include "planar/plan_checker.h"
#include "planar/published/greedy_decompose.h"
#include "planar/search/beam_search.h"
#include "process/process.h"

#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

using namespace voluta;

namespace {

void writeStl(const std::string& file, const geometry::TriangleMesh& mesh) {
  std::ofstream out(file);
  out << "solid piece\n";
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    out << "facet normal 0 0 0\nouter loop\n";
    for (int k = 0; k < 3; ++k)
      out << "vertex " << mesh.corner(t, k).transpose() << '\n';
    out << "endloop\nendfacet\n";
  }
  out << "endsolid\n";
}

} // namespace

int main(int argc, char** argv) try {
  planar::PlanarOptions options;
  options.head = process::erodedHead(process::loadProcess("fdm-1.0").head, 0.4);
  planar::GreedyOptions greedy;
  bool greedyScheme = false, brief = false;
  int threads = 2;
  std::string stl;
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i) {
    const std::string a = argv[i];
    const auto next = [&] { return i + 1 < argc ? std::string(argv[++i]) : std::string(); };
    if (a == "--angle")
      options.rule.overhangRad = base::degreesToRadians(std::stod(next()));
    else if (a == "--threads")
      threads = std::stoi(next());
    else if (a == "--scheme")
      greedyScheme = next() == "greedy";
    else if (a == "--clusters")
      greedy.clusters = std::stoul(next());
    else if (a == "--beam")
      options.beam = std::stoul(next());
    else if (a == "--triangles")
      options.searchTriangles = std::stoul(next());
    else if (a == "--normals")
      options.normals = std::stoi(next());
    else if (a == "--no-head")
      options.head.sections.clear();
    else if (a == "--stem")
      options.platform.stem = {{-100.0, -92.0, 32.0, 32.0}, {-92.0, -5.0, 14.0, 14.0}};
    else if (a == "--brief")
      brief = true;
    else if (a == "--stl")
      stl = next();
    else
      files.push_back(a);
  }
  const base::RunContext ctx({}, threads);
  for (const std::string& file : files) {
    geometry::TriangleMesh part = geometry::readMesh(file).mesh;
    const Eigen::AlignedBox3d box = geometry::bounds(part);
    const Eigen::Vector3d shift(-box.center().x(), -box.center().y(), -box.min().z());
    for (auto& v : part.vertices)
      v += shift;
    const base::Stopwatch watch;
    const std::clock_t begin = std::clock();
    const planar::PlanarDecomposition d = greedyScheme
                                              ? planar::greedyDecompose(part, options, greedy, ctx)
                                              : planar::beamDecompose(part, options, ctx);
    const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    const double clock = watch.seconds();
    const test::PlanCheck check = test::checkOf(d.pieces, options);
    const test::PlanVerdict verdict = test::checkPlan(part, d.pieces, check);
    std::printf(
        "%s: %zu triangles, risky %.1f -> %.2f mm2 (%.2f %%), %zu pieces, blocked %zu, "
        "sections %.0f mm2, %.1f s (%.1f s of processors); checked: risky %.2f mm2, blocked %zu, "
        "%s\n",
        file.substr(file.find_last_of('/') + 1).c_str(), part.triangles.size(), d.riskyBeforeMm2,
        d.riskyMm2, 100.0 * d.riskyMm2 / std::max(1e-9, d.riskyBeforeMm2), d.pieces.size(),
        d.blockedPieces, d.sectionMm2, clock, seconds, verdict.riskyMm2, verdict.blockedPieces,
        verdict.faults.empty() ? "valid" : "NOT VALID");
    for (const std::string& fault : verdict.faults)
      std::printf("  ! %s\n", fault.c_str());
    for (std::size_t p = 0; p < d.pieces.size(); ++p) {
      const planar::Piece& piece = d.pieces[p];
      if (!brief)
        std::printf("  %zu on %d: normal %.2f %.2f %.2f, volume %.0f, base %.1f, risky %.2f\n", p,
                    piece.parent, piece.base.normal.x(), piece.base.normal.y(),
                    piece.base.normal.z(), geometry::volume(piece.solid.mesh),
                    planar::baseArea(piece, options.rule), planar::riskyArea(piece, options.rule));
      if (!stl.empty())
        writeStl(stl + "/" + std::to_string(p) + ".stl", piece.solid.mesh);
    }
    std::fflush(stdout);
  }
} catch (const std::exception& e) {
  std::cerr << e.what() << '\n';
  return 1;
}
