#include "project/message_json.h"
#include "project/milled_fields.h"
#include "project/report.h"
#include "project/report_fields.h"
#include "project/version.h"

#include <nlohmann/json.hpp>
#include <type_traits>
#include <utility>

namespace voluta::project {

namespace {
using Json = nlohmann::ordered_json;

Json pointJson(const Eigen::Vector3d& p) {
  return Json::array({p.x(), p.y(), p.z()});
}

Json boundsJson(const Eigen::AlignedBox3d& box) {
  if (box.isEmpty())
    return Json::array({pointJson(Eigen::Vector3d::Zero()), pointJson(Eigen::Vector3d::Zero())});
  return Json::array({pointJson(box.min()), pointJson(box.max())});
}

// Returns whether a list has an entry per item and the job has one item. Reports of one item do not
// have such lists.
template <typename T> bool isOfOneItem(const T&) {
  return false;
}
bool isOfOneItem(const std::vector<plan::ItemToolpaths>& items) {
  return items.empty();
}
bool isOfOneItem(const std::vector<ItemReplayReport>& items) {
  return items.empty();
}

template <typename T> Json json(const T& value);
template <typename T> Json json(const std::vector<T>& values) {
  Json list = Json::array();
  for (const T& value : values)
    list.push_back(json(value));
  return list;
}
template <typename T> Json json(const T& value) {
  if constexpr (std::is_same_v<T, plan::Finding>) {
    return findingJson(value);
  } else if constexpr (std::is_same_v<T, base::Message>) {
    return Json(base::english(value));
  } else if constexpr (std::is_same_v<T, Eigen::Vector3d>) {
    return pointJson(value);
  } else if constexpr (std::is_same_v<T, Eigen::AlignedBox3d>) {
    return boundsJson(value);
  } else if constexpr (HasFields<T>) {
    Json object = Json::object();
    forEachField<T>([&](const auto& field) {
      if (!isOfOneItem(value.*field.member))
        object[field.key] = json(value.*field.member);
    });
    return object;
  } else {
    return Json(value);
  }
}

std::string textOf(Json report) {
  report["version"] = kVersion;
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}
} // namespace

Timings& Timings::operator+=(const Timings& more) {
  forEachField<Timings>([&](const auto& field) { this->*field.member += more.*field.member; });
  return *this;
}

std::string reportJson(const Report& report) {
  // The first item's figures are at the top too: reports had one item only.
  Json all = json(static_cast<const VerdictReport&>(report));
  all.update(json(report.item()));
  all.update(json(report));
  return textOf(std::move(all));
}

std::string reportJson(const MilledReport& report) {
  return textOf(json(report));
}

} // namespace voluta::project
