#include "cad_facets.h"

#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <TopAbs_Orientation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Trsf.hxx>

namespace voluta::cad_reader {

namespace {

bool isSame(const gp_XYZ& a, const gp_XYZ& b) {
  return a.X() == b.X() && a.Y() == b.Y() && a.Z() == b.Z();
}

// Appends the facets of a face in the coordinates of its body.
void append(const TopoDS_Face& face, std::vector<double>& corners, Omitted& omitted) {
  TopLoc_Location location;
  const opencascade::handle<Poly_Triangulation> mesh = BRep_Tool::Triangulation(face, location);
  if (mesh.IsNull() || mesh->NbTriangles() == 0) {
    ++omitted.faces;
    return;
  }
  const gp_Trsf moved = location.Transformation();
  const bool reversed = (face.Orientation() == TopAbs_REVERSED) != moved.IsNegative();
  for (int t = 1; t <= mesh->NbTriangles(); ++t) {
    std::array<int, 3> nodes{};
    mesh->Triangle(t).Get(nodes[0], nodes[1], nodes[2]);
    if (reversed)
      std::swap(nodes[1], nodes[2]);
    const std::array<gp_XYZ, 3> points{mesh->Node(nodes[0]).XYZ(), mesh->Node(nodes[1]).XYZ(),
                                       mesh->Node(nodes[2]).XYZ()};
    // At a pole of a surface an edge of its parameters has no length.
    if (isSame(points[0], points[1]) || isSame(points[1], points[2]) ||
        isSame(points[2], points[0]))
      continue;
    for (gp_XYZ p : points) {
      moved.Transforms(p);
      corners.insert(corners.end(), {p.X(), p.Y(), p.Z()});
    }
  }
}

} // namespace

BodyFacets facetsOf(const Body& body, double chordMm, double angleRad, Omitted& omitted) {
  const TopLoc_Location use = body.shape.Location();
  // Uses that differ by a translation have equal facets.
  gp_Trsf rotation = use.Transformation();
  const gp_XYZ place = rotation.TranslationPart();
  rotation.SetTranslationPart(gp_Vec(0.0, 0.0, 0.0));
  BodyFacets facets{body.name, {place.X(), place.Y(), place.Z()}, {}};
  const TopoDS_Shape shape = body.shape.Located(TopLoc_Location(rotation));
  const BRepMesh_IncrementalMesh mesh(shape, chordMm, false, angleRad, false);
  for (TopExp_Explorer faces(shape, TopAbs_FACE); faces.More(); faces.Next())
    append(TopoDS::Face(faces.Current()), facets.corners, omitted);
  return facets;
}

} // namespace voluta::cad_reader
