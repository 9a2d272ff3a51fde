#include "window/presenters/presenter.h"

#include "modes/mode_table.h"

namespace voluta::window {

using project::Stage;

Presenter::Presenter(document::Document& document, viewer::Viewport& viewport, QObject* parent)
    : QObject(parent), document_(document), part_(document, viewport), voxels_(viewport),
      pieces_(viewport), print_(document, viewport) {
  connect(&document, &document::Document::resultChanged, this, [this](Stage stage) {
    if (stage != Stage::Decompose)
      return;
    drawVoxels();
    drawPieces();
  });
  connect(&document, &document::Document::previewChanged, this, &Presenter::drawVoxels);
  connect(&document, &document::Document::partsChanged, this, [this] {
    if (document_.partCount() < 2)
      return;
    drawVoxels();
    drawPieces();
  });
  connect(&part_, &PartPresenter::drawn, this, &Presenter::partDrawn);
  connect(&part_, &PartPresenter::platformDrawn, this, &Presenter::platformDrawn);
  connect(&part_, &PartPresenter::cellDrawn, this, &Presenter::cellDrawn);
  connect(&voxels_, &VoxelPresenter::drawn, this, &Presenter::voxelsDrawn);
  connect(&print_, &PrintPresenter::layersDrawn, this, &Presenter::layersDrawn);
  connect(&print_, &PrintPresenter::pathsDrawn, this, &Presenter::pathsDrawn);
  connect(&print_, &PrintPresenter::motionReady, this, &Presenter::motionReady);
  connect(&print_, &PrintPresenter::factsReady, this, &Presenter::factsReady);
  connect(&print_, &PrintPresenter::statisticsReady, this, &Presenter::statisticsReady);
}

Presenter::~Presenter() = default;

bool Presenter::busy() const {
  return part_.busy() || voxels_.busy() || pieces_.busy() || print_.busy();
}

void Presenter::drawVoxels() {
  if (const auto& preview = document_.preview()) {
    voxels_.setDecomposition(preview->decomposition, preview->layerHeightMm);
    return;
  }
  const auto result = document_.itemResult(Stage::Decompose);
  voxels_.setDecomposition(
      result ? result->job.item().decomposition() : nullptr,
      result && result->item().resolved ? result->tooling().first().process.layerHeightMm : 0.0);
}

// Flat slicing has a single piece, the part, which is not shown as a piece.
void Presenter::drawPieces() {
  const auto result = document_.itemResult(Stage::Decompose);
  const modes::Mode* mode = result ? modes::modeNamed(result->job.choices.item().mode) : nullptr;
  pieces_.setPieces(mode && mode->cuts ? result->job.item().pieces() : nullptr,
                    result ? result->job.choices : project::Choices{});
}

} // namespace voluta::window
