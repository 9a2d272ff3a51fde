#include "scene/piece_actors.h"

#include <vtkProperty.h>

namespace voluta::scene {

namespace {

constexpr double kBaseOpacity = 0.22, kChosenBaseOpacity = 0.42;
// of the other pieces: colour blended towards the background, and transparency
constexpr double kFaded = 0.5, kFadedOpacity = 0.3;

Colour mixed(const Colour& a, const Colour& b, double share) {
  Colour out{};
  for (std::size_t k = 0; k < 3; ++k)
    out[k] = (1.0 - share) * a[k] + share * b[k];
  return out;
}

} // namespace

PieceActors::PieceActors(vtkRenderer* renderer) : renderer_(renderer), theme_(lightTheme()) {}

void PieceActors::remove() {
  for (const One& one : pieces_)
    for (vtkActor* actor :
         {one.safe.Get(), one.risky.Get(), one.edges.Get(), one.base.Get(), one.baseRim.Get()})
      renderer_->RemoveActor(actor);
  pieces_.clear();
}

void PieceActors::setDrawing(const PiecesDrawing* drawing) {
  remove();
  drawing_ = drawing;
  if (!drawing)
    return;
  for (const PieceShape& shape : drawing->pieces) {
    One one{addSolid(renderer_), addSolid(renderer_), addLines(renderer_), addSolid(renderer_),
            addLines(renderer_)};
    setData(one.safe, shape.safe);
    setData(one.risky, shape.risky);
    setData(one.edges, shape.solid->edges);
    setData(one.base, shape.base);
    setData(one.baseRim, shape.baseRim);
    one.base->GetProperty()->LightingOff();
    one.base->ForceTranslucentOn();
    pieces_.push_back(one);
  }
  hide();
}

void PieceActors::setTheme(const Theme& theme) {
  theme_ = theme;
}

void PieceActors::hide() {
  for (const One& one : pieces_)
    for (vtkActor* actor :
         {one.safe.Get(), one.risky.Get(), one.edges.Get(), one.base.Get(), one.baseRim.Get()})
      actor->SetVisibility(false);
}

void PieceActors::show(const ViewState& view, const Eigen::Isometry3d& world_T_work) {
  const std::vector<Eigen::Vector3d> offsets = pieceOffsets(*drawing_, view.explodeMm);
  const bool some = view.piece && *view.piece < pieces_.size();
  for (std::size_t i = 0; i < pieces_.size(); ++i) {
    const One& one = pieces_[i];
    const PieceShape& shape = drawing_->pieces[i];
    const bool chosen = some && *view.piece == i;
    const bool glass = some && !chosen;
    const auto shown = [&](const Colour& colour) {
      return glass ? mixed(colour, theme_.backgroundTop, kFaded) : colour;
    };
    const Colour own = pieceColour(static_cast<int>(i));
    setColour(one.safe, shown(own));
    setColour(one.risky, shown(theme_.risky));
    setColour(one.edges, mixed(own, theme_.partEdges, 0.6));
    setColour(one.base, own);
    setColour(one.baseRim, own);
    const Eigen::Isometry3d pose = world_T_work * Eigen::Translation3d(offsets[i]);
    for (vtkActor* actor : {one.safe.Get(), one.risky.Get(), one.edges.Get()}) {
      setPose(actor, pose);
      actor->SetVisibility(true);
    }
    // Like a translucent part: only walls that face the eye are drawn.
    for (vtkActor* actor : {one.safe.Get(), one.risky.Get()}) {
      actor->GetProperty()->SetOpacity(glass ? kFadedOpacity : 1.0);
      actor->GetProperty()->SetBackfaceCulling(glass);
    }
    one.edges->SetVisibility(!glass);
    // If a piece is chosen, only its base plane is shown.
    Eigen::Isometry3d base =
        world_T_work * Eigen::Translation3d(basePlaneOffset(*drawing_, i, view.explodeMm));
    if (chosen && view.moved_T_base)
      base = base * *view.moved_T_base;
    for (vtkActor* actor : {one.base.Get(), one.baseRim.Get()}) {
      setPose(actor, base);
      actor->SetVisibility(shape.base && (chosen || (view.basePlanes && !some)));
    }
    one.base->GetProperty()->SetOpacity(chosen ? kChosenBaseOpacity : kBaseOpacity);
  }
}

std::vector<vtkActor*> PieceActors::actors() const {
  std::vector<vtkActor*> actors;
  for (const One& one : pieces_)
    actors.insert(actors.end(), {one.safe.Get(), one.risky.Get(), one.edges.Get()});
  return actors;
}

Legend pieceLegend(const PiecesDrawing& drawing, const Theme& theme, bool named) {
  Legend legend;
  legend.title = "Piece"_text;
  legend.categorical = true;
  for (std::size_t i = 0; named && i < drawing.pieces.size(); ++i)
    legend.entries.push_back({static_cast<double>(i), i + 1, pieceColour(static_cast<int>(i)),
                              drawing.pieces[i].parent < 0 ? "on the plate"_text : base::Text()});
  if (drawing.anyRisky)
    legend.marks.push_back({0.0, "Needs support"_text, theme.risky});
  return legend;
}

} // namespace voluta::scene
