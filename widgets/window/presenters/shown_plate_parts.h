// The parts of a job of several, drawn where they are on the plate.
#pragma once

#include "document/document.h"
#include "jobs/job_runner.h"
#include "scene/drawings.h"
#include "viewer/viewport.h"

#include <QObject>
#include <memory>
#include <vector>

namespace voluta::window {

// Draws nothing for a job of one part. The active part is drawn here too, so that another can be
// made active without a wait, but shown by PartPresenter.
class PlateParts : public QObject {
  Q_OBJECT

public:
  // Both must outlive this.
  PlateParts(document::Document& document, viewer::Viewport& viewport);
  ~PlateParts() override;

  // Draws the parts that are new or in another place. Parts that no plan has placed are drawn as
  // read, in the place of their choices.
  void update();
  // Returns the drawing of a part in its place; null: not drawn.
  std::shared_ptr<const scene::PartDrawing> drawingOf(const geometry::TriangleMesh* placed) const;
  bool busy() const;

signals:
  void drawn();

private:
  struct Part {
    std::shared_ptr<const geometry::TriangleMesh> placed; // null: as read
    std::shared_ptr<const project::LoadedPart> source;
    project::Choices choices; // of this part only
    std::shared_ptr<const scene::PartDrawing> drawing;
  };
  std::vector<Part> wanted() const;
  void show();

  document::Document& document_;
  viewer::Viewport& viewport_;
  std::unique_ptr<jobs::JobRunner> drawing_;
  std::vector<Part> parts_; // as drawn
};

} // namespace voluta::window
