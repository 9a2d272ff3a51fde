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
Faces facesOf(const VoxelDrawing& drawing, int first, int last, bool lastPlain, bool opened) {
  Faces faces, plain;
  const std::int32_t above = opened ? -kNeverHidden : last;
  const int coloured = lastPlain ? last - 1 : last;
  drawing.outer.append(faces.outer, first, coloured, -kNeverHidden);
  drawing.upper.append(faces.inner, first, coloured, above);
  if (!opened)
    drawing.lower.append(faces.inner, first, last, -first);
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

VoxelActors::VoxelActors(vtkRenderer* renderer) {
  for (RangeActor* faces : {&outside_, &inside_}) {
    *faces = RangeActor::make(renderer);
    addPlainColour(faces->actor);
  }
  for (RangeActor& one : missed_)
    one = RangeActor::make(renderer);
  ghosts_ = RangeActor::make(renderer);
  ghosts_.mapper->ScalarVisibilityOff();
  ghosts_.actor->GetProperty()->SetOpacity(kGhostOpacity);
  for (RangeActor& one : halos_)
    one = RangeActor::halo(renderer);
  hide();
}

void VoxelActors::setDrawing(const VoxelDrawing* drawing) {
  drawing_ = drawing;
  outside_.setData(drawing ? drawing->outside.Get() : nullptr);
  inside_.setData(drawing ? drawing->inside.Get() : nullptr);
  ghosts_.setData(drawing ? drawing->outside.Get() : nullptr);
  for (std::size_t reason = 0; reason < kLossCount; ++reason)
    for (RangeActor* one : {&missed_[reason], &halos_[reason]}) {
      one->setData(drawing ? drawing->missed.Get() : nullptr);
      one->mapper->setStretches(drawing ? std::vector{drawing->missedFaces[reason]}
                                        : std::vector<Stretch>{});
    }
}

void VoxelActors::setTheme(const Theme& theme) {
  const std::array<Colour, kLossCount> lost{theme.blocked, theme.unreached, theme.cascade};
  for (std::size_t reason = 0; reason < kLossCount; ++reason) {
    setColour(missed_[reason].actor, lost[reason]);
    setColour(halos_[reason].actor, lost[reason]);
  }
  for (RangeActor* faces : {&outside_, &inside_})
    faces->mapper->setPlainColour(theme.current);
  setColour(ghosts_.actor, theme.ghost);
}

void VoxelActors::hide() {
  for (vtkActor* actor : actors())
    actor->SetVisibility(false);
}

void VoxelActors::prepare() {
  hide();
  for (RangeActor* faces : {&outside_, &inside_}) {
    faces->mapper->setStretches({});
    faces->actor->SetVisibility(drawing_ != nullptr);
  }
}

void VoxelActors::show(const ViewState& view, bool replayed) {
  hide();
  if (!drawing_)
    return;
  for (std::size_t reason = 0; reason < kLossCount; ++reason) {
    const bool any = drawing_->lost[reason] > 0;
    missed_[reason].actor->SetVisibility(any);
    halos_[reason].actor->SetVisibility(any && !view.seeThrough);
  }
  const int first = replayed ? 0 : view.firstLayer;
  const int last = replayed ? *view.growthStep - 1 : view.lastLayer;
  std::vector<Stretch> faint;
  if (view.seeThrough)
    drawing_->outer.append(faint, first, last, -kNeverHidden);
  if (replayed && view.ghosts)
    drawing_->outer.append(faint, last + 1, kAllLayers, -kNeverHidden);
  ghosts_.actor->SetVisibility(!faint.empty());
  ghosts_.mapper->setStretches(std::move(faint));
  if (view.seeThrough)
    return;
  Faces faces = facesOf(*drawing_, first, last, replayed, view.sectionOn);
  outside_.actor->SetVisibility(true);
  outside_.mapper->setStretches(std::move(faces.outer));
  inside_.actor->SetVisibility(replayed || !faces.inner.empty());
  inside_.mapper->setStretches(std::move(faces.inner));
}

std::vector<vtkActor*> VoxelActors::actors() const {
  std::vector<vtkActor*> all{outside_.actor, inside_.actor, ghosts_.actor};
  for (const auto* group : {&missed_, &halos_})
    for (const RangeActor& one : *group)
      all.push_back(one.actor);
  return all;
}

} // namespace voluta::scene
