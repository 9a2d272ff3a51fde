// Follows a G-code file of a printer line by line, as its firmware does (Marlin's meanings of the
// words).
#pragma once

#include "sliced/sliced_file.h"

#include <string>
#include <string_view>

namespace voluta::base {
class RunContext;
}

namespace voluta::sliced {

// Reads the beads of a file.
// - Absolute and relative positions and filament lengths, also after G92; inches; arcs in the plane
//   of x and y by centre or radius, with a rising z; retraction by E or by G10 and G11; M200
//   (volumes instead of lengths), M220 and M221 (percentages of speed and flow).
// - With G91 filament lengths are relative too; G90 leaves them as M82 and M83 set them.
// - B C: angles of a table that tilts and turns; G93 (F is an inverse time), G92 C.
// - nX nY nZ: direction of the nozzle. T: tool of the paths that follow.
// - M104, M109, M140, M190: temperatures that the file sets.
// - Filament that a tool draws back returns to the same tool, unless a setting says that all tools
//   share a nozzle.
// - Stops of the print are listed in SlicedFile::stops.
// - Other M commands, macros and G commands that do not move are skipped; those that change the
//   print are named in SlicedFile::unused.
// - Purge lines beside the part are left out.
// - A file whose last line has no line end, and is a motion or follows the last bead without an M
//   command, is taken as it is, with its last line in SlicedFile::cutLine.
//
// Throws Error{UnreadableFile} with the line for a motion that is not understood, a position beyond
// a kilometre, a bead from an unknown position, a bead behind the end of the program, an M200
// between beads; Error{UnusableInput} for too many points; Cancelled. `name`: of the file, for
// errors.
SlicedFile followGcode(std::string_view text, const std::string& name, const base::RunContext& ctx);

} // namespace voluta::sliced
