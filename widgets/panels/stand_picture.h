// Small pictures of a part as it stands, drawn without OpenGL: good for any thread.
#pragma once

#include "geometry/triangle_mesh.h"

#include <Eigen/Geometry>
#include <QImage>
#include <QSize>
#include <vector>

namespace voluta::panels {

// The mesh turned by each of `turns`, on its piece of the plate, from where the viewport looks at
// first, as large as there is room. The ground is clear and the tones are middle ones, so that it
// is good on light and dark. `pixels`: of each, 16 or more either way. Takes about a millisecond a
// thousand triangles. Precondition (Error{Internal}): mesh not empty.
std::vector<QImage> standPictures(const geometry::TriangleMesh& mesh,
                                  const std::vector<Eigen::Quaterniond>& turns,
                                  const QSize& pixels);

} // namespace voluta::panels
