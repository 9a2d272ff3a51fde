// Draws the picture of an unrolled layer in the background: one at a time, always the newest
// request next, so that pictures appear as fast as they can be drawn.
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
  // Returns whether the picture is that of the last request.
  bool settled() const { return !runner_.running() && drawn_ && *drawn_ == wanted_; }
  // nullopt: nothing has been drawn yet.
  const std::optional<Subject>& drawn() const { return drawn_; }
  const QImage& picture() const { return picture_; } // Of drawn()

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
