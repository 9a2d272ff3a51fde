#include "modes/piece_search.h"

#include "base/error.h"
#include "base/far_places.h"
#include "base/number_list.h"
#include "planar/published/greedy_decompose.h"
#include "planar/search/beam_search.h"

#include <fmt/format.h>

namespace voluta::modes {

namespace {

constexpr const char* kGreedy = "greedy";

} // namespace

base::ParameterTable pieceSearchParameters() {
  return base::ParameterTable({
      base::choiceParameter("planarScheme", "beam",
                            {{"beam", "beam"_text}, {kGreedy, "greedy"_text}}, "Pieces"_text,
                            "scheme"_text,
                            "Mode planar: beam is a beam search that checks the true "
                            "shape of the head; greedy is the published scheme, based on "
                            "the part's skeleton."_text,
                            true),
      base::integerParameter("pieceClusters", 0, 0, 12, "Pieces"_text, "thickness classes"_text,
                             "Scheme greedy: number of thickness classes that "
                             "distinguish the part's branches. 0: automatic."_text),
      base::textParameter("pieceRoot", "Pieces"_text, "root"_text,
                          "Scheme greedy: a point x,y,z (mm) on the piece to print "
                          "first; that piece must touch the plate. Empty: the piece with "
                          "the largest contact area."_text),
  });
}

PieceSearch pieceSearch(const base::ParameterValues& values) {
  if (values.text("planarScheme") != kGreedy)
    return {};
  return {true, static_cast<int>(values.integer("pieceClusters")), values.text("pieceRoot")};
}

std::optional<Eigen::Vector3d> pieceRoot(const std::string& text) {
  if (text.find_first_not_of(' ') == std::string::npos)
    return std::nullopt;
  Eigen::Vector3d root;
  if (!base::readNumbers(text, ',', {&root.x(), &root.y(), &root.z()}))
    throw base::Error(base::ErrorCode::Usage, base::message("\"{text}\" is not a point"_text, text),
                      "pieceRoot"_name, "write x,y,z in mm, such as 10,0,5"_text);
  base::refuseFar({root.data(), 3}, text, "pieceRoot"_name);
  return root;
}

std::string pieceRootText(const Eigen::Vector3d& root) {
  return fmt::format("{:.6g},{:.6g},{:.6g}", root.x(), root.y(), root.z());
}

planar::PlanarDecomposition searchPieces(const geometry::TriangleMesh& part,
                                         const planar::PlanarOptions& options,
                                         const PieceSearch& search, const base::RunContext& ctx) {
  if (!search.greedy)
    return planar::beamDecompose(part, options, ctx);
  planar::GreedyOptions greedy;
  greedy.clusters = static_cast<std::size_t>(search.clusters);
  greedy.root = pieceRoot(search.root);
  return planar::greedyDecompose(part, options, greedy, ctx);
}

} // namespace voluta::modes
