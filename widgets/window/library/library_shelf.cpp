#include "window/library/library_shelf.h"

#include "base/data_files.h"
#include "base/error.h"
#include "language/words.h"

#include <algorithm>

namespace voluta::window {

using process::LibraryItem;
using process::Shelf;

namespace {
ShelfEntry entryOf(Shelf shelf, const std::string& id) {
  ShelfEntry entry;
  entry.origin = process::comesWithProgram(shelf, id) ? ItemOrigin::Program : ItemOrigin::Own;
  try {
    entry.saved = process::loadItem(shelf, id);
  } catch (const base::Error& error) {
    LibraryItem empty;
    if (shelf == Shelf::Materials)
      empty.data = process::Material();
    entry.saved = empty.named(id, id);
    entry.unreadable = language::words(error.whole());
  }
  entry.draft = entry.saved;
  return entry;
}
bool isBelow(const ShelfEntry& entry, const ShelfEntry& parent) {
  return entry.origin == ItemOrigin::Own && parent.origin == ItemOrigin::Own &&
         entry.saved.inherits && entry.saved.basedOn == parent.saved.id();
}

// Returns the entries with own ones that inherit from another own one below it.
std::vector<ShelfEntry> belowTheirParents(std::vector<ShelfEntry> entries) {
  std::vector<ShelfEntry> sorted;
  const auto add = [&](const auto& self, ShelfEntry& entry, int depth) -> void {
    entry.depth = depth;
    const std::size_t at = sorted.size();
    sorted.push_back(entry);
    for (ShelfEntry& other : entries)
      if (isBelow(other, sorted[at]))
        self(self, other, depth + 1);
  };
  for (ShelfEntry& entry : entries)
    if (std::ranges::none_of(entries,
                             [&](const ShelfEntry& other) { return isBelow(entry, other); }))
      add(add, entry, 0);
  return sorted;
}
} // namespace

LibraryShelf::LibraryShelf(Shelf shelf, std::string jobText)
    : shelf_(shelf), jobText_(std::move(jobText)) {
  reload();
}

void LibraryShelf::reload() {
  const std::vector<ShelfEntry> before = std::exchange(entries_, {});
  for (const std::string& id : process::libraryIds(shelf_)) {
    ShelfEntry entry = entryOf(shelf_, id);
    for (const ShelfEntry& old : before)
      if (old.origin == ItemOrigin::Own && old.saved.id() == id && old.isChanged())
        entry.draft = old.draft;
    entries_.push_back(std::move(entry));
  }
  // Own ones first: they are edited most.
  std::ranges::stable_partition(
      entries_, [](const ShelfEntry& entry) { return entry.origin == ItemOrigin::Own; });
  entries_ = belowTheirParents(std::move(entries_));
  if (!base::isDataText(jobText_))
    return;
  try {
    ShelfEntry job;
    job.saved = job.draft = process::readItem(shelf_, jobText_, base::dataName(jobText_));
    job.origin = ItemOrigin::Job;
    if (std::ranges::none_of(entries_, [&](const ShelfEntry& e) { return e.saved == job.saved; }))
      entries_.insert(entries_.begin(), std::move(job));
  } catch (const base::Error&) {
    // The run reports why the job's process is unusable.
  }
}

int LibraryShelf::indexOf(const std::string& id) const {
  const auto at = std::ranges::find_if(
      entries_, [&](const ShelfEntry& entry) { return entry.saved.id() == id; });
  return at == entries_.end() ? -1 : static_cast<int>(at - entries_.begin());
}

bool LibraryShelf::anyChanged() const {
  return std::ranges::any_of(entries_, &ShelfEntry::isChanged);
}

void LibraryShelf::setDraft(int index, const LibraryItem& draft) {
  entries_[static_cast<std::size_t>(index)].draft = draft;
}

void LibraryShelf::save(int index) {
  process::saveOwn(at(index).draft);
  entries_[static_cast<std::size_t>(index)].saved = at(index).draft;
}

std::string LibraryShelf::duplicate(int index) const {
  const LibraryItem copy = process::duplicateOf(at(index).draft);
  process::saveOwn(copy);
  return copy.id();
}

void LibraryShelf::rename(int index, const std::string& id) {
  ShelfEntry& entry = entries_[static_cast<std::size_t>(index)];
  process::renameOwn(entry.saved, id);
  entry.saved = entry.saved.named(id, entry.saved.label());
  entry.draft = entry.draft.named(id, entry.draft.label());
}

void LibraryShelf::remove(int index) const {
  process::removeOwn(shelf_, at(index).saved.id());
}

LibraryItem LibraryShelf::referenceOf(int index) const {
  const ShelfEntry& entry = at(index);
  const int base = indexOf(entry.saved.basedOn);
  return entry.saved.basedOn.empty() || base < 0 || !at(base).unreadable.isEmpty() ? entry.saved
                                                                                   : at(base).saved;
}

} // namespace voluta::window
