// Clearances that collision checks keep.
#pragma once

namespace voluta::collision {

// Clearances between bodies [mm].
struct Margins {
  double bodiesMm = 2.0; // body to body, except head and plate
  double partMm = 2.0;   // body to printed part, except the head
  double headMm = 0.0;   // eroded head (process::erodedHead) to plate and printed part
};

} // namespace voluta::collision
