#include "pictures/all_items.h"

#include "geometry/append_mesh.h"
#include "planar/planar_decomposition.h"

#include <algorithm>

namespace voluta::pictures {

std::shared_ptr<const geometry::TriangleMesh> partsOf(const project::Job& job) {
  if (job.items.size() == 1)
    return job.item().part;
  auto all = std::make_shared<geometry::TriangleMesh>();
  for (const project::JobItem& item : job.items) {
    if (!item.part)
      return nullptr;
    geometry::appendMesh(*all, *item.part);
  }
  return all;
}

std::shared_ptr<const layers::LayerStack> layersOf(const project::Job& job) {
  std::vector<std::shared_ptr<const layers::LayerStack>> stacks;
  for (const project::JobItem& item : job.items) {
    if (!item.layers)
      return nullptr;
    stacks.push_back(item.layers);
  }
  return layers::joinStacks(stacks, job.choices.printOrder);
}

std::vector<planar::Piece> piecesOf(const project::Job& job) {
  std::vector<planar::Piece> all;
  for (const project::JobItem& item : job.items) {
    const project::Pieces pieces = item.pieces();
    if (!pieces)
      continue;
    const int before = static_cast<int>(all.size());
    for (planar::Piece piece : pieces->pieces) {
      if (piece.parent >= 0)
        piece.parent += before;
      for (int& under : piece.under)
        under += under >= 0 ? before : 0;
      all.push_back(std::move(piece));
    }
  }
  return all;
}

std::optional<std::size_t> itemWithVoxels(const project::Job& job) {
  const auto found = std::ranges::find_if(
      job.items, [](const project::JobItem& item) { return item.decomposition() != nullptr; });
  return found == job.items.end()
             ? std::nullopt
             : std::optional(static_cast<std::size_t>(found - job.items.begin()));
}

} // namespace voluta::pictures
