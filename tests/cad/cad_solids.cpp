#include "cad_solids.h"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepGProp.hxx>
#include <BRepOffsetAPI_MakeThickSolid.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <IGESCAFControl_Writer.hxx>
#include <IGESControl_Controller.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPControl_Writer.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <numbers>
#include <stdexcept>

namespace voluta::test {

namespace {

using Document = opencascade::handle<TDocStd_Document>;

TopoDS_Shape moved(const TopoDS_Shape& shape, const gp_Vec& shift) {
  gp_Trsf move;
  move.SetTranslation(shift);
  return shape.Moved(TopLoc_Location(move));
}

TopoDS_Shape cylinder(double x, double y, double radiusMm, double heightMm) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, y, 0), gp::DZ()), radiusMm, heightMm).Shape();
}

// An assembly of one component for each solid. Equal shapes are uses of one product.
Document documentOf(const std::vector<CadSolid>& solids) {
  Document document;
  XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", document);
  const auto shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  if (solids.size() == 1) {
    const TDF_Label label = shapes->AddShape(solids.front().shape, false);
    TDataStd_Name::Set(label, solids.front().name.c_str());
    return document;
  }
  const TDF_Label assembly = shapes->NewShape();
  TDataStd_Name::Set(assembly, "assembly");
  for (const CadSolid& solid : solids) {
    const TopoDS_Shape product = solid.shape.Located({});
    TDF_Label label;
    if (!shapes->FindShape(product, label)) {
      label = shapes->AddShape(product, false);
      TDataStd_Name::Set(label, solid.name.c_str());
    }
    shapes->AddComponent(assembly, label, solid.shape.Location());
  }
  shapes->UpdateAssemblies();
  return document;
}

void require(bool done, const std::filesystem::path& file) {
  if (!done)
    throw std::runtime_error("cannot write " + file.string());
}

} // namespace

CadSolid boxWithHoles() {
  TopoDS_Shape shape = BRepPrimAPI_MakeBox(40.0, 30.0, 20.0).Shape();
  shape = BRepAlgoAPI_Cut(shape, cylinder(12, 15, 5, 20)).Shape();
  shape = BRepAlgoAPI_Cut(shape, cylinder(30, 15, 3, 20)).Shape();
  return {"box with holes", shape};
}

CadSolid bentPipe() {
  const auto bend = [](double radiusMm) {
    return BRepPrimAPI_MakeTorus(30.0, radiusMm, std::numbers::pi / 2.0).Shape();
  };
  return {"bent pipe", BRepAlgoAPI_Cut(bend(10.0), bend(8.0)).Shape()};
}

CadSolid blendedBlock() {
  const TopoDS_Shape block = BRepPrimAPI_MakeBox(30.0, 20.0, 15.0).Shape();
  BRepFilletAPI_MakeFillet fillet(block);
  for (TopExp_Explorer edges(block, TopAbs_EDGE); edges.More(); edges.Next())
    fillet.Add(4.0, TopoDS::Edge(edges.Current()));
  return {"blended block", fillet.Shape()};
}

CadSolid thinShell() {
  BRepPrimAPI_MakeCylinder full(12.0, 30.0);
  TopTools_ListOfShape open;
  open.Append(full.Cylinder().TopFace());
  BRepOffsetAPI_MakeThickSolid hollow;
  hollow.MakeThickSolidByJoin(full.Shape(), open, -1.2, 1e-3);
  return {"thin shell", hollow.Shape()};
}

std::vector<CadSolid> assemblySolids() {
  const TopoDS_Shape pin = BRepPrimAPI_MakeCylinder(4.0, 18.0).Shape();
  return {{"base", moved(BRepPrimAPI_MakeBox(40.0, 30.0, 8.0).Shape(), {0, 0, 0})},
          {"lid", moved(BRepPrimAPI_MakeBox(20.0, 30.0, 6.0).Shape(), {50, 0, 0})},
          {"pin", moved(pin, {90, 5, 0})},
          {"pin", moved(pin, {90, 25, 0})}};
}

double volumeMm3(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties);
  return properties.Mass();
}

void writeCad(const std::vector<CadSolid>& solids, CadFormat format, const std::string& unit,
              const std::filesystem::path& file) {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  STEPCAFControl_Controller::Init();
  IGESControl_Controller::Init();
  const Document document = documentOf(solids);
  if (format == CadFormat::Step) {
    Interface_Static::SetCVal("write.step.unit", unit.c_str());
    STEPCAFControl_Writer writer;
    require(writer.Transfer(document) && writer.Write(file.c_str()) == IFSelect_RetDone, file);
    return;
  }
  Interface_Static::SetIVal("write.iges.brep.mode", format == CadFormat::Iges ? 1 : 0);
  Interface_Static::SetCVal("write.iges.unit", unit.c_str());
  IGESCAFControl_Writer writer;
  require(writer.Perform(document, file.c_str()), file);
}

void writeCurves(const std::filesystem::path& file) {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  STEPControl_Writer writer;
  const TopoDS_Shape circle =
      BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(gp::Origin(), gp::DZ()), 10.0)).Shape();
  writer.Transfer(circle, STEPControl_AsIs);
  require(writer.Write(file.c_str()) == IFSelect_RetDone, file);
}

} // namespace voluta::test
