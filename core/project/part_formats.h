// The formats of files that a part can be read from.
#pragma once

#include "base/text.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace voluta::base {
class RunContext;
}

namespace voluta::project {

struct LoadedPart;

enum class PartContent { Mesh, Voxels, SlicedPaths };

struct PartFormat {
  std::string_view ending; // of the file's name, lower case, with its dot
  std::string_view name;
  PartContent content = PartContent::Mesh;
  bool holdsSeveral = false; // parts
  bool foreign = false;      // a mesh that a separate program reads
  base::Text holds;          // contents and limits
  // Reads what the file has into a part: its mesh or cells, tool-paths and notes. Throws
  // Error{UnreadableFile, UnusableInput}, Cancelled.
  void (*read)(const std::string& file, LoadedPart& part, const base::RunContext& ctx);
};

const std::vector<PartFormat>& partFormats();
// Returns nullptr if no format has the ending of that name.
const PartFormat* partFormatOf(const std::filesystem::path& file);
// Returns the format of a file by the ending of its name, or else by its content. Throws
// Error{UnreadableFile} if a file of unknown ending cannot be read, is a project, or has no format
// of the table.
const PartFormat& detectedFormat(const std::string& file);

// Returns whether a file of that name holds a slicer's tool-paths.
bool isSlicedFile(const std::string& name);

enum class NamedFiles {
  Parts,     // all formats
  Meshes,    // formats with a reader in this program
  AllMeshes, // with foreign ones
};
// Returns patterns of file names, separated by blanks: "*.stl *.obj".
std::string filePatterns(NamedFiles files);

} // namespace voluta::project
