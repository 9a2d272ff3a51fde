// The picture of a layer laid flat, drawn in the background: one at a time, the newest next, so
// that pictures come as fast as they can be drawn, however fast the wishes change.
#pragma once

#include "jobs/job_runner.h"
#include "window/unrolled/unrolled_picture.h"

#include <QImage>
#include <QObject>
#include <optional>

namespace voluta::window {

class UnrolledDrawing : public QObject {
  Q_OBJECT

public:
  struct Subject {
    UnrolledContent content;
    UnrolledFrame frame;
    UnrolledLook look;
    bool operator==(const Subject&) const = default;
  };

  void draw(const Subject& subject);
  // Is the picture that of what was asked for last?
  bool settled() const { return !runner_.running() && drawn_ && *drawn_ == wanted_; }
  // none: nothing is drawn yet.
  const std::optional<Subject>& drawn() const { return drawn_; }
  const QImage& picture() const { return picture_; } // of drawn()

signals:
  void changed();

private:
  void start();

  jobs::JobRunner runner_;
  Subject wanted_;
  std::optional<Subject> drawn_;
  QImage picture_;
};

} // namespace voluta::window
