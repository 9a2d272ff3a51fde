// The bodies of a CAD document: solids, and surfaces that form none.
#pragma once

#include <Standard_Handle.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Shape.hxx>
#include <cstddef>
#include <string>
#include <vector>

class TDocStd_Document;

namespace voluta::cad_reader {

struct Body {
  std::string name; // of its product, numbered if the product has several; empty: none
  TopoDS_Shape shape;
};

// Content of a file that its bodies lack.
struct Omitted {
  std::size_t faces = 0;  // without facets
  std::size_t curves = 0; // edges of no face
};

// Returns each use of each solid, in its place in the file, and the faces of no solid, sewn.
// Lengths are in mm.
std::vector<Body> bodiesOf(const opencascade::handle<TDocStd_Document>& document, Omitted& omitted);

} // namespace voluta::cad_reader
