#include "window/presenters/shown_plate_parts.h"

#include "document/choices_compare.h"
#include "geometry/placement.h"
#include "modes/mode_stages.h"
#include "pipeline/stage_options.h"
#include "window/background.h"

#include <algorithm>

namespace voluta::window {

using project::Stage;

namespace {
geometry::TriangleMesh asRead(const project::LoadedPart& part, const project::Choices& choices) {
  const double scale = project::parsedScale(choices.item().scale);
  return geometry::place(*part.mesh, pipeline::unitMm(part, choices) * (scale > 0.0 ? scale : 1.0),
                         choices.item().placement);
}
} // namespace

PlateParts::PlateParts(document::Document& document, viewer::Viewport& viewport)
    : document_(document), viewport_(viewport), drawing_(std::make_unique<jobs::JobRunner>()) {}

PlateParts::~PlateParts() = default;

bool PlateParts::busy() const {
  return drawing_->running();
}

std::vector<PlateParts::Part> PlateParts::wanted() const {
  const auto sources = document_.sources();
  if (sources.size() < 2)
    return {};
  const auto placed = document_.result(Stage::Load);
  std::vector<Part> parts;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    Part part{placed ? placed->job.item(i).part : nullptr, nullptr, {}, nullptr};
    if (!part.placed) {
      part.source = sources[i];
      part.choices = project::onlyItem(document_.jobChoices(), i);
    }
    const auto same = std::ranges::find_if(parts_, [&](const Part& old) {
      return old.placed == part.placed && old.source == part.source &&
             (part.placed || document::sameChoices(old.choices, part.choices));
    });
    if (same != parts_.end())
      part.drawing = same->drawing;
    parts.push_back(std::move(part));
  }
  return parts;
}

void PlateParts::update() {
  std::vector<Part> parts = wanted();
  if (parts.empty() && parts_.empty()) // a job of one part
    return;
  if (std::ranges::all_of(parts, [](const Part& part) { return part.drawing != nullptr; })) {
    drawing_->cancel();
    parts_ = std::move(parts);
    show();
    return;
  }
  inBackground(
      *drawing_,
      [parts = std::move(parts)]() mutable {
        for (Part& part : parts)
          if (!part.drawing)
            part.drawing =
                scene::drawPart(part.placed ? *part.placed : asRead(*part.source, part.choices));
        return std::move(parts);
      },
      [this](auto&& made) {
        parts_ = std::move(made);
        show();
        emit drawn();
      });
}

// The active part may have changed while they were drawn.
void PlateParts::show() {
  std::vector<std::shared_ptr<const scene::PartDrawing>> others;
  for (std::size_t i = 0; i < parts_.size(); ++i)
    others.push_back(i == document_.active() ? nullptr : parts_[i].drawing);
  viewport_.scene().setOtherParts(std::move(others));
  viewport_.requestFrame();
}

std::shared_ptr<const scene::PartDrawing>
PlateParts::drawingOf(const geometry::TriangleMesh* placed) const {
  const auto found =
      std::ranges::find_if(parts_, [&](const Part& part) { return part.placed.get() == placed; });
  return placed && found != parts_.end() ? found->drawing : nullptr;
}

} // namespace voluta::window
