#include "planar/piece_order.h"

#include "geometry/measures.h"
#include "planar/head_reach.h"
#include "planar/planar_decomposition.h"
#include "planar/plate_contact.h"

#include <algorithm>

namespace voluta::planar {

PieceOrder orderOf(const std::vector<std::int32_t>& standsOnTag,
                   const std::vector<std::vector<std::int32_t>>& holds,
                   const std::function<bool(std::size_t i, std::size_t j)>& isBlocking) {
  const std::size_t n = standsOnTag.size();
  PieceOrder out;
  out.under.resize(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      if (i != j && standsOnTag[i] >= 0 &&
          std::binary_search(holds[j].begin(), holds[j].end(), standsOnTag[i]))
        out.under[i].push_back(static_cast<int>(j));
  // Pieces printed on a piece, directly or through others, come after it in any case.
  std::vector<std::vector<bool>> over(n, std::vector<bool>(n, false));
  for (std::size_t i = 0; i < n; ++i) {
    std::vector<int> todo = out.under[i];
    while (!todo.empty()) {
      const auto j = static_cast<std::size_t>(todo.back());
      todo.pop_back();
      if (over[i][j])
        continue;
      over[i][j] = true;
      todo.insert(todo.end(), out.under[j].begin(), out.under[j].end());
    }
  }
  // waits[j]: pieces that j would block and that should therefore be printed before j
  std::vector<std::vector<std::size_t>> waits(n);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      if (i != j && !over[j][i] && isBlocking(i, j))
        waits[j].push_back(i);
  std::vector<bool> done(n, false);
  const auto standing = [&](std::size_t i) {
    return std::all_of(out.under[i].begin(), out.under[i].end(),
                       [&](int j) { return done[static_cast<std::size_t>(j)]; });
  };
  while (out.order.size() < n) {
    std::size_t next = n, fewest = n;
    for (std::size_t i = 0; i < n && fewest > 0; ++i) {
      if (done[i] || !standing(i))
        continue;
      const auto conflicts = static_cast<std::size_t>(
          std::count_if(waits[i].begin(), waits[i].end(), [&](std::size_t w) { return !done[w]; }));
      if (next == n || conflicts < fewest) {
        next = i;
        fewest = conflicts;
      }
    }
    if (next == n)
      break;
    done[next] = true;
    out.order.push_back(next);
  }
  std::vector<std::size_t> place(n, n);
  for (std::size_t p = 0; p < out.order.size(); ++p)
    place[out.order[p]] = p;
  std::vector<bool> blocked(n, false);
  for (std::size_t j = 0; j < n; ++j)
    for (const std::size_t i : waits[j])
      if (place[j] < place[i]) {
        blocked[i] = true;
        out.late.emplace_back(i, j);
      }
  out.blocked = static_cast<std::size_t>(std::count(blocked.begin(), blocked.end(), true)) +
                (n - out.order.size());
  return out;
}

std::vector<Piece> printOrder(std::vector<Piece> pieces, const PlanarOptions& options,
                              double spacingMm, std::size_t& blocked) {
  const std::size_t n = pieces.size();
  std::vector<std::int32_t> standsOnTag;
  std::vector<std::vector<std::int32_t>> holds;
  std::vector<std::vector<Eigen::Vector3d>> tips, bodies;
  for (std::size_t p = 0; p < n; ++p) {
    const Piece& piece = pieces[p];
    standsOnTag.push_back(piece.baseTag);
    holds.push_back(sectionsHeld(piece));
    bodies.push_back(surfaceSamples(piece.solid.mesh, spacingMm));
    tips.push_back(tipsOf(bodies.back()));
    bodies.back() = withPlate(std::move(bodies.back()), piece, options, spacingMm);
  }
  const HeadReach head(options.head);
  const PieceOrder found = orderOf(standsOnTag, holds, [&](std::size_t i, std::size_t j) {
    return head.blocked(tips[i], {bodies[j]}, pieces[i].base.normal,
                        firstTipMm(pieces[i], options.rule));
  });
  blocked = found.blocked;
  std::vector<int> place(n, -1);
  for (std::size_t p = 0; p < found.order.size(); ++p)
    place[found.order[p]] = static_cast<int>(p);
  std::vector<Piece> out;
  for (const std::size_t p : found.order) {
    Piece piece = std::move(pieces[p]);
    piece.parent = -1;
    piece.under.clear();
    double maximum = -1.0;
    for (const int u : found.under[p]) {
      const auto at = static_cast<std::size_t>(place[static_cast<std::size_t>(u)]);
      double shared = 0.0;
      for (std::size_t t = 0; t < out[at].solid.tag.size(); ++t)
        if (out[at].solid.tag[t] == piece.baseTag)
          shared += geometry::triangleArea(out[at].solid.mesh, t);
      piece.under.push_back(static_cast<int>(at));
      if (shared > maximum) {
        maximum = shared;
        piece.parent = static_cast<int>(at);
      }
    }
    std::sort(piece.under.begin(), piece.under.end());
    out.push_back(std::move(piece));
  }
  return out;
}

} // namespace voluta::planar
