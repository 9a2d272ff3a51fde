// pieces_report [--angle DEG] [--threads N] [--beam N] [--triangles N] [--no-head] [--stl DIR]
// STL... What planar decomposition makes of real parts: a row each.
#include "base/stopwatch.h"
#include "geometry/measures.h"
#include "geometry/mesh_reader.h"
#include "planar/beam_search.h"
#include "planar/greedy_decompose.h"
#include "process/process.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <numbers>
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
  bool greedyScheme = false;
  int threads = 2;
  std::string stl;
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i) {
    const std::string a = argv[i];
    const auto next = [&] { return i + 1 < argc ? std::string(argv[++i]) : std::string(); };
    if (a == "--angle")
      options.rule.overhangRad = std::stod(next()) * std::numbers::pi / 180.0;
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
    base::Stopwatch watch;
    const planar::PlanarDecomposition d =
        greedyScheme ? planar::greedyDecompose(part, options, greedy, ctx)
                     : planar::beamDecompose(part, options, ctx);
    double volume = 0.0;
    bool closed = true;
    for (const planar::Piece& p : d.pieces) {
      volume += geometry::volume(p.solid.mesh);
      closed = closed && planar::isClosed(p.solid.mesh);
    }
    std::printf("%s: %zu triangles, %zu pieces, risky %.1f -> %.2f mm2 (%.3f %%), sections %.0f "
                "mm2, blocked %zu, volume off %.1e, %s, %.2f s (search %.2f)\n",
                file.substr(file.find_last_of('/') + 1).c_str(), part.triangles.size(),
                d.pieces.size(), d.riskyBeforeMm2, d.riskyMm2,
                100.0 * d.riskyMm2 / std::max(1e-9, d.riskyBeforeMm2), d.sectionMm2,
                d.blockedPieces, volume / geometry::volume(part) - 1.0,
                closed ? "closed" : "NOT CLOSED", watch.seconds(), d.seconds.search);
    for (std::size_t p = 0; p < d.pieces.size(); ++p) {
      const planar::Piece& piece = d.pieces[p];
      std::printf("  %zu on %d: normal %.2f %.2f %.2f, volume %.0f, base %.1f, risky %.2f\n", p,
                  piece.parent, piece.base.normal.x(), piece.base.normal.y(), piece.base.normal.z(),
                  geometry::volume(piece.solid.mesh), planar::baseArea(piece, options.rule),
                  planar::riskyArea(piece, options.rule));
      if (!stl.empty())
        writeStl(stl + "/" + std::to_string(p) + ".stl", piece.solid.mesh);
    }
    std::fflush(stdout);
  }
} catch (const std::exception& e) {
  std::cerr << e.what() << '\n';
  return 1;
}
