// The library of processes and materials: those that come with the program, and the user's own, one
// JSON file each in userDataFolder().
#pragma once

#include "process/process.h"

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace voluta::process {

enum class Shelf { Processes, Materials }; // As the alternatives of LibraryItem::data

struct LibraryItem {
  std::variant<Process, Material> data;
  std::string basedOn; // id of the item that it was duplicated from; empty: none
  // Its own file states only the differences from that item (base/inherited_text.h), so that it
  // follows changes of the others. Not compared.
  bool inherits = false;

  Shelf shelf() const { return static_cast<Shelf>(data.index()); }
  const std::string& id() const;
  const std::string& label() const;
  const Process* process() const { return std::get_if<Process>(&data); }
  LibraryItem named(const std::string& id, const std::string& label) const;
};
bool operator==(const LibraryItem& a, const LibraryItem& b);

// Returns the ids of a shelf, sorted.
std::vector<std::string> libraryIds(Shelf shelf);
bool comesWithProgram(Shelf shelf, const std::string& id);

// Throws as readProcessText() and readMaterialText(). `name` names the text in errors.
LibraryItem readItem(Shelf shelf, const std::string& text, const std::string& name);
std::string itemText(const LibraryItem& item);
// `choice`: an id, a file that ends with ".json", or the text of one. Throws Error{Usage} for an
// unknown id, naming the nearest; else as readItem().
LibraryItem loadItem(Shelf shelf, const std::string& choice);

// Returns the label for a list of items: of one that cannot be read, the reason.
std::string labelOrProblem(Shelf shelf, const std::string& id);

// Writes an own item, replacing one with the same id, and returns its file. One that inherits, and
// whose parent is in the library, is written as its differences. Throws Error{UnusableInput} if the
// id is no file name or that of an item that comes with the program, or if the item cannot be read
// back; Error{CannotWrite}.
std::filesystem::path saveOwn(const LibraryItem& item);
// Checks a file and saves it as own item. Throws as readItem(), checkItem() and saveOwn().
std::filesystem::path importItem(Shelf shelf, const std::filesystem::path& file);
// Gives an own item another id; those that inherit from it then inherit from the new one. Throws as
// saveOwn() and removeOwn().
void renameOwn(const LibraryItem& item, const std::string& id);
// Deletes the file of an own item. Those that inherit from it keep their values. Throws
// Error{UnusableInput} for one that comes with the program, Error{CannotWrite} if it cannot be
// deleted.
void removeOwn(Shelf shelf, const std::string& id);
// Throws Error{UnusableInput} if saveOwn() would refuse the id. `where` names its place in errors.
void checkOwnId(Shelf shelf, const std::string& id, const std::string& where);

// Throws Error{UnusableInput} if the id is no file name, or if the beads of a process do not fit
// its nozzle: all narrower than half of it, or all wider than ten times it. `where` names the item.
void checkItem(const LibraryItem& item, const std::string& where);

// Returns a copy with an id that is free. It inherits from the item if that is in the library.
LibraryItem duplicateOf(const LibraryItem& item);

// Returns the choice that a job stores for a process: the id of one that comes with the program,
// the text of an own one, so that projects need no file of the user's.
std::string jobChoice(const LibraryItem& process);

} // namespace voluta::process
