#include "scene/overlay.h"

#include "scene/mesh_buffers.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkTextProperty.h>

namespace voluta::scene {

namespace {

constexpr double kTriadPlace = 46.0, kTriadLength = 30.0, kLetterPlace = 40.0;
constexpr double kLegendLeft = 18.0, kLegendTop = 20.0, kBarWidth = 14.0, kBarHeight = 150.0,
                 kRow = 20.0, kTitleRow = 24.0;
constexpr int kFontPoints = 13;
constexpr int kBarSteps = 64;

vtkSmartPointer<vtkActor2D> flatActor(vtkRenderer* renderer) {
  auto actor = vtkSmartPointer<vtkActor2D>::New();
  actor->SetMapper(vtkSmartPointer<vtkPolyDataMapper2D>::New());
  renderer->AddActor2D(actor);
  return actor;
}

void setShape(vtkActor2D* actor, const MeshBuffers& buffers) {
  static_cast<vtkPolyDataMapper2D*>(actor->GetMapper())->SetInputData(polyDataOf(buffers));
}

void addRectangle(MeshBuffers& out, double x, double y, double w, double h, const Colour& colour) {
  const auto a = out.addPoint({x, y, 0}), b = out.addPoint({x + w, y, 0}),
             c = out.addPoint({x + w, y + h, 0}), d = out.addPoint({x, y + h, 0});
  out.addQuad(a, b, c, d);
  for (int k = 0; k < 4; ++k)
    for (const double v : colour)
      out.rgb.push_back(static_cast<std::uint8_t>(std::lround(255 * v)));
}

} // namespace

Overlay::Overlay(vtkRenderer* renderer) : renderer_(renderer) {
  constexpr const char* names[] = {"X", "Y", "Z"};
  for (std::size_t i = 0; i < 3; ++i) {
    arrows_[i] = flatActor(renderer);
    letters_[i] = addText();
    letters_[i]->SetInput(names[i]);
    letters_[i]->GetTextProperty()->SetJustificationToCentered();
    letters_[i]->GetTextProperty()->BoldOn();
  }
  bar_ = flatActor(renderer);
  title_ = addText();
}

vtkSmartPointer<vtkTextActor> Overlay::addText() {
  auto text = vtkSmartPointer<vtkTextActor>::New();
  text->GetTextProperty()->SetFontFamilyToArial();
  text->GetTextProperty()->SetVerticalJustificationToCentered();
  renderer_->AddActor2D(text);
  return text;
}

void Overlay::setTheme(const Theme& theme) {
  theme_ = theme;
  const std::array<Colour, 3> colours{theme.axisX, theme.axisY, theme.axisZ};
  for (std::size_t i = 0; i < 3; ++i) {
    Colour c = colours[i];
    arrows_[i]->GetProperty()->SetColor(c.data());
    letters_[i]->GetTextProperty()->SetColor(c.data());
  }
}

void Overlay::setLegend(const Legend& legend) {
  legend_ = legend;
  while (labels_.size() < legend.entries.size() + legend.marks.size())
    labels_.push_back(addText());
}

void Overlay::update() {
  placeTriad();
  placeLegend();
}

void Overlay::placeTriad() {
  const vtkMatrix4x4* view = renderer_->GetActiveCamera()->GetViewTransformMatrix();
  const Eigen::Vector2d centre = Eigen::Vector2d::Constant(kTriadPlace * ratio_);
  for (std::size_t i = 0; i < 3; ++i) {
    arrows_[i]->SetVisibility(triadShown_);
    letters_[i]->SetVisibility(triadShown_);
    const int axis = static_cast<int>(i);
    const Eigen::Vector2d along(view->GetElement(0, axis), view->GetElement(1, axis));
    // Draws the stroke as a polygon: lines wider than a pixel are not available everywhere.
    const Eigen::Vector2d end = centre + kTriadLength * ratio_ * along;
    const Eigen::Vector2d across =
        ratio_ * (along.norm() > 1e-3 ? Eigen::Vector2d(-along.y(), along.x()).normalized()
                                      : Eigen::Vector2d(1, 0));
    MeshBuffers stroke;
    const auto point = [&](const Eigen::Vector2d& p) { return stroke.addPoint({p.x(), p.y(), 0}); };
    const auto a = point(centre - across), b = point(end - across), c = point(end + across),
               d = point(centre + across);
    stroke.addQuad(a, b, c, d);
    setShape(arrows_[i], stroke);
    // Nearer axes are drawn over farther ones.
    arrows_[i]->SetLayerNumber(view->GetElement(2, axis) > 0 ? 2 : 1);
    const Eigen::Vector2d letter = centre + kLetterPlace * ratio_ * along;
    letters_[i]->SetPosition(letter.x(), letter.y());
    letters_[i]->GetTextProperty()->SetFontSize(static_cast<int>(std::lround(12 * ratio_)));
  }
}

void Overlay::placeLegend() {
  const auto& entries = legend_.entries;
  const std::size_t rows = entries.size() + legend_.marks.size();
  bar_->SetVisibility(rows > 0);
  title_->SetVisibility(!entries.empty());
  for (std::size_t i = 0; i < labels_.size(); ++i)
    labels_[i]->SetVisibility(i < rows);
  if (rows == 0)
    return;
  const int* size = renderer_->GetSize();
  const double left = kLegendLeft * ratio_;
  const double top = size[1] - kLegendTop * ratio_;
  Colour text = theme_.text;
  const auto place = [&](vtkTextActor* actor, const std::string& what, double x, double y) {
    actor->SetInput(what.c_str());
    actor->SetPosition(x, y);
    actor->GetTextProperty()->SetColor(text.data());
    actor->GetTextProperty()->SetFontSize(static_cast<int>(std::lround(kFontPoints * ratio_)));
  };
  const std::string title = base::english(legend_.title);
  place(title_, legend_.unit.empty() ? title : title + " (" + legend_.unit + ")", left, top);
  title_->GetTextProperty()->BoldOn();
  const double below = entries.empty() ? top : top - kTitleRow * ratio_;
  const double labelX = left + (kBarWidth + 8) * ratio_;
  MeshBuffers bar;
  const auto placeRow = [&](std::size_t label, const LegendEntry& entry, double y) {
    addRectangle(bar, left, y - kBarWidth / 2 * ratio_, kBarWidth * ratio_, kBarWidth * ratio_,
                 entry.colour);
    place(labels_[label], base::english(entry.text()), labelX, y);
  };
  double marksFrom = below - static_cast<double>(entries.size()) * kRow * ratio_;
  if (legend_.categorical || entries.size() <= 1) {
    for (std::size_t i = 0; i < entries.size(); ++i)
      placeRow(i, entries[i], below - static_cast<double>(i) * kRow * ratio_);
  } else {
    const double height = kBarHeight * ratio_, bottom = below - height;
    for (int s = 0; s < kBarSteps; ++s)
      addRectangle(bar, left, bottom + height * s / kBarSteps, kBarWidth * ratio_,
                   height / kBarSteps, legend_.scaleColour((s + 0.5) / kBarSteps));
    for (std::size_t i = 0; i < entries.size(); ++i)
      place(labels_[i], base::english(entries[i].text()), labelX,
            bottom + height * static_cast<double>(i) / static_cast<double>(entries.size() - 1));
    marksFrom = bottom - 1.3 * kRow * ratio_;
  }
  for (std::size_t i = 0; i < legend_.marks.size(); ++i)
    placeRow(entries.size() + i, legend_.marks[i],
             marksFrom - static_cast<double>(i) * kRow * ratio_);
  setShape(bar_, bar);
}

} // namespace voluta::scene
