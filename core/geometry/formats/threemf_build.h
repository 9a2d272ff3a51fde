// Everything that a 3MF package builds: its meshes, one at each use.
#pragma once

#include "base/text.h"
#include "geometry/formats/facet_soup.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::geometry {

// A mesh of an object at one of its uses.
struct ThreemfPiece {
  std::size_t item = 0;       // index of the build item, of those that are printed
  std::string name, itemName; // of the object, and of the build item's; empty: none
  std::vector<Facet> facets;  // in the object's coordinates; not empty
  Eigen::Affine3d mm_T_object = Eigen::Affine3d::Identity();
};

// Appends the facets moved by `mm_T_object`; a mirrored piece is reversed, as it would be inside
// out.
void appendPlaced(const ThreemfPiece& piece, const Eigen::Affine3d& mm_T_object,
                  std::vector<Facet>& facets);

struct ThreemfBuild {
  std::vector<ThreemfPiece> pieces; // in the order of the build
  std::vector<base::Message> notes; // omitted or changed content, a sentence each
};

// Throws as read3mf().
ThreemfBuild read3mfBuild(std::string_view bytes, const std::string& name);

} // namespace voluta::geometry
