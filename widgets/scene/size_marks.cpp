#include "scene/size_marks.h"

#include "scene/actors.h"
#include "scene/camera.h"
#include "scene/mesh_buffers.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <vtkProperty.h>
#include <vtkTextProperty.h>

namespace voluta::scene {

namespace {
constexpr double kBracketShare = 0.18; // of an edge of the box, at each of its ends
constexpr double kBesidePixels = 16.0;
constexpr int kFontPixels = 12;
constexpr float kBracketPixels = 1.5F;
constexpr double kGapPixels = 3.0;   // between labels
constexpr double kLabelGround = 0.7; // opacity

Eigen::Vector3d cornerOf(const Eigen::AlignedBox3d& box, int corner) {
  return box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
}
} // namespace

SizeMarks::SizeMarks(vtkRenderer* renderer) : renderer_(renderer), brackets_(addLines(renderer)) {
  brackets_->GetProperty()->SetLineWidth(kBracketPixels);
  brackets_->PickableOff();
  brackets_->VisibilityOff();
  for (auto& label : labels_) {
    label = vtkSmartPointer<vtkTextActor>::New();
    vtkTextProperty* text = label->GetTextProperty();
    text->SetFontFamilyToArial();
    text->SetJustificationToCentered();
    text->SetVerticalJustificationToCentered();
    text->SetBackgroundOpacity(kLabelGround);
    text->BoldOn();
    label->VisibilityOff();
    renderer->AddActor2D(label);
  }
}

void SizeMarks::setTheme(const Theme& theme) {
  setColour(brackets_, theme.text);
  const std::array<Colour, kLabels> colours{theme.text, theme.text, theme.text, theme.platformEdges,
                                            theme.platformEdges};
  for (std::size_t i = 0; i < kLabels; ++i) {
    vtkTextProperty* text = labels_[i]->GetTextProperty();
    text->SetColor(colours[i][0], colours[i][1], colours[i][2]);
    text->SetBackgroundColor(theme.backgroundBottom[0], theme.backgroundBottom[1],
                             theme.backgroundBottom[2]);
  }
}

void SizeMarks::show(const Eigen::AlignedBox3d& part, const std::vector<Eigen::Vector2d>& plate,
                     const Eigen::Isometry3d& world_T_work) {
  part_ = part;
  plate_ = plate;
  world_T_work_ = world_T_work;
  const bool hasPart = !part_.isEmpty();
  brackets_->SetVisibility(hasPart);
  for (std::size_t axis = 0; axis < 3; ++axis)
    labels_[axis]->SetVisibility(hasPart);
  labels_[kPlate]->SetVisibility(!plate_.empty());
  // Below the part, the origin is not to be seen.
  const bool covered = hasPart && (part_.min().head<2>().array() <= 0.0).all() &&
                       (part_.max().head<2>().array() >= 0.0).all();
  labels_[kOrigin]->SetVisibility(!plate_.empty() && !covered);
  if (hasPart) {
    drawBrackets();
    setPose(brackets_, world_T_work_);
    constexpr const char* kAxes[] = {"X", "Y", "Z"};
    for (std::size_t axis = 0; axis < 3; ++axis)
      labels_[axis]->SetInput(
          fmt::format("{} {:.1f} mm", kAxes[axis], part_.sizes()[static_cast<int>(axis)]).c_str());
  }
  if (plate_.empty())
    return;
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& p : plate_)
    box.extend(p);
  labels_[kPlate]->SetInput(
      fmt::format("{:.0f} \u00d7 {:.0f} mm", box.sizes().x(), box.sizes().y()).c_str());
  labels_[kOrigin]->SetInput("0, 0");
}

// Draws the corners of the box: its edges through the part would hide the part.
void SizeMarks::drawBrackets() {
  MeshBuffers lines;
  for (int corner = 0; corner < 8; ++corner)
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d from = cornerOf(part_, corner),
                            to = cornerOf(part_, corner ^ 1 << axis);
      lines.addLine(from, from + kBracketShare * (to - from));
    }
  setData(brackets_, polyDataOf(lines));
}

Eigen::Vector2d SizeMarks::onScreen(const Eigen::Vector3d& inWork) const {
  const Eigen::Vector3d world = world_T_work_ * inWork;
  renderer_->SetWorldPoint(world.x(), world.y(), world.z(), 1.0);
  renderer_->WorldToDisplay();
  double display[3];
  renderer_->GetDisplayPoint(display);
  return {display[0], display[1]};
}

void SizeMarks::place(std::size_t label, const Eigen::Vector3d& at, const Eigen::Vector3d& from) {
  const Eigen::Vector2d shown = onScreen(at), away = shown - onScreen(from);
  vtkTextProperty* text = labels_[label]->GetTextProperty();
  text->SetFontSize(static_cast<int>(std::lround(kFontPixels * ratio_)));
  double size[2] = {0.0, 0.0};
  labels_[label]->GetSize(renderer_, size);
  const Eigen::Vector2d half(0.5 * size[0], 0.5 * size[1]);
  const Eigen::Vector2d unit =
      away.norm() > 1.0 ? (away / away.norm()).eval() : Eigen::Vector2d(0.0, -1.0);
  // So far that the label's box clears the place in that direction.
  const double reach = std::abs(unit.x()) * half.x() + std::abs(unit.y()) * half.y();
  const Eigen::Vector2d centre = shown + (reach + 0.4 * kBesidePixels * ratio_) * unit;
  putAt(label, centre, half);
}

void SizeMarks::putAt(std::size_t label, const Eigen::Vector2d& centre,
                      const Eigen::Vector2d& half) {
  labels_[label]->SetPosition(centre.x(), centre.y());
  areas_[label] = {centre - half, centre + half};
}

// At a small part the labels of its edges are beside the same place.
void SizeMarks::separate() {
  const double gap = kGapPixels * ratio_;
  for (std::size_t i = 1; i < kLabels; ++i)
    for (std::size_t tries = 0, j = 0; j < i && tries < 2 * kLabels; ++j) {
      if (!labels_[i]->GetVisibility() || !labels_[j]->GetVisibility())
        continue;
      const Eigen::Vector2d apart = areas_[i].center() - areas_[j].center();
      const Eigen::Vector2d missing = 0.5 * (areas_[i].sizes() + areas_[j].sizes()) +
                                      Eigen::Vector2d::Constant(gap) - apart.cwiseAbs();
      if (missing.minCoeff() <= 1e-6)
        continue;
      const int axis = missing.x() < missing.y() ? 0 : 1;
      Eigen::Vector2d centre = areas_[i].center();
      centre[axis] += std::copysign(missing[axis], apart[axis]);
      putAt(i, centre, 0.5 * areas_[i].sizes());
      j = static_cast<std::size_t>(-1); // it may now cover one before
      ++tries;
    }
}

void SizeMarks::update() {
  placeAll();
  separate();
}

void SizeMarks::placeAll() {
  if (!part_.isEmpty()) {
    const Eigen::Vector3d middle = part_.center();
    const Eigen::Vector3d eye =
        world_T_work_.linear().transpose() * towardsEye(renderer_).normalized();
    // Along x and y: the lower edges that face the eye; along z: the outermost edge to the right.
    const double nearX = eye.x() > 0.0 ? part_.max().x() : part_.min().x();
    const double nearY = eye.y() > 0.0 ? part_.max().y() : part_.min().y();
    const double lowest = part_.min().z();
    place(0, {middle.x(), nearY, lowest}, {middle.x(), middle.y(), middle.z()});
    place(1, {nearX, middle.y(), lowest}, {middle.x(), middle.y(), middle.z()});
    Eigen::Vector3d upright = middle;
    double rightmost = -1e12;
    for (const int corner : {0, 1, 2, 3}) {
      Eigen::Vector3d edge = cornerOf(part_, corner);
      edge.z() = middle.z();
      if (const double x = onScreen(edge).x(); x > rightmost) {
        rightmost = x;
        upright = edge;
      }
    }
    place(2, upright, middle);
  }
  if (plate_.empty())
    return;
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& p : plate_)
    box.extend(p);
  // The corner of the plate that is lowest in the picture.
  Eigen::Vector3d corner = Eigen::Vector3d::Zero();
  double lowest = 1e12;
  for (const Eigen::Vector2d& p : plate_) {
    const Eigen::Vector3d at(p.x(), p.y(), 0.0);
    if (const double y = onScreen(at).y(); y < lowest) {
      lowest = y;
      corner = at;
    }
  }
  const Eigen::Vector3d centre(box.center().x(), box.center().y(), 0.0);
  place(kPlate, corner, centre);
  place(kOrigin, Eigen::Vector3d::Zero(), {1.0, 1.0, 0.0});
}

std::vector<Eigen::AlignedBox2d> SizeMarks::areas() const {
  std::vector<Eigen::AlignedBox2d> areas;
  for (std::size_t i = 0; i < kLabels; ++i)
    if (labels_[i]->GetVisibility())
      areas.push_back(areas_[i]);
  return areas;
}

std::vector<std::string> SizeMarks::shown() const {
  std::vector<std::string> texts;
  for (const auto& label : labels_)
    if (label->GetVisibility())
      texts.emplace_back(label->GetInput());
  return texts;
}

} // namespace voluta::scene
