// The items of one shelf of the library while they are edited: each as saved, and as typed.
#pragma once

#include "process/library_fields.h"

#include <QString>
#include <optional>
#include <string>
#include <vector>

namespace voluta::window {

enum class ItemOrigin { Program, Own, Job };

struct ShelfEntry {
  process::LibraryItem saved, draft;
  ItemOrigin origin = ItemOrigin::Program;
  QString unreadable; // Why its file cannot be used; empty: it can
  int depth = 0;      // Number of own entries that it inherits from

  bool isChanged() const { return !(saved == draft); }
};

class LibraryShelf {
public:
  // `jobText`: the text of the job's process, listed too if the library has another of that id or
  // none; empty: none.
  LibraryShelf(process::Shelf shelf, std::string jobText);

  process::Shelf shelf() const { return shelf_; }
  // Reads the files again; drafts of items that are still there are kept. Own items that inherit
  // from another own one come below it.
  void reload();
  const std::vector<ShelfEntry>& entries() const { return entries_; }
  // -1: none.
  int indexOf(const std::string& id) const;
  bool anyChanged() const;

  void setDraft(int index, const process::LibraryItem& draft);
  void revert(int index) { setDraft(index, at(index).saved); }
  // All below write files and throw as process::saveOwn() and removeOwn(); reload() afterwards.
  void save(int index);
  // Returns the id of the copy.
  std::string duplicate(int index) const;
  void rename(int index, const std::string& id);
  void remove(int index) const;

  const ShelfEntry& at(int index) const { return entries_[static_cast<std::size_t>(index)]; }
  // The item that the entry is compared with: the one it is based on, else itself as saved.
  process::LibraryItem referenceOf(int index) const;

private:
  process::Shelf shelf_;
  std::string jobText_;
  std::vector<ShelfEntry> entries_;
};

} // namespace voluta::window
