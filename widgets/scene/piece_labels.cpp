#include "scene/piece_labels.h"

#include "base/units.h"
#include "scene/label_places.h"

#include <cmath>
#include <string>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

namespace voluta::scene {

namespace {

constexpr double kRadius = 9.5, kRim = 1.2, kSoft = 1.0; // logical pixels
constexpr double kMinRadius = 5.0;
constexpr int kFontPoints = 11, kCorners = 32;
constexpr double kFaded = 0.45; // opacity of the numbers of pieces that are not chosen

// Discs of concentric bands, the outermost fading out, so that they look round without
// multisampling. No two triangles overlap, because VTK does not define which of them would be
// visible.
class Discs {
public:
  Discs() {
    colours_->SetNumberOfComponents(4);
    data_->SetPoints(points_);
    data_->SetPolys(triangles_);
    data_->GetPointData()->SetScalars(colours_);
  }

  void add(const Eigen::Vector2d& centre, double ratio, const Colour& ground, const Colour& rim,
           double opacity) {
    struct Circle {
      double radius;
      Colour colour;
      double opacity;
    };
    const Circle circles[] = {{kRadius - kRim - 0.5 * kSoft, ground, opacity},
                              {kRadius - kRim + 0.5 * kSoft, rim, opacity},
                              {kRadius - 0.5 * kSoft, rim, opacity},
                              {kRadius + 0.5 * kSoft, rim, 0.0}};
    const vtkIdType middle = point(centre, ground, opacity);
    vtkIdType within = middle; // first point of the inner circle
    for (const Circle& circle : circles) {
      const vtkIdType first = points_->GetNumberOfPoints();
      for (int k = 0; k < kCorners; ++k) {
        const double angle = 2.0 * base::kPi * k / kCorners;
        point(centre + ratio * circle.radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)),
              circle.colour, circle.opacity);
      }
      for (int k = 0; k < kCorners; ++k) {
        const int next = (k + 1) % kCorners;
        if (within == middle) {
          triangle(middle, first + k, first + next);
        } else {
          triangle(within + k, first + k, first + next);
          triangle(within + k, first + next, within + next);
        }
      }
      within = first;
    }
  }
  vtkPolyData* data() const { return data_; }

private:
  vtkIdType point(const Eigen::Vector2d& at, const Colour& colour, double opacity) {
    for (const double c : colour)
      colours_->InsertNextValue(static_cast<unsigned char>(std::lround(255 * c)));
    colours_->InsertNextValue(static_cast<unsigned char>(std::lround(255 * opacity)));
    return points_->InsertNextPoint(at.x(), at.y(), 0.0);
  }
  void triangle(vtkIdType a, vtkIdType b, vtkIdType c) {
    const vtkIdType corners[] = {a, b, c};
    triangles_->InsertNextCell(3, corners);
  }

  vtkNew<vtkPolyData> data_;
  vtkNew<vtkPoints> points_;
  vtkNew<vtkCellArray> triangles_;
  vtkNew<vtkUnsignedCharArray> colours_;
};

// VTK also depth-tests overlays, all of which have the same depth: those drawn first would hide the
// rest. The discs do not write depth, so that the numbers appear on them.
class DepthlessActor : public vtkActor2D {
public:
  vtkTypeMacro(DepthlessActor, vtkActor2D);
  static DepthlessActor* New() { VTK_STANDARD_NEW_BODY(DepthlessActor); }

  int RenderOverlay(vtkViewport* viewport) override {
    vtkOpenGLState* state =
        static_cast<vtkOpenGLRenderWindow*>(viewport->GetVTKWindow())->GetState();
    const vtkOpenGLState::ScopedglEnableDisable kept(state, kDepthTest);
    state->vtkglDisable(kDepthTest);
    return vtkActor2D::RenderOverlay(viewport);
  }

private:
  static constexpr unsigned int kDepthTest = 0x0B71; // GL_DEPTH_TEST
};

Eigen::Matrix4d clipFromWorld(vtkRenderer* renderer) {
  const int* size = renderer->GetSize();
  const double aspect = size[1] > 0 ? static_cast<double>(size[0]) / size[1] : 1.0;
  const vtkMatrix4x4* m =
      renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(aspect, -1.0, 1.0);
  Eigen::Matrix4d out;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c)
      out(r, c) = m->GetElement(r, c);
  return out;
}

} // namespace

PieceLabels::PieceLabels(vtkRenderer* renderer)
    : renderer_(renderer), theme_(lightTheme()), discs_(vtkSmartPointer<DepthlessActor>::New()) {
  discs_->SetMapper(vtkSmartPointer<vtkPolyDataMapper2D>::New());
  renderer_->AddActor2D(discs_);
}

void PieceLabels::setDrawing(const PiecesDrawing* drawing) {
  drawing_ = drawing;
  found_.reset();
  places_.clear();
}

void PieceLabels::update(const ViewState& view, const Eigen::Isometry3d& world_T_work) {
  const bool on = drawing_ && view.pieces && view.pieceNumbers;
  discs_->SetVisibility(on);
  for (const auto& number : numbers_)
    number->SetVisibility(false);
  if (!on)
    return;
  while (numbers_.size() < drawing_->pieces.size())
    addNumber();
  std::vector<Eigen::Isometry3d> poses;
  for (const Eigen::Vector3d& offset : pieceOffsets(*drawing_, view.explodeMm))
    poses.push_back(world_T_work * Eigen::Translation3d(offset));
  find(view, poses, world_T_work);
  draw(view, poses);
}

void PieceLabels::addNumber() {
  auto number = vtkSmartPointer<vtkTextActor>::New();
  number->SetInput(std::to_string(numbers_.size() + 1).c_str());
  vtkTextProperty* look = number->GetTextProperty();
  look->SetFontFamilyToArial();
  look->BoldOn();
  look->SetJustificationToCentered();
  look->SetVerticalJustificationToCentered();
  renderer_->AddActor2D(number);
  numbers_.push_back(std::move(number));
}

void PieceLabels::find(const ViewState& view, const std::vector<Eigen::Isometry3d>& poses,
                       const Eigen::Isometry3d& world_T_work) {
  const int* size = renderer_->GetSize();
  const Found wanted{clipFromWorld(renderer_), size[0],           size[1],
                     view.explodeMm,           view.piece,        view.sectionOn,
                     view.sectionOrigin,       view.sectionNormal};
  if (found_ && (*found_ == wanted || view.dragging))
    return;
  found_ = wanted;
  LabelView picture;
  picture.clip_T_world = wanted.clip_T_world;
  picture.width = size[0];
  picture.height = size[1];
  picture.minRadius = kMinRadius * ratio_;
  picture.apart = 2.0 * kRadius * ratio_;
  if (view.sectionOn)
    picture.shown = [origin = (world_T_work * view.sectionOrigin).eval(),
                     normal = (world_T_work.linear() * view.sectionNormal).eval()](
                        const Eigen::Vector3d& p) { return (p - origin).dot(normal) <= 0.0; };
  std::vector<SeenBody> bodies;
  for (std::size_t i = 0; i < drawing_->pieces.size(); ++i)
    bodies.push_back({&drawing_->pieces[i].solid->mesh, poses[i], view.piece == i});
  places_ = labelPlaces(bodies, picture);
}

void PieceLabels::draw(const ViewState& view, const std::vector<Eigen::Isometry3d>& poses) {
  const Eigen::Matrix4d clip_T_world = clipFromWorld(renderer_);
  const int* size = renderer_->GetSize();
  const bool some = view.piece && *view.piece < poses.size();
  Discs discs;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (i >= places_.size() || !places_[i])
      continue;
    const Eigen::Vector4d clip = clip_T_world * (poses[i] * *places_[i]).homogeneous();
    if (clip.w() <= 0.0)
      continue;
    const Eigen::Vector2d at(std::round(0.5 * (clip.x() / clip.w() + 1.0) * size[0]),
                             std::round(0.5 * (clip.y() / clip.w() + 1.0) * size[1]));
    const bool chosen = some && *view.piece == i;
    const double opacity = some && !chosen ? kFaded : 1.0;
    Colour ground = chosen ? theme_.text : theme_.backgroundBottom;
    Colour ink = chosen ? theme_.backgroundBottom : theme_.text;
    discs.add(at, ratio_, ground, ink, opacity);
    vtkTextActor* number = numbers_[i];
    number->SetVisibility(true);
    number->SetPosition(at.x(), at.y());
    vtkTextProperty* look = number->GetTextProperty();
    look->SetColor(ink.data());
    look->SetOpacity(opacity);
    look->SetFontSize(static_cast<int>(std::lround(kFontPoints * ratio_)));
  }
  static_cast<vtkPolyDataMapper2D*>(discs_->GetMapper())->SetInputData(discs.data());
}

std::vector<int> PieceLabels::shown() const {
  std::vector<int> numbers;
  for (std::size_t i = 0; i < numbers_.size(); ++i)
    if (numbers_[i]->GetVisibility())
      numbers.push_back(static_cast<int>(i) + 1);
  return numbers;
}

} // namespace voluta::scene
