#include "planar/decomposition.h"
#include "planar/head_reach.h"

#include <algorithm>
#include <map>

namespace voluta::planar {

namespace {

// Of this share of a piece's points the head may be kept off: samples at the rim of its base.
constexpr double kBlockedShare = 0.002;

} // namespace

std::vector<Piece> printOrder(std::vector<Piece> pieces, const PlanarOptions& options,
                              double spacingMm, std::size_t& blocked) {
  // Which piece holds the section of a tag besides the one that stands on it.
  std::map<std::int32_t, int> holds;
  for (std::size_t p = 0; p < pieces.size(); ++p)
    for (const std::int32_t tag : pieces[p].solid.tag)
      if (tag >= 0 && tag != pieces[p].baseTag)
        holds[tag] = static_cast<int>(p);
  std::vector<int> parent(pieces.size(), -1);
  std::vector<std::vector<Eigen::Vector3d>> samples;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    if (const auto at = holds.find(pieces[p].baseTag); at != holds.end())
      parent[p] = at->second;
    samples.push_back(surfaceSamples(pieces[p].solid.mesh, spacingMm));
  }
  std::vector<Eigen::Vector3d> printed = plateSamples(options.plate, spacingMm);
  std::vector<int> place(pieces.size(), -1); // in the order
  std::vector<std::size_t> order;
  blocked = 0;
  while (order.size() < pieces.size()) {
    double least = 2.0;
    std::size_t next = pieces.size();
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      if (place[p] >= 0 || (parent[p] >= 0 && place[static_cast<std::size_t>(parent[p])] < 0))
        continue;
      const double share = blockedShare(samples[p], printed, pieces[p].base.normal, options.head);
      if (share < least) {
        least = share;
        next = p;
      }
      if (share == 0.0)
        break;
    }
    if (next == pieces.size())
      break;
    blocked += least > kBlockedShare;
    place[next] = static_cast<int>(order.size());
    order.push_back(next);
    printed.insert(printed.end(), samples[next].begin(), samples[next].end());
  }
  std::vector<Piece> out;
  for (const std::size_t p : order) {
    out.push_back(std::move(pieces[p]));
    out.back().parent = parent[p] < 0 ? -1 : place[static_cast<std::size_t>(parent[p])];
  }
  return out;
}

} // namespace voluta::planar
