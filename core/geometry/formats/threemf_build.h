// Everything that a 3MF package builds: its meshes, one at each use.
#pragma once

#include "base/text.h"
#include "geometry/formats/facet_soup.h"
#include "geometry/formats/threemf_heights.h"
#include "geometry/formats/threemf_settings.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::geometry {

// A mesh of an object at one of its uses, or a volume of it that is not solid.
struct ThreemfPiece {
  std::size_t item = 0;       // index of the build item, of those that are printed
  std::string name, itemName; // of the object or volume, and of the build item's; empty: none
  std::vector<Facet> facets;  // in the object's coordinates; not empty
  // Numbers of facets up to the end of each volume of the object; the last is that of all facets.
  std::vector<std::size_t> volumeEnds;
  ThreemfVolumeKind kind = ThreemfVolumeKind::Part;
  Eigen::Affine3d mm_T_object = Eigen::Affine3d::Identity();
  Eigen::Affine3d item_T_object = Eigen::Affine3d::Identity(); // in the model's unit
  // Of a modifier, with an extruder other than the object's; of enforcers, blockers and paint as
  // ModifierOfFile::settings.
  ThreemfValues settings;
  bool isPainted = false; // the facets are a surface
};

// Appends the facets moved by `mm_T_object`; a mirrored piece is reversed, as it would be inside
// out.
void appendPlaced(const ThreemfPiece& piece, const Eigen::Affine3d& mm_T_object,
                  std::vector<Facet>& facets);

struct ThreemfBuild {
  std::vector<ThreemfPiece> pieces;    // in the order of the build; negative volumes are cut away
  std::vector<ThreemfPiece> modifiers; // with enforcers and blockers of supports, paint at the end
  std::map<std::size_t, std::vector<ThreemfRange>> ranges; // by item, of those that have any
  std::vector<EventOfFile> events;
  std::vector<base::Message> notes; // omitted or changed content, a sentence each
  // For readers that leave out modifiers, ranges and events.
  std::vector<base::Message> modifierNotes;
};

// Returns everything that is built as one, without modifiers, ranges and events.
FacetSoup soupOf(const ThreemfBuild& build);

// Throws as read3mf().
ThreemfBuild read3mfBuild(std::string_view bytes, const std::string& name);

} // namespace voluta::geometry
