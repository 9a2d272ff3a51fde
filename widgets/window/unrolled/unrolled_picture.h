// The picture of an unrolled layer, drawn on any thread.
#pragma once

#include "window/unrolled/unrolled_layer.h"

#include <QColor>
#include <QImage>
#include <QPointF>
#include <QSizeF>
#include <array>
#include <cstddef>
#include <limits>
#include <optional>

namespace voluta::window {

// What of the plane is in sight: v upwards, as seen from outside.
struct UnrolledFrame {
  QPointF centreMm;
  double pixelsPerMm = 10.0;
  QSizeF size; // of the picture, in pixels that do not know of the screen's ratio
  double pixelRatio = 1.0;

  QPointF pixelOf(const QPointF& mm) const {
    return {0.5 * size.width() + (mm.x() - centreMm.x()) * pixelsPerMm,
            0.5 * size.height() - (mm.y() - centreMm.y()) * pixelsPerMm};
  }
  QPointF mmAt(const QPointF& pixel) const {
    return {centreMm.x() + (pixel.x() - 0.5 * size.width()) / pixelsPerMm,
            centreMm.y() - (pixel.y() - 0.5 * size.height()) / pixelsPerMm};
  }
  bool operator==(const UnrolledFrame&) const = default;
};

struct UnrolledLook {
  QColor sheet, beside; // within the layer's period, and its repetition beyond the seams
  QColor outline, seam, chosen;
  std::array<QColor, plan::kPathKinds> kinds; // of plan::PathKind
  bool operator==(const UnrolledLook&) const = default;
};

struct UnrolledContent {
  std::shared_ptr<const UnrolledLayer> layer; // null: nothing
  // Waypoints from this one on are not laid yet: faint.
  std::size_t notLaidFrom = std::numeric_limits<std::size_t>::max();
  std::optional<std::size_t> path; // stands out
  bool operator==(const UnrolledContent&) const = default;
};

// Beads as wide as they are, lines where that is less than a pixel or two. What lies beyond a seam
// is drawn there once more.
QImage unrolledPicture(const UnrolledContent& content, const UnrolledFrame& frame,
                       const UnrolledLook& look, const base::RunContext& ctx);

} // namespace voluta::window
