#include "toolpath/coverage/bead_volume.h"

#include "process/bead_model.h"
#include "toolpath/unsupported/bead_tip.h"

namespace voluta::toolpath {

double volumeOf(const std::vector<Bead>& beads) {
  double mm3 = 0.0;
  for (const Bead& bead : beads)
    for (std::size_t i = 1; i < bead.points.size(); ++i) {
      const BeadPoint &p = bead.points[i - 1], &q = bead.points[i];
      mm3 += process::beadVolume(process::beadArea(p.widthMm, p.heightMm),
                                 process::beadArea(q.widthMm, q.heightMm),
                                 (tipOf(q) - tipOf(p)).norm());
    }
  return mm3;
}

} // namespace voluta::toolpath
