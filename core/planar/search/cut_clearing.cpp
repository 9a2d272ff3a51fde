#include "base/parallel.h"
#include "geometry/measures.h"
#include "planar/search/cut_search_state.h"

#include <algorithm>

namespace voluta::planar {

using Eigen::Vector3d;

namespace {

constexpr int kRounds = 4;              // of clearings per partial result
constexpr std::size_t kPlanesTried = 3; // per clearing
constexpr double kClearMm = 1.0;        // between the plane and the obstacle above it
constexpr double kCosts = 0.01;         // of the initial risky area: maximum cost of a clearing

// Returns the vertices of the section that a piece is based on.
std::vector<Vector3d> sectionCorners(const Piece& piece) {
  std::vector<Vector3d> out;
  for (std::size_t t = 0; t < piece.solid.tag.size(); ++t)
    if (piece.solid.tag[t] == piece.baseTag)
      for (int k = 0; k < 3; ++k)
        out.push_back(piece.solid.mesh.corner(t, k));
  return out;
}

// Returns the risky area that the faces above the plane save when printed along its normal.
double gainAbove(const Piece& piece, const FaceTable& faces, const RiskRule& rule,
                 const Plane& plane) {
  double gain = 0.0;
  for (std::size_t t = 0; t < faces.area.size(); ++t) {
    const auto& mesh = piece.solid.mesh;
    if ((plane.heightOf(mesh.corner(t, 0)) + plane.heightOf(mesh.corner(t, 1)) +
         plane.heightOf(mesh.corner(t, 2))) <= 0.0)
      continue;
    gain += faces.risky[t];
    if (!faces.onPrinted[t] && isRisky(faces.normal[t], plane.normal, rule))
      gain -= faces.area[t];
  }
  return gain;
}

} // namespace

std::shared_ptr<CutSearch::Cutting> CutSearch::clearing(const Node& of, Node& what) {
  const Vector3d& up = of.piece.base.normal;
  const double first = firstTipMm(of.piece, options_.rule);
  const std::vector<Vector3d> hiding = head_.inside(of.tips, what.obstacles(), up, first);
  if (hiding.empty())
    return nullptr;
  const std::vector<Vector3d> section =
      std::binary_search(what.holds.begin(), what.holds.end(), of.piece.baseTag)
          ? sectionCorners(of.piece)
          : std::vector<Vector3d>{};
  if (what.faces.area.empty())
    what.faces = faceTable(what.piece, options_.rule);
  struct Choice {
    Plane plane;
    double gain = 0.0;
  };
  std::vector<Vector3d> normals{what.piece.base.normal};
  normals.insert(normals.end(), normals_.begin(), normals_.end());
  std::vector<Choice> choices(normals.size());
  base::parallelChunks(ctx_, normals.size(), 8, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      Choice& c = choices[i];
      c.gain = -1e300;
      c.plane.normal = normals[i];
      if (isRisky(normals[i], what.piece.base.normal, options_.rule))
        continue;
      double low = 1e300;
      for (const Vector3d& p : hiding)
        low = std::min(low, normals[i].dot(p));
      c.plane.offsetMm = low - kClearMm;
      if (std::any_of(section.begin(), section.end(),
                      [&](const Vector3d& p) { return c.plane.heightOf(p) > -0.1; }))
        continue;
      c.gain = gainAbove(what.piece, what.faces, options_.rule, c.plane);
    }
  });
  std::stable_sort(choices.begin(), choices.end(),
                   [](const Choice& a, const Choice& b) { return a.gain > b.gain; });
  for (std::size_t i = 0; i < std::min(choices.size(), kPlanesTried); ++i) {
    const Plane& plane = choices[i].plane;
    if (choices[i].gain < -kCosts * before_)
      break;
    const auto wanted = [&](const TaggedMesh& solid) {
      if (geometry::volume(solid.mesh) < options_.minVolumeMm3)
        return false;
      const std::vector<Vector3d> surface = surfaceSamples(solid.mesh, kReachSpacingMm);
      return !head_.inside(of.tips, {surface}, up, first).empty();
    };
    auto cut = splitIfItCloses(what.piece, plane, tags_, wanted, options_.rule);
    if (!cut)
      continue;
    tags_ += kTagsPerCut;
    auto made = std::make_shared<Cutting>();
    made->below = node(std::move(cut->below));
    if (head_.blocked(of.tips, made->below->obstacles(), up, first))
      continue;
    made->step.piece = what.id;
    made->step.plane = plane;
    made->step.clears = true;
    made->step.sectionMiddles = cut->sectionMiddles;
    made->below->id = ids_++;
    made->step.below = made->below->id;
    for (Piece& piece : cut->above) {
      made->above.push_back(node(std::move(piece)));
      made->above.back()->id = ids_++;
      made->step.above.push_back(made->above.back()->id);
    }
    return made;
  }
  return nullptr;
}

bool CutSearch::clearWays(State& state, std::size_t maxBlocked) {
  for (int round = 0; round < kRounds && state.blocked > maxBlocked; ++round) {
    ctx_.checkpoint();
    const PieceOrder order = orderKnown(state);
    if (order.late.empty())
      return false;
    const auto [i, j] = order.late.front();
    const NodePtr of = state.nodes[i], what = state.nodes[j];
    const auto known = clearings_.find({of->id, what->id});
    const std::shared_ptr<Cutting> cutting =
        known != clearings_.end()
            ? known->second
            : clearings_.emplace(std::pair(of->id, what->id), clearing(*of, *what)).first->second;
    if (!cutting)
      return false;
    replace(state, what, cutting);
    weigh(state);
    weighHead(state);
  }
  return state.blocked <= maxBlocked;
}

} // namespace voluta::planar
