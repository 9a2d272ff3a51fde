#include "scene/actors.h"

#include "base/units.h"
#include "scene/mesh_buffers.h"

#include <cmath>
#include <cstring>
#include <vtkLight.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>

namespace voluta::scene {

namespace {

constexpr double kHaloOpacity = 0.35;

// A mapper stores time stamps on its input: each scene has a separate shell over the shared arrays.
vtkSmartPointer<vtkPolyData> shellOf(vtkPolyData* data) {
  auto shell = vtkSmartPointer<vtkPolyData>::New();
  if (data)
    shell->ShallowCopy(data);
  return shell;
}

} // namespace

RangeActor RangeActor::make(vtkRenderer* renderer) {
  RangeActor out;
  out.actor = vtkSmartPointer<vtkActor>::New();
  out.mapper = vtkSmartPointer<RangeMapper>::New();
  out.actor->SetMapper(out.mapper);
  giveSolidLook(out.actor);
  out.mapper->SetInputData(shellOf(nullptr));
  renderer->AddActor(out.actor);
  return out;
}

RangeActor RangeActor::halo(vtkRenderer* renderer) {
  RangeActor out = make(renderer);
  out.mapper->setThroughEverything(true);
  out.actor->GetProperty()->SetOpacity(kHaloOpacity);
  out.actor->ForceTranslucentOn();
  return out;
}

void RangeActor::setData(vtkPolyData* data) {
  mapper->SetInputData(shellOf(data));
}

void setColours(const RangeActor& shown, const std::vector<std::uint8_t>& rgb) {
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  colours->SetNumberOfTuples(static_cast<vtkIdType>(rgb.size() / 3));
  if (!rgb.empty())
    std::memcpy(colours->GetPointer(0), rgb.data(), rgb.size());
  shown.mapper->GetInput()->GetPointData()->SetScalars(colours);
}

vtkSmartPointer<vtkActor> addSolid(vtkRenderer* renderer) {
  auto actor = vtkSmartPointer<vtkActor>::New();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->ScalarVisibilityOff();
  mapper->SetInputData(shellOf(nullptr));
  actor->SetMapper(mapper);
  giveSolidLook(actor);
  renderer->AddActor(actor);
  return actor;
}

vtkSmartPointer<vtkActor> addLines(vtkRenderer* renderer) {
  auto actor = addSolid(renderer);
  actor->GetProperty()->LightingOff();
  return actor;
}

void setData(vtkActor* actor, vtkPolyData* data) {
  static_cast<vtkPolyDataMapper*>(actor->GetMapper())->SetInputData(shellOf(data));
}

void setColour(vtkActor* actor, const Colour& colour) {
  actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
}

void setPose(vtkActor* actor, const Eigen::Affine3d& world_T_model) {
  vtkNew<vtkMatrix4x4> matrix;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c)
      matrix->SetElement(r, c, world_T_model(r, c));
  actor->SetUserMatrix(matrix);
}

void giveSolidLook(vtkActor* actor) {
  vtkProperty* look = actor->GetProperty();
  look->SetAmbient(0.42);
  look->SetDiffuse(0.68);
  look->SetSpecular(0.06);
  look->SetSpecularPower(20.0);
}

void cutBy(vtkPlane* plane, const std::vector<vtkActor*>& actors) {
  for (vtkActor* actor : actors) {
    vtkMapper* mapper = actor->GetMapper();
    const bool isCut = mapper->GetClippingPlanes() != nullptr;
    if (plane && !isCut)
      mapper->AddClippingPlane(plane);
    else if (!plane && isCut)
      mapper->RemoveAllClippingPlanes();
  }
}

void addLights(vtkRenderer* renderer) {
  renderer->AutomaticLightCreationOff();
  const auto add = [&](double x, double y, double z, double intensity) {
    vtkNew<vtkLight> light;
    light->SetLightTypeToCameraLight();
    light->SetPosition(x, y, z);
    light->SetFocalPoint(0, 0, 0);
    light->SetIntensity(intensity);
    renderer->AddLight(light);
  };
  add(-0.40, 0.70, 1.0, 0.85);
  add(0.8, -0.15, 0.7, 0.25);
}

vtkSmartPointer<vtkPolyData> ring(double inner, double outer) {
  constexpr int kRingCorners = 48;
  MeshBuffers buffers;
  const auto corner = [&](int i, double radius) {
    const double angle = 2.0 * base::kPi * i / kRingCorners;
    return buffers.addPoint({radius * std::cos(angle), radius * std::sin(angle), 0.0},
                            Eigen::Vector3d::UnitZ());
  };
  for (int i = 0; i < kRingCorners; ++i)
    buffers.addQuad(corner(i, inner), corner(i, outer), corner(i + 1, outer), corner(i + 1, inner));
  return polyDataOf(buffers);
}

} // namespace voluta::scene
