#include "toolpath/plane/connected_parts.h"

namespace voluta::toolpath {

std::vector<ClipperLib::Paths> connectedParts(const ClipperLib::Paths& area) {
  ClipperLib::Clipper clipper;
  clipper.AddPaths(area, ClipperLib::ptSubject, true);
  ClipperLib::PolyTree tree;
  clipper.Execute(ClipperLib::ctUnion, tree, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
  std::vector<ClipperLib::Paths> parts;
  for (const ClipperLib::PolyNode* node = tree.GetFirst(); node != nullptr;
       node = node->GetNext()) {
    if (node->IsHole())
      continue;
    parts.push_back({node->Contour});
    for (const ClipperLib::PolyNode* hole : node->Childs)
      parts.back().push_back(hole->Contour);
  }
  return parts;
}

} // namespace voluta::toolpath
