// Small pictures of a part in an orientation, rendered without OpenGL, on any thread.
#pragma once

#include "geometry/triangle_mesh.h"

#include <Eigen/Geometry>
#include <QImage>
#include <QSize>
#include <vector>

namespace voluta::panels {

// Renders the mesh rotated by each of `turns`, on a section of the plate, from the viewport's
// initial direction, as large as possible. The background is transparent and the colours are
// midtones, so that the pictures suit light and dark themes. `pixels`: size of each, at least 16 in
// both directions. Takes about one millisecond per thousand triangles. Precondition
// (Error{Internal}): mesh not empty.
std::vector<QImage> standPictures(const geometry::TriangleMesh& mesh,
                                  const std::vector<Eigen::Quaterniond>& turns,
                                  const QSize& pixels);

} // namespace voluta::panels
