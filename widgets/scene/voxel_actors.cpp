#include "scene/voxel_actors.h"

#include <utility>
#include <vtkProperty.h>

namespace voluta::scene {

namespace {

constexpr double kGhostOpacity = 0.12; // of later voxels, and with seeThrough

struct Faces {
  std::vector<Stretch> outer, inner;
};

// Returns the faces of layers first to last. `lastPlain`: the last layer is highlighted in the
// mappers' plain colour. `opened`: a section exposes inner faces.
Faces facesOf(const VoxelDrawing& drawing, int first, int last, bool lastPlain, bool opened,
              bool downwards) {
  Faces faces, plain;
  const std::int32_t above = opened ? -kNeverHidden : last;
  const int coloured = lastPlain ? last - 1 : last;
  drawing.outer.append(faces.outer, first, coloured, -kNeverHidden, downwards);
  drawing.upper.append(faces.inner, first, coloured, above, downwards);
  if (!opened)
    drawing.lower.append(faces.inner, first, last, -first, downwards);
  if (lastPlain) {
    drawing.outer.append(plain.outer, last, last, -kNeverHidden);
    drawing.upper.append(plain.inner, last, last, above);
  }
  for (const auto& [from, to] :
       {std::pair(&plain.outer, &faces.outer), std::pair(&plain.inner, &faces.inner)})
    for (Stretch stretch : *from) {
      stretch.plain = true;
      to->push_back(stretch);
    }
  return faces;
}

} // namespace

VoxelActors::VoxelActors(vtkRenderer* renderer) : details_{Detail(renderer), Detail(renderer)} {
  hide();
}

VoxelActors::Detail::Detail(vtkRenderer* renderer) {
  for (RangeActor* faces : {&outside, &inside}) {
    *faces = RangeActor::make(renderer);
    addPlainColour(faces->actor);
  }
  for (RangeActor& one : missed)
    one = RangeActor::make(renderer);
  ghosts = RangeActor::make(renderer);
  ghosts.mapper->ScalarVisibilityOff();
  ghosts.actor->GetProperty()->SetOpacity(kGhostOpacity);
  for (RangeActor& one : halos)
    one = RangeActor::halo(renderer);
}

void VoxelActors::setDrawing(const VoxelDrawing* drawing) {
  details_[kFine].setDrawing(drawing);
  details_[kCoarse].setDrawing(drawing ? drawing->coarse.get() : nullptr);
}

void VoxelActors::Detail::setDrawing(const VoxelDrawing* given) {
  drawing = given;
  outside.setData(drawing ? drawing->outside.Get() : nullptr);
  inside.setData(drawing ? drawing->inside.Get() : nullptr);
  ghosts.setData(drawing ? drawing->outside.Get() : nullptr);
  for (std::size_t reason = 0; reason < kLossCount; ++reason)
    for (RangeActor* one : {&missed[reason], &halos[reason]}) {
      one->setData(drawing ? drawing->missed.Get() : nullptr);
      one->mapper->setStretches(drawing ? std::vector{drawing->missedFaces[reason]}
                                        : std::vector<Stretch>{});
    }
}

void VoxelActors::setTheme(const Theme& theme) {
  const std::array<Colour, kLossCount> lost{theme.blocked, theme.unreached, theme.cascade};
  for (const Detail& detail : details_) {
    for (std::size_t reason = 0; reason < kLossCount; ++reason) {
      setColour(detail.missed[reason].actor, lost[reason]);
      setColour(detail.halos[reason].actor, lost[reason]);
    }
    for (const RangeActor* faces : {&detail.outside, &detail.inside})
      faces->mapper->setPlainColour(theme.current);
    setColour(detail.ghosts.actor, theme.ghost);
  }
}

void VoxelActors::hide() {
  for (vtkActor* actor : actors())
    actor->SetVisibility(false);
}

void VoxelActors::prepare() {
  hide();
  for (const Detail& detail : details_)
    detail.prepare();
}

// An actor that is visible without stretches fills its buffers and draws nothing.
void VoxelActors::Detail::prepare() const {
  for (const RangeActor* faces : {&outside, &inside}) {
    faces->mapper->setStretches({});
    faces->actor->SetVisibility(drawing != nullptr);
  }
}

void VoxelActors::show(const ViewState& view, bool replayed) {
  hide();
  const VoxelDrawing* fine = details_[kFine].drawing;
  if (!fine)
    return;
  const bool few = 2 * fine->outer.size() <= view.draggedTriangles;
  const std::size_t shown = view.dragging && !few && fine->coarse ? kCoarse : kFine;
  details_[shown].show(view, replayed);
  details_[kFine + kCoarse - shown].prepare();
}

void VoxelActors::Detail::show(const ViewState& view, bool replayed) const {
  for (std::size_t reason = 0; reason < kLossCount; ++reason) {
    const bool any = drawing->lost[reason] > 0;
    missed[reason].actor->SetVisibility(any);
    halos[reason].actor->SetVisibility(any && !view.seeThrough);
  }
  const int first = replayed ? 0 : view.firstLayer;
  const int last = replayed ? *view.growthStep - 1 : view.lastLayer;
  std::vector<Stretch> faint;
  if (view.seeThrough)
    drawing->outer.append(faint, first, last, -kNeverHidden);
  if (replayed && view.ghosts)
    drawing->outer.append(faint, last + 1, kAllLayers, -kNeverHidden);
  ghosts.actor->SetVisibility(!faint.empty());
  ghosts.mapper->setStretches(std::move(faint));
  if (view.seeThrough)
    return;
  Faces faces = facesOf(*drawing, first, last, replayed, view.sectionOn, view.dragging);
  outside.actor->SetVisibility(true);
  outside.mapper->setStretches(std::move(faces.outer));
  inside.actor->SetVisibility(replayed || !faces.inner.empty());
  inside.mapper->setStretches(std::move(faces.inner));
}

std::vector<vtkActor*> VoxelActors::actors() const {
  std::vector<vtkActor*> all;
  for (const Detail& detail : details_) {
    all.insert(all.end(),
               {detail.outside.actor.Get(), detail.inside.actor.Get(), detail.ghosts.actor.Get()});
    for (const auto* group : {&detail.missed, &detail.halos})
      for (const RangeActor& one : *group)
        all.push_back(one.actor);
  }
  return all;
}

} // namespace voluta::scene
