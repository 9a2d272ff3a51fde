#include "project/content_hash.h"

#include <cstdint>
#include <fmt/format.h>

namespace voluta::project {

namespace {
std::uint64_t hashed(std::string_view bytes) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char byte : bytes) {
    hash ^= static_cast<unsigned char>(byte);
    hash *= 0x100000001b3u;
  }
  return hash;
}

template <typename T> std::string_view bytesOf(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}
} // namespace

std::string contentHash(std::string_view bytes) {
  return fmt::format("{:016x}", hashed(bytes));
}

std::string contentHash(const geometry::TriangleMesh& mesh) {
  return fmt::format("{}:{:016x}:{}:{:016x}", mesh.vertices.size(), hashed(bytesOf(mesh.vertices)),
                     mesh.triangles.size(), hashed(bytesOf(mesh.triangles)));
}

std::string contentHash(const plan::ToolPlan& plan) {
  std::string text;
  for (const plan::ToolPath& p : plan.paths)
    text += fmt::format("{} {} {} {} {} {} {}\n", p.first, p.count, static_cast<int>(p.kind),
                        p.layer, p.patch, p.group, p.closed);
  for (const plan::ToolPath& p : plan.paths)
    if (p.tool != 0) // Files of one tool keep their hash
      text += fmt::format("tool {} {}\n", p.first, p.tool);
  if (!plan.isSolid())
    for (const plan::FillIntent& fill : plan.fill)
      text += fmt::format("{} {}\n", fill.shellMm, fill.openMm3);
  for (const plan::Insert& insert : plan.inserts)
    text += fmt::format("insert {} {} {} {}\n", insert.name, insert.item, insert.layer,
                        contentHash(*insert.body));
  text += bytesOf(plan.position);
  text += bytesOf(plan.direction);
  for (const auto* values : {&plan.widthMm, &plan.heightMm, &plan.speedMmPerS})
    text += bytesOf(*values);
  return contentHash(text);
}

} // namespace voluta::project
