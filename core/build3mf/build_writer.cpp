#include "build3mf/build_writer.h"

#include "base/error.h"
#include "base/markup.h"
#include "base/run_context.h"
#include "build3mf/build_names.h"
#include "geometry/formats/threemf_package.h"
#include "geometry/formats/zip_writer.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <fmt/format.h>
#include <iterator>
#include <limits>
#include <vector>

namespace voluta::build3mf {

using Eigen::Quaterniond;
using Eigen::Vector3d;

namespace {

constexpr double kFarthestMm = 2e5; // Still fits a 32-bit number in units of kUnitMm
constexpr const char* kHead = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
constexpr const char* kModelPart = "3D/3dmodel.model";

using Text = std::back_insert_iterator<std::string>;

// FNV-1a; two hashes with different seeds form the bits of a UUID.
std::uint64_t hashOf(std::string_view bytes, std::uint64_t hash) {
  for (const char c : bytes)
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
  return hash ^ hash >> 29;
}

// A name-based UUID (RFC 4122, version 8: custom), so that equal plans get equal ones.
std::string uuidOf(const std::string& of) {
  const std::uint64_t a = hashOf(of, 0xcbf29ce484222325ull), b = hashOf(of, 0x9e3779b97f4a7c15ull);
  return fmt::format("{:08x}-{:04x}-8{:03x}-{:04x}-{:012x}", a >> 32, a >> 16 & 0xffff, a & 0xfff,
                     0x8000 | (b >> 48 & 0x3fff), b & 0xffffffffffffull);
}

// For attributes or text; control characters are not allowed in XML.
std::string escaped(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20)
      c = ' ';
  return base::escapedMarkup(text);
}

long long unitsOf(double mm) {
  return std::llround(mm / kUnitMm);
}

struct Range {
  double minimum = std::numeric_limits<double>::infinity(), maximum = -minimum;
  void take(double value) {
    minimum = std::min(minimum, value);
    maximum = std::max(maximum, value);
  }
  bool varies() const { return maximum > minimum; }
  double factorOf(double value) const {
    return std::clamp((value - minimum) / (maximum - minimum), 0.0, 1.0);
  }
};

struct Profile {
  std::array<Range, 3> ranges; // In the order of Modulated
  bool used = false;
  std::string uuid;
};
using KindProfiles = std::array<Profile, kKindNames.size()>;

std::size_t indexOf(plan::PathKind kind) {
  return static_cast<std::size_t>(kind);
}

void check(const plan::ToolPlan& plan, const geometry::TriangleMesh& part) {
  const std::size_t n = plan.waypointCount();
  base::require(plan.direction.size() == n && plan.widthMm.size() == n &&
                    plan.heightMm.size() == n && plan.speedMmPerS.size() == n,
                "plan arrays of one length");
  base::require(!part.empty(), "the part has triangles");
  for (const plan::ToolPath& path : plan.paths)
    base::require(path.count >= 2 && path.first + path.count <= n, "paths inside the plan");
  for (const Vector3d& p : plan.position)
    if (!(p.cwiseAbs().maxCoeff() < kFarthestMm))
      throw base::Error(base::ErrorCode::CannotWrite,
                        "a tool-path is beyond the range of a build file"_text);
}

KindProfiles profilesOf(const plan::ToolPlan& plan, const std::string& seed) {
  KindProfiles profiles;
  for (const plan::ToolPath& path : plan.paths) {
    Profile& profile = profiles[indexOf(path.kind)];
    profile.used = true;
    for (std::size_t i = path.first; i < path.first + path.count; ++i) {
      base::require(plan.widthMm[i] > 0.0f && plan.heightMm[i] > 0.0f, "a bead has a section");
      profile.ranges[0].take(plan.widthMm[i]);
      profile.ranges[1].take(plan.heightMm[i]);
      if (i == path.first)
        continue; // Nothing is printed on the way there
      base::require(plan.speedMmPerS[i] > 0.0f, "a bead has a speed");
      profile.ranges[2].take(plan.speedMmPerS[i]);
    }
  }
  for (std::size_t k = 0; k < profiles.size(); ++k)
    profiles[k].uuid = uuidOf(fmt::format("{} profile {}", seed, k));
  return profiles;
}

// Paths [first, last) of one layer part.
struct LayerPart {
  std::size_t first = 0, last = 0;
  std::string member() const { return fmt::format("Toolpath/Layers/layer{:05}.xml", number); }
  std::size_t number = 0;
};

std::vector<LayerPart> layerPartsOf(const plan::ToolPlan& plan) {
  // Maximum number of members in a zip without the 64-bit extension, minus the parts that are not
  // layers. If there are more layers, consecutive ones share a part.
  constexpr std::size_t kMax = 60000;
  std::size_t stretches = 0;
  for (std::size_t p = 0; p < plan.paths.size(); ++p)
    stretches += p == 0 || plan.paths[p].layer != plan.paths[p - 1].layer;
  const std::size_t together = stretches / kMax + 1;
  std::vector<LayerPart> parts;
  std::size_t inPart = together;
  for (std::size_t p = 0; p < plan.paths.size(); ++p) {
    if (p == 0 || plan.paths[p].layer != plan.paths[p - 1].layer)
      if (inPart++ == together) {
        parts.push_back({p, p, parts.size() + 1});
        inPart = 1;
      }
    parts.back().last = p + 1;
  }
  return parts;
}

// Returns the frame with its z along `direction` that is rotated least from `before`.
Quaterniond frameAlong(const Vector3d& direction, const Quaterniond& before) {
  return (Quaterniond::FromTwoVectors(before * Vector3d::UnitZ(), direction) * before).normalized();
}

void addFactors(Text out, const Profile& profile, const plan::ToolPlan& plan, std::size_t i) {
  const auto linear = [&](std::size_t k, char factor, float from, float to) {
    const Range& range = profile.ranges[k];
    if (!range.varies())
      return;
    if (from == to)
      fmt::format_to(out, " {}=\"{:.7g}\"", factor, range.factorOf(to));
    else
      fmt::format_to(out, " {}1=\"{:.7g}\" {}2=\"{:.7g}\"", factor, range.factorOf(from), factor,
                     range.factorOf(to));
  };
  linear(0, kFactors[0], plan.widthMm[i - 1], plan.widthMm[i]);
  linear(1, kFactors[1], plan.heightMm[i - 1], plan.heightMm[i]);
  linear(2, kFactors[2], plan.speedMmPerS[i], plan.speedMmPerS[i]);
}

// The expected duration, in microseconds.
long long microsecondsOf(const plan::ToolPlan& plan, const plan::ToolPath& path) {
  double seconds = 0.0;
  for (std::size_t i = path.first + 1; i < path.first + path.count; ++i)
    seconds += (plan.position[i] - plan.position[i - 1]).norm() / plan.speedMmPerS[i];
  return std::llround(std::min(1e6 * seconds, 2147483647.0));
}

void addSegment(Text out, const plan::ToolPlan& plan, const plan::ToolPath& path,
                const Profile& profile) {
  fmt::format_to(out,
                 "  <segment type=\"polyline6d\" profileid=\"{}\" partid=\"1\" "
                 "timeprediction=\"{}\" v:layer=\"{}\" v:patch=\"{}\" v:group=\"{}\"{}>\n",
                 indexOf(path.kind) + 1, microsecondsOf(plan, path), path.layer, path.patch,
                 path.group, path.closed ? " v:closed=\"true\"" : "");
  Quaterniond frame = Quaterniond::Identity();
  for (std::size_t i = path.first; i < path.first + path.count; ++i) {
    frame = frameAlong(plan.direction[i], frame);
    const Vector3d& p = plan.position[i];
    fmt::format_to(out,
                   "   <point6d x=\"{}\" y=\"{}\" z=\"{}\" i=\"{:.10g}\" j=\"{:.10g}\" "
                   "k=\"{:.10g}\" w=\"{:.10g}\"",
                   unitsOf(p.x()), unitsOf(p.y()), unitsOf(p.z()), frame.x(), frame.y(), frame.z(),
                   frame.w());
    if (i > path.first)
      addFactors(out, profile, plan, i);
    fmt::format_to(out, "/>\n");
  }
  fmt::format_to(out, "  </segment>\n");
}

std::string layerXml(const plan::ToolPlan& plan, const LayerPart& part,
                     const KindProfiles& profiles, const std::string& itemUuid) {
  std::string text = kHead;
  Text out(text);
  fmt::format_to(out,
                 "<layer xmlns=\"{}\" xmlns:v=\"{}\">\n <parts><part id=\"1\" uuid=\"{}\"/>"
                 "</parts>\n <profiles>\n",
                 kToolpathSpace, kOwnSpace, itemUuid);
  std::array<bool, kKindNames.size()> used{};
  for (std::size_t p = part.first; p < part.last; ++p)
    used[indexOf(plan.paths[p].kind)] = true;
  for (std::size_t k = 0; k < used.size(); ++k)
    if (used[k])
      fmt::format_to(out, "  <profile id=\"{}\" uuid=\"{}\"/>\n", k + 1, profiles[k].uuid);
  fmt::format_to(out, " </profiles>\n <segments>\n");
  for (std::size_t p = part.first; p < part.last; ++p)
    addSegment(out, plan, plan.paths[p], profiles[indexOf(plan.paths[p].kind)]);
  fmt::format_to(out, " </segments>\n</layer>\n");
  return text;
}

void addProfiles(Text out, const KindProfiles& profiles) {
  fmt::format_to(out, "   <tp:toolpathprofiles>\n");
  for (std::size_t k = 0; k < profiles.size(); ++k) {
    const Profile& profile = profiles[k];
    if (!profile.used)
      continue;
    fmt::format_to(out, "    <tp:toolpathprofile uuid=\"{}\" name=\"{}\"", profile.uuid,
                   kKindNames[k]);
    for (std::size_t m = 0; m < kModulatedNames.size(); ++m)
      fmt::format_to(out, " {}=\"{}\"", kModulatedNames[m], profile.ranges[m].maximum);
    fmt::format_to(out, " v:kind=\"{}\">\n", kKindNames[k]);
    for (std::size_t m = 0; m < kModulatedNames.size(); ++m)
      if (profile.ranges[m].varies())
        fmt::format_to(out,
                       "     <tp:modifier attribute=\"{}\" type=\"{}\" minvalue=\"{}\" "
                       "maxvalue=\"{}\" factor=\"{}\"/>\n",
                       kModulatedNames[m], m == 2 ? "constant" : "linear",
                       profile.ranges[m].minimum, profile.ranges[m].maximum, kFactors[m]);
    fmt::format_to(out, "    </tp:toolpathprofile>\n");
  }
  fmt::format_to(out, "   </tp:toolpathprofiles>\n");
}

void addMesh(Text out, const geometry::TriangleMesh& part) {
  fmt::format_to(out, "   <mesh>\n    <vertices>\n");
  for (const Vector3d& v : part.vertices)
    fmt::format_to(out, "     <vertex x=\"{:.10g}\" y=\"{:.10g}\" z=\"{:.10g}\"/>\n", v.x(), v.y(),
                   v.z());
  fmt::format_to(out, "    </vertices>\n    <triangles>\n");
  for (const auto& t : part.triangles)
    fmt::format_to(out, "     <triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>\n", t[0], t[1], t[2]);
  fmt::format_to(out, "    </triangles>\n   </mesh>\n");
}

std::string modelXml(const geometry::TriangleMesh& part, const std::string& name,
                     const KindProfiles& profiles, const std::vector<LayerPart>& layers,
                     const std::string& seed, const std::string& itemUuid) {
  std::string text = kHead;
  Text out(text);
  fmt::format_to(out,
                 "<model unit=\"millimeter\" xml:lang=\"en-US\" xmlns=\"{}\" xmlns:p=\"{}\" "
                 "xmlns:tp=\"{}\" xmlns:v=\"{}\" requiredextensions=\"p tp\">\n"
                 " <metadata name=\"Title\">{}</metadata>\n"
                 " <metadata name=\"Application\">Voluta</metadata>\n <resources>\n",
                 kCoreSpace, kProductionSpace, kToolpathSpace, kOwnSpace, escaped(name));
  fmt::format_to(out,
                 "  <tp:toolpathresource id=\"1\" uuid=\"{}\" unitfactor=\"{}\" "
                 "toolpathtype=\"6axis\">\n",
                 uuidOf(seed + " resource"), kUnitMm);
  addProfiles(out, profiles);
  fmt::format_to(out, "   <tp:toolpathlayers>\n");
  for (const LayerPart& layer : layers)
    fmt::format_to(out, "    <tp:toolpathlayer path=\"/{}\"/>\n", layer.member());
  fmt::format_to(out, "   </tp:toolpathlayers>\n   <tp:toolpathdata><v:plan frame=\"work\"/>"
                      "</tp:toolpathdata>\n  </tp:toolpathresource>\n");
  fmt::format_to(out, "  <object id=\"2\" type=\"model\" p:UUID=\"{}\">\n",
                 uuidOf(seed + " object"));
  addMesh(out, part);
  fmt::format_to(out,
                 "  </object>\n </resources>\n <build p:UUID=\"{}\" tp:toolpathid=\"1\">\n"
                 "  <item objectid=\"2\" p:UUID=\"{}\"/>\n </build>\n</model>\n",
                 uuidOf(seed + " build"), itemUuid);
  return text;
}

void addRelations(geometry::ZipWriter& zip, const std::vector<LayerPart>& layers) {
  constexpr const char* kSpace = "http://schemas.openxmlformats.org/package/2006/";
  std::string types = kHead;
  fmt::format_to(Text(types),
                 "<Types xmlns=\"{}content-types\">"
                 "<Default Extension=\"rels\" ContentType=\"application/"
                 "vnd.openxmlformats-package.relationships+xml\"/>"
                 "<Default Extension=\"model\" ContentType=\"application/"
                 "vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>"
                 "<Default Extension=\"xml\" ContentType=\"application/xml\"/></Types>\n",
                 kSpace);
  zip.add("[Content_Types].xml", types);
  std::string root = kHead;
  fmt::format_to(Text(root),
                 "<Relationships xmlns=\"{}relationships\"><Relationship Target=\"/{}\" "
                 "Id=\"rel0\" Type=\"{}\"/></Relationships>\n",
                 kSpace, kModelPart, kModelRelation);
  zip.add("_rels/.rels", root);
  std::string ofModel = kHead;
  fmt::format_to(Text(ofModel), "<Relationships xmlns=\"{}relationships\">\n", kSpace);
  for (const LayerPart& layer : layers)
    fmt::format_to(Text(ofModel), "<Relationship Target=\"/{}\" Id=\"rel{}\" Type=\"{}\"/>\n",
                   layer.member(), layer.number, geometry::kToolpathLayerRelation);
  ofModel += "</Relationships>\n";
  zip.add("3D/_rels/3dmodel.model.rels", ofModel);
}

} // namespace

std::string writeBuild(const plan::ToolPlan& plan, const geometry::TriangleMesh& part,
                       const std::string& name, const base::RunContext& ctx) {
  check(plan, part);
  std::string seed = name;
  for (const Vector3d& p : plan.position)
    seed.append(reinterpret_cast<const char*>(p.data()), 3 * sizeof(double));
  seed = fmt::format("{:016x}{:016x}", hashOf(seed, 0xcbf29ce484222325ull), hashOf(seed, 1));
  const KindProfiles profiles = profilesOf(plan, seed);
  const std::vector<LayerPart> layers = layerPartsOf(plan);
  const std::string itemUuid = uuidOf(seed + " item");
  geometry::ZipWriter zip;
  addRelations(zip, layers);
  zip.add(kModelPart, modelXml(part, name, profiles, layers, seed, itemUuid));
  for (const LayerPart& layer : layers) {
    ctx.checkpoint();
    zip.add(layer.member(), layerXml(plan, layer, profiles, itemUuid));
  }
  return zip.take();
}

} // namespace voluta::build3mf
