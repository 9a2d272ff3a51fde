// Lines beside the part that fill the nozzle before it prints.
#pragma once

#include "sliced/sliced_file.h"

namespace voluta::sliced {

// Leaves out purge lines that no comment marks: the file's first beads, if they are a few long
// straight lines at one height, at least 5 mm beside all later beads, and those have several
// layers. Sets SlicedFile::purged.
void leaveOutPurgeLines(SlicedFile& file);

} // namespace voluta::sliced
