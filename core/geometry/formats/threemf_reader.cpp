// 3MF core specification 1.3 with its extensions for paths, beam lattices and slices. Not read by
// assimp 5.2, whose asserts abort the program on damaged files.
#include "geometry/formats/facet_soup.h"
#include "geometry/formats/threemf_build.h"

namespace voluta::geometry {

FacetSoup soupOf(const ThreemfBuild& build) {
  FacetSoup soup;
  soup.format = "3MF";
  soup.repairs = build.notes;
  for (const ThreemfPiece& piece : build.pieces)
    appendPlaced(piece, piece.mm_T_object, soup.facets);
  return soup;
}

FacetSoup read3mf(std::string_view bytes, const std::string& name) {
  const ThreemfBuild build = read3mfBuild(bytes, name);
  FacetSoup soup = soupOf(build);
  soup.repairs.insert(soup.repairs.end(), build.modifierNotes.begin(), build.modifierNotes.end());
  return soup;
}

} // namespace voluta::geometry
