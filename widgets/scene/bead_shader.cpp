#include "scene/bead_shader.h"

#include "scene/range_mapper.h"

#include <vtkActor.h>
#include <vtkDataObject.h>
#include <vtkOpenGLVertexBufferObject.h>
#include <vtkShaderProperty.h>
#include <vtkUniforms.h>

namespace voluta::scene {

namespace {

constexpr const char* kVertexDeclarations = R"(//VTK::PositionVC::Dec
in vec3 beadTangent;
in vec3 beadDirection;
in vec3 beadShape;
in vec3 beadOpen;
uniform int cameraParallel;
out vec3 beadRim;
out vec3 beadFront;
out float beadSide;
)";

// In coordinates in which the ellipse is a unit circle, the silhouette is perpendicular to the
// eye's direction.
constexpr const char* kVertexCode = R"(
  vec3 sideways = normalize(cross(beadTangent, beadDirection));
  vec3 upwards = cross(sideways, beadTangent);
  vec3 toEye = cameraParallel != 0
      ? vec3(MCVCMatrix[0][2], MCVCMatrix[1][2], MCVCMatrix[2][2])
      : -transpose(mat3(MCVCMatrix)) * MCVCMatrix[3].xyz - vertexMC.xyz;
  vec2 halves = vec2(beadScale, beadHeightScale) * beadShape.xy;
  vec2 eye = vec2(dot(toEye, sideways), dot(toEye, upwards)) / halves;
  float far = length(eye);
  eye = far > 1e-6 ? eye / far : vec2(0.0, 1.0);
  vec2 rim = vec2(-eye.y, eye.x);
  vec2 rimNormal = rim / beadShape.xy, eyeNormal = eye / beadShape.xy;
  beadRim = mat3(MCVCMatrix) * (rimNormal.x * sideways + rimNormal.y * upwards);
  beadFront = mat3(MCVCMatrix) * (eyeNormal.x * sideways + eyeNormal.y * upwards);
  beadSide = beadShape.z;
  bool away = hideBack != 0 && dot(beadOpen, toEye) < -0.3 * length(toEye);
  rim *= away ? vec2(0.0) : halves * beadSide;
  rim.y -= beadSink * beadShape.y;
  vec4 placed = vec4(vertexMC.xyz + rim.x * sideways + rim.y * upwards, 1.0);
  vertexVCVSOutput = MCVCMatrix * placed;
  gl_Position = MCDCMatrix * placed;
)";

constexpr const char* kFragmentDeclarations = R"(//VTK::Normal::Dec
in vec3 beadRim;
in vec3 beadFront;
in float beadSide;
)";

// Slightly flatter than round: completely dark rims would appear as specks on small beads.
constexpr const char* kFragmentCode = R"(
  vec3 normalVCVSOutput = normalize(
      0.8 * beadSide * beadRim + sqrt(max(0.0, 1.0 - 0.64 * beadSide * beadSide)) * beadFront);
)";

} // namespace

void drawAsBeads(vtkActor* actor, RangeMapper* mapper) {
  // The shader works in model coordinates.
  mapper->SetVBOShiftScaleMethod(vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE);
  for (const char* name : {"beadTangent", "beadDirection", "beadShape", "beadOpen"})
    mapper->MapDataArrayToVertexAttribute(name, name, vtkDataObject::FIELD_ASSOCIATION_POINTS, -1);
  vtkShaderProperty* shader = actor->GetShaderProperty();
  shader->AddVertexShaderReplacement("//VTK::PositionVC::Dec", true, kVertexDeclarations, false);
  shader->AddVertexShaderReplacement("//VTK::PositionVC::Impl", true, kVertexCode, false);
  shader->AddFragmentShaderReplacement("//VTK::Normal::Dec", true, kFragmentDeclarations, false);
  shader->AddFragmentShaderReplacement("//VTK::Normal::Impl", true, kFragmentCode, false);
  setBeadScale(actor, 1.0, 1.0);
  setBackBeadsHidden(actor, false);
}

void setBeadScale(vtkActor* actor, double width, double height) {
  vtkUniforms* uniforms = actor->GetShaderProperty()->GetVertexCustomUniforms();
  uniforms->SetUniformf("beadScale", static_cast<float>(width));
  uniforms->SetUniformf("beadHeightScale", static_cast<float>(height));
  uniforms->SetUniformf("beadSink", static_cast<float>((height - width) / kBeadFuller[1]));
}

void setBackBeadsHidden(vtkActor* actor, bool hidden) {
  actor->GetShaderProperty()->GetVertexCustomUniforms()->SetUniformi("hideBack", hidden ? 1 : 0);
}

} // namespace voluta::scene
