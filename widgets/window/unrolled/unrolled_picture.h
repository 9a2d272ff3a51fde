// The picture of an unrolled layer; can be drawn on any thread.
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

// The visible part of the plane: v points upwards, as seen from outside.
struct UnrolledFrame {
  QPointF centreMm;
  double pixelsPerMm = 10.0;
  QSizeF size; // Size of the picture in device-independent pixels
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
  QColor sheet, beside; // Within the layer's period, and its repetition beyond the seams
  QColor outline, seam, chosen;
  std::array<QColor, plan::kPathKinds> kinds; // Per plan::PathKind
  bool operator==(const UnrolledLook&) const = default;
};

struct UnrolledContent {
  std::shared_ptr<const UnrolledLayer> layer; // nullptr: nothing
  // Waypoints from this one on are not printed yet and drawn faintly.
  std::size_t unprintedFrom = std::numeric_limits<std::size_t>::max();
  std::optional<std::size_t> path; // Highlighted path
  bool operator==(const UnrolledContent&) const = default;
};

// Draws beads in their true width, or as lines if that is less than a pixel or two. Content beyond
// a seam is repeated there.
QImage unrolledPicture(const UnrolledContent& content, const UnrolledFrame& frame,
                       const UnrolledLook& look, const base::RunContext& ctx);

} // namespace voluta::window
