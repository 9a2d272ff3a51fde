#include "cad_bodies.h"

#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <TCollection_AsciiString.hxx>
#include <TDF_Label.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopAbs_ShapeEnum.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Solid.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

namespace voluta::cad_reader {

namespace {

constexpr double kSewMm = 0.01; // as far apart as edges of neighbouring faces may be
constexpr int kMaxDepth = 64;   // of assemblies

std::string nameOf(const TDF_Label& label) {
  opencascade::handle<TDataStd_Name> name;
  if (!label.FindAttribute(TDataStd_Name::GetID(), name))
    return {};
  const TCollection_ExtendedString& text = name->Get();
  std::string bytes(static_cast<std::size_t>(text.LengthOfCString()) + 1, '\0');
  Standard_PCharacter to = bytes.data();
  text.ToUTF8CString(to);
  bytes.resize(static_cast<std::size_t>(text.LengthOfCString()));
  // Names that Open CASCADE gives to products without one.
  for (const char* made : {"Open CASCADE STEP translator", "Open CASCADE IGES translator", "SOLID",
                           "COMPOUND", "SHELL", "Shape"})
    if (bytes.rfind(made, 0) == 0)
      return {};
  return bytes;
}

// Returns the shells of the faces that belong to no solid; closed ones as solids.
std::vector<TopoDS_Shape> sewn(const std::vector<TopoDS_Shape>& faces) {
  BRepBuilderAPI_Sewing sewing(kSewMm);
  for (const TopoDS_Shape& face : faces)
    sewing.Add(face);
  sewing.Perform();
  std::vector<TopoDS_Shape> made;
  for (TopExp_Explorer shells(sewing.SewedShape(), TopAbs_SHELL); shells.More(); shells.Next())
    made.push_back(shells.Current());
  for (TopExp_Explorer single(sewing.SewedShape(), TopAbs_FACE, TopAbs_SHELL); single.More();
       single.Next())
    made.push_back(single.Current());
  return made;
}

// Outward facing, if it is closed.
TopoDS_Shape oriented(const TopoDS_Shape& shape) {
  TopoDS_Solid solid;
  if (shape.ShapeType() == TopAbs_SHELL && shape.Closed())
    BRep_Builder().MakeSolid(solid), BRep_Builder().Add(solid, shape);
  else if (shape.ShapeType() == TopAbs_SOLID)
    solid = TopoDS::Solid(shape);
  else
    return shape;
  BRepLib::OrientClosedSolid(solid);
  return solid;
}

// Appends the bodies of a shape that is no assembly.
void appendBodies(const TopoDS_Shape& shape, const std::string& name, std::vector<Body>& bodies,
                  Omitted& omitted) {
  std::vector<TopoDS_Shape> made, loose;
  for (TopExp_Explorer solids(shape, TopAbs_SOLID); solids.More(); solids.Next())
    made.push_back(oriented(solids.Current()));
  for (TopExp_Explorer faces(shape, TopAbs_FACE, TopAbs_SOLID); faces.More(); faces.Next())
    loose.push_back(faces.Current());
  for (TopExp_Explorer edges(shape, TopAbs_EDGE, TopAbs_FACE); edges.More(); edges.Next())
    ++omitted.curves;
  if (!loose.empty())
    for (const TopoDS_Shape& shell : sewn(loose))
      made.push_back(oriented(shell));
  for (std::size_t i = 0; i < made.size(); ++i)
    bodies.push_back(
        {name.empty() || made.size() == 1 ? name : name + " " + std::to_string(i + 1), made[i]});
}

void appendLabel(const TDF_Label& label, const TopLoc_Location& place, int depth,
                 std::vector<Body>& bodies, Omitted& omitted) {
  if (depth > kMaxDepth)
    return;
  TDF_Label of = label;
  const TopLoc_Location here = place * XCAFDoc_ShapeTool::GetLocation(label);
  if (XCAFDoc_ShapeTool::IsReference(label))
    XCAFDoc_ShapeTool::GetReferredShape(label, of);
  if (TDF_LabelSequence parts; XCAFDoc_ShapeTool::IsAssembly(of)) {
    XCAFDoc_ShapeTool::GetComponents(of, parts, false);
    for (const TDF_Label& part : parts)
      appendLabel(part, here, depth + 1, bodies, omitted);
    return;
  }
  TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(of);
  if (shape.IsNull())
    return;
  shape.Location(of == label ? place * shape.Location() : here);
  const std::string product = nameOf(of);
  appendBodies(shape, product.empty() ? nameOf(label) : product, bodies, omitted);
}

} // namespace

std::vector<Body> bodiesOf(const opencascade::handle<TDocStd_Document>& document,
                           Omitted& omitted) {
  std::vector<Body> bodies;
  TDF_LabelSequence roots;
  XCAFDoc_DocumentTool::ShapeTool(document->Main())->GetFreeShapes(roots);
  for (const TDF_Label& root : roots)
    appendLabel(root, {}, 0, bodies, omitted);
  return bodies;
}

} // namespace voluta::cad_reader
