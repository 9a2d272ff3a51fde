#include "process/library.h"

#include "base/data_files.h"
#include "base/error.h"
#include "base/files.h"
#include "base/inherited_text.h"
#include "process/process_text.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

namespace voluta::process {

namespace {
constexpr const char* kBasedOn = "basedOn";

struct ShelfRow {
  const char* folder; // Of base::dataFile()
  base::Text unknown;
  base::TextWithPlaces<1> noId, taken;
};
constexpr ShelfRow kShelves[] = {
    {"processes", "unknown process '{id}'"_text, "'{id}' cannot be a process's id"_text,
     "a process '{id}' comes with the program"_text},
    {"materials", "unknown material '{id}'"_text, "'{id}' cannot be a material's id"_text,
     "a material '{id}' comes with the program"_text}};

const ShelfRow& rowOf(Shelf shelf) {
  return kShelves[static_cast<std::size_t>(shelf)];
}

std::filesystem::path fileIn(const std::filesystem::path& folder, Shelf shelf,
                             const std::string& id) {
  return folder / rowOf(shelf).folder / (id + ".json");
}

bool isFileName(const std::string& id) {
  constexpr std::string_view kAllowed = "abcdefghijklmnopqrstuvwxyz0123456789-_.";
  return !id.empty() && id.front() != '.' && id.find_first_not_of(kAllowed) == std::string::npos;
}

void requireFileName(Shelf shelf, const std::string& id, const std::string& where) {
  if (!isFileName(id))
    throw base::Error(base::ErrorCode::UnusableInput, base::message(rowOf(shelf).noId, id), where,
                      "use small letters, digits, '-', '_' and '.'"_text);
}

std::string basedOnOf(const std::string& text) {
  const auto json = nlohmann::json::parse(text, nullptr, false);
  const auto at = json.is_object() ? json.find(kBasedOn) : json.end();
  return json.is_object() && at != json.end() && at->is_string() ? at->get<std::string>()
                                                                 : std::string();
}
} // namespace

const std::string& LibraryItem::id() const {
  return std::visit([](const auto& d) -> const std::string& { return d.id; }, data);
}

const std::string& LibraryItem::label() const {
  return std::visit([](const auto& d) -> const std::string& { return d.label; }, data);
}

LibraryItem LibraryItem::named(const std::string& id, const std::string& label) const {
  LibraryItem item = *this;
  std::visit(
      [&](auto& d) {
        d.id = id;
        d.label = label;
      },
      item.data);
  return item;
}

bool operator==(const LibraryItem& a, const LibraryItem& b) {
  if (a.shelf() != b.shelf() || a.basedOn != b.basedOn)
    return false;
  return a.process() ? sameProcess(*a.process(), *b.process())
                     : std::get<Material>(a.data) == std::get<Material>(b.data);
}

std::vector<std::string> libraryIds(Shelf shelf) {
  return base::dataFileIds(rowOf(shelf).folder);
}

bool comesWithProgram(Shelf shelf, const std::string& id) {
  std::error_code none;
  return std::filesystem::exists(fileIn(base::resourceFolder(), shelf, id), none);
}

LibraryItem readItem(Shelf shelf, const std::string& text, const std::string& name) {
  const std::string whole = base::wholeText(rowOf(shelf).folder, text, name);
  const bool inherits = !base::parentOf(text).empty();
  if (shelf == Shelf::Processes)
    return {readProcessText(whole, name), basedOnOf(whole), inherits};
  return {readMaterialText(whole, name), basedOnOf(whole), inherits};
}

std::string itemText(const LibraryItem& item) {
  const std::string text =
      item.process() ? processText(*item.process()) : materialText(std::get<Material>(item.data));
  if (item.basedOn.empty())
    return text;
  const std::size_t end = text.rfind("\n}");
  return text.substr(0, end) + ",\n  \"" + kBasedOn + "\": " + nlohmann::json(item.basedOn).dump() +
         text.substr(end);
}

LibraryItem loadItem(Shelf shelf, const std::string& choice) {
  if (base::isDataFileName(choice))
    return readItem(shelf, base::readFile(choice), choice);
  const base::DataText data = base::dataText(rowOf(shelf).folder, choice, rowOf(shelf).unknown);
  LibraryItem item = readItem(shelf, data.text, data.file.string());
  if (auto* material = std::get_if<Material>(&item.data))
    material->comesWithProgram = data.file == fileIn(base::resourceFolder(), shelf, choice);
  return item;
}

std::string labelOrProblem(Shelf shelf, const std::string& id) {
  try {
    return loadItem(shelf, id).label();
  } catch (const base::Error& error) {
    return error.what();
  }
}

void checkItem(const LibraryItem& item, const std::string& where) {
  requireFileName(item.shelf(), item.id(), where);
  const Process* p = item.process();
  if (!p || p->tape)
    return;
  constexpr double kNarrowest = 0.5, kWidest = 10.0; // Shares of the nozzle; of welded wire 7
  const double nozzle = p->nozzleDiameterMm;
  if (p->beadWidthMaxMm < kNarrowest * nozzle || p->beadWidthMinMm > kWidest * nozzle)
    throw base::Error(
        base::ErrorCode::UnusableInput,
        base::message("beads of {least} to {most} do not fit a nozzle of {nozzle}"_text,
                      base::mm(p->beadWidthMinMm), base::mm(p->beadWidthMaxMm), base::mm(nozzle)),
        where, "check nozzleDiameterMm and beadWidthMm"_text);
}

void checkOwnId(Shelf shelf, const std::string& id, const std::string& where) {
  requireFileName(shelf, id, where);
  if (comesWithProgram(shelf, id))
    throw base::Error(base::ErrorCode::UnusableInput, base::message(rowOf(shelf).taken, id), where,
                      "choose another id"_text);
}

namespace {
bool isThere(Shelf shelf, const std::string& id) {
  const std::vector<std::string> ids = libraryIds(shelf);
  return std::ranges::find(ids, id) != ids.end();
}

// Returns the text of an own item's file.
std::string fileText(const LibraryItem& item) {
  const std::string whole = itemText(item);
  if (!item.inherits || !isThere(item.shelf(), item.basedOn))
    return whole;
  const LibraryItem parent = loadItem(item.shelf(), item.basedOn);
  return base::textOfDifferences(whole, parent.id(), itemText(parent));
}

// Returns the own items that inherit from the one with that id. Files that cannot be read are left
// out.
std::vector<LibraryItem> heirsOf(Shelf shelf, const std::string& id) {
  std::vector<LibraryItem> heirs;
  for (const std::string& other : libraryIds(shelf))
    try {
      LibraryItem item = loadItem(shelf, other);
      if (item.inherits && item.basedOn == id && !comesWithProgram(shelf, other))
        heirs.push_back(std::move(item));
    } catch (const base::Error&) {
    }
  return heirs;
}
} // namespace

std::filesystem::path saveOwn(const LibraryItem& item) {
  checkOwnId(item.shelf(), item.id(), item.id());
  std::string text = fileText(item);
  if (!(readItem(item.shelf(), text, item.id() + ".json") == item))
    text = itemText(item); // a parent's file has values that cannot be told from missing ones
  const std::filesystem::path file = fileIn(base::userDataFolder(), item.shelf(), item.id());
  std::error_code none;
  std::filesystem::create_directories(file.parent_path(), none); // writeFile() reports a failure
  base::writeFile(file, text);
  return file;
}

std::filesystem::path importItem(Shelf shelf, const std::filesystem::path& file) {
  const LibraryItem item = readItem(shelf, base::readFile(file), file.string());
  checkItem(item, file.string());
  checkOwnId(shelf, item.id(), file.string());
  return saveOwn(item);
}

void renameOwn(const LibraryItem& item, const std::string& id) {
  const std::string old = item.id();
  saveOwn(item.named(id, item.label()));
  for (LibraryItem& heir : heirsOf(item.shelf(), old)) {
    heir.basedOn = id;
    saveOwn(heir);
  }
  removeOwn(item.shelf(), old);
}

void removeOwn(Shelf shelf, const std::string& id) {
  checkOwnId(shelf, id, id);
  for (LibraryItem& heir : heirsOf(shelf, id)) {
    const LibraryItem removed = loadItem(shelf, id);
    heir.inherits = removed.inherits;
    heir.basedOn = removed.basedOn;
    saveOwn(heir);
  }
  const std::filesystem::path file = fileIn(base::userDataFolder(), shelf, id);
  std::error_code failure;
  std::filesystem::remove(file, failure);
  if (failure)
    throw base::Error(base::ErrorCode::CannotWrite, "cannot be deleted"_text, file.string());
}

LibraryItem duplicateOf(const LibraryItem& item) {
  const std::vector<std::string> taken = libraryIds(item.shelf());
  const std::string stem = isFileName(item.id()) ? item.id() + "-own" : "own";
  std::string id = stem;
  int count = 1;
  while (std::ranges::find(taken, id) != taken.end())
    id = stem + "-" + std::to_string(++count);
  LibraryItem copy =
      item.named(id, item.label() + (count == 1 ? ", own" : ", own " + std::to_string(count)));
  copy.basedOn = item.id();
  copy.inherits = std::ranges::find(taken, item.id()) != taken.end();
  if (auto* material = std::get_if<Material>(&copy.data))
    material->comesWithProgram = false;
  return copy;
}

std::string jobChoice(const LibraryItem& process) {
  return comesWithProgram(Shelf::Processes, process.id()) ? process.id() : itemText(process);
}

} // namespace voluta::process
