#include "base/error.h"
#include "project/message_json.h"
#include "project/report.h"
#include "project/report_fields.h"

#include <limits>
#include <nlohmann/json.hpp>
#include <type_traits>

namespace voluta::project {

namespace {
using Json = nlohmann::ordered_json;

Eigen::Vector3d point(const Json& j) {
  return {j.at(0).get<double>(), j.at(1).get<double>(), j.at(2).get<double>()};
}

template <typename T> void read(const Json& j, T& value);
template <typename T> void read(const Json& j, std::vector<T>& values) {
  values.clear();
  for (const Json& row : j)
    read(row, values.emplace_back());
}
template <typename T> void read(const Json& j, T& value) {
  if constexpr (std::is_same_v<T, plan::Finding>) {
    value = readFinding(j);
  } else if constexpr (std::is_same_v<T, base::Message>) {
    value = readMessage(j);
  } else if constexpr (std::is_same_v<T, Eigen::Vector3d>) {
    value = point(j);
  } else if constexpr (std::is_same_v<T, Eigen::AlignedBox3d>) {
    value = Eigen::AlignedBox3d(point(j.at(0)), point(j.at(1)));
  } else if constexpr (HasFields<T>) {
    forEachField<T>([&](const auto& field) {
      if (!field.later || j.contains(field.key))
        read(j.at(field.key), value.*field.member);
    });
  } else if constexpr (std::is_same_v<T, double>) {
    // JSON has no NaN: it is written as null.
    value = j.is_null() ? std::numeric_limits<double>::quiet_NaN() : j.get<double>();
  } else {
    j.get_to(value);
  }
}
} // namespace

Report readReportJson(const std::string& text) {
  Report report;
  try {
    const Json j = Json::parse(text);
    read(j, report);
    if (!j.contains("items"))
      read(j, report.item());
    if (report.items.empty())
      throw base::Error(base::ErrorCode::UnreadableFile, "the report has no item"_text);
  } catch (const Json::exception& e) {
    throw base::Error(base::ErrorCode::UnreadableFile,
                      base::message("not a plan's report: {why}"_text, std::string(e.what())));
  }
  return report;
}

} // namespace voluta::project
