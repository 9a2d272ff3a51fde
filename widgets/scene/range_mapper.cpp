#include "scene/range_mapper.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLIndexBufferObject.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkPolyData.h>
#include <vtkRenderer.h>
#include <vtkShaderProgram.h>
#include <vtkShaderProperty.h>
#include <vtkTypeInt32Array.h>
#include <vtk_glew.h>

namespace voluta::scene {

vtkStandardNewMacro(RangeMapper);

void appendStretch(std::vector<Stretch>& stretches, const Stretch& next) {
  if (next.count == 0)
    return;
  if (!stretches.empty()) {
    Stretch& last = stretches.back();
    if (last.first + last.count == next.first && last.plain == next.plain) {
      last.count += next.count;
      return;
    }
  }
  stretches.push_back(next);
}

void RangeMapper::RenderPieceDraw(vtkRenderer* renderer, vtkActor* actor) {
  auto* window = static_cast<vtkOpenGLRenderWindow*>(renderer->GetRenderWindow());
  if (throughEverything_)
    window->GetState()->vtkglDisable(GL_DEPTH_TEST);
  for (const int type : {PrimitiveLines, PrimitiveTris}) {
    vtkOpenGLHelper& primitive = Primitives[type];
    const std::size_t total = primitive.IBO->IndexCount;
    if (total == 0 || stretches_.empty())
      continue;
    DrawingVertices = false;
    const GLenum mode = type == PrimitiveLines ? GL_LINES : GL_TRIANGLES;
    const std::size_t corners = type == PrimitiveLines ? 2 : 3;
    UpdateShaders(primitive, renderer, actor);
    primitive.IBO->Bind();
    for (const bool plain : {false, true}) {
      std::vector<GLsizei> counts;
      std::vector<const void*> offsets;
      for (const Stretch& s : stretches_) {
        if (s.plain != plain || (s.first + s.count) * corners > total)
          continue;
        counts.push_back(static_cast<GLsizei>(s.count * corners));
        offsets.push_back(reinterpret_cast<const void*>(s.first * corners * sizeof(unsigned int)));
      }
      if (counts.empty())
        continue;
      if (primitive.Program->IsUniformUsed("plainShare")) {
        const float colour[3] = {static_cast<float>(plainColour_[0]),
                                 static_cast<float>(plainColour_[1]),
                                 static_cast<float>(plainColour_[2])};
        primitive.Program->SetUniformf("plainShare", plain ? 1.0f : 0.0f);
        primitive.Program->SetUniform3f("plainColour", colour);
      }
      glMultiDrawElements(mode, counts.data(), GL_UNSIGNED_INT, offsets.data(),
                          static_cast<GLsizei>(counts.size()));
    }
    primitive.IBO->Release();
  }
  if (throughEverything_)
    window->GetState()->vtkglEnable(GL_DEPTH_TEST);
}

// VTK's implementation omits triangles with coincident corners, but stretches count all of them.
void RangeMapper::BuildIBO(vtkRenderer*, vtkActor*, vtkPolyData* data) {
  const auto upload = [&](PrimitiveTypes type, vtkCellArray* cells) {
    vtkOpenGLIndexBufferObject* buffer = Primitives[type].IBO;
    buffer->IndexCount = 0;
    if (cells == nullptr || cells->GetNumberOfCells() == 0)
      return;
    vtkTypeInt32Array* corners = cells->GetConnectivityArray32();
    buffer->IndexCount = static_cast<std::size_t>(corners->GetNumberOfValues());
    buffer->Upload(reinterpret_cast<const unsigned int*>(corners->GetPointer(0)),
                   buffer->IndexCount, vtkOpenGLBufferObject::ElementArrayBuffer);
  };
  upload(PrimitiveLines, data->GetLines());
  upload(PrimitiveTris, data->GetPolys());
}

void addPlainColour(vtkActor* actor) {
  vtkShaderProperty* shader = actor->GetShaderProperty();
  shader->AddFragmentShaderReplacement("//VTK::Color::Dec", true,
                                       "//VTK::Color::Dec\n"
                                       "uniform float plainShare;\n"
                                       "uniform vec3 plainColour;\n",
                                       false);
  shader->AddFragmentShaderReplacement(
      "//VTK::Light::Impl", true,
      "  ambientColor = mix(ambientColor, ambientIntensity * plainColour, plainShare);\n"
      "  diffuseColor = mix(diffuseColor, diffuseIntensity * plainColour, plainShare);\n"
      "//VTK::Light::Impl\n",
      false);
}

} // namespace voluta::scene
