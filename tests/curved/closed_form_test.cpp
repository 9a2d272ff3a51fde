// Layers of parts whose volume and levels are known in closed form.
#include "base/run_context.h"
#include "curved/curved_layers.h"
#include "curved/extraction.h"
#include "geometry/measures.h"
#include "layers/layer_checks.h"
#include "layers/synthetic.h"

#include <gtest/gtest.h>

namespace voluta {
namespace {

using Eigen::Vector2d, Eigen::Vector3d;

struct Case {
  std::string name;
  geometry::TriangleMesh part;
  test::FieldFunction field;
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
  return out << c.name;
}

double heightOf(const Vector3d& p) {
  return p.z();
}

std::vector<Case> cases() {
  using test::revolved;
  std::vector<Case> all;
  all.push_back({"box", test::box({-20, -15, 0}, {20, 15, 20.3}), heightOf});
  all.push_back(
      {"cylinder", revolved({{0, 0}, {15, 0}, {15, 25.1}, {0, 25.1}}, 96, false), heightOf});
  all.push_back({"cone", revolved({{0, 0}, {20, 0}, {0, 30}}, 96, false), heightOf});
  all.push_back(
      {"upsideDownCone", revolved({{0, 0}, {5, 0}, {20, 22}, {0, 22}}, 96, false), heightOf});
  all.push_back({"sphere", test::sphere({0, 0, 15}, 15, 48), heightOf});
  all.push_back({"tubeAroundAxis", revolved({{8, 0}, {20, 0}, {20, 30}, {8, 30}}, 96, true),
                 [](const Vector3d& p) { return p.head<2>().norm() - 8.0; }});
  all.push_back({"domeAroundPoint", revolved({{0, 0}, {20, 0}, {0, 20}}, 96, false),
                 [](const Vector3d& p) { return (p - Vector3d(0, 0, -10)).norm() - 10.0; }});
  all.push_back({"tilted", test::box({-20, -15, 0}, {20, 15, 20}),
                 [](const Vector3d& p) { return (0.9 * p.z() + 0.3 * (p.x() + 20)) / 0.95; }});
  all.push_back({"bent", test::box({-20, -10, 0}, {20, 10, 20}),
                 [](const Vector3d& p) { return p.z() * (1.0 + 0.01 * p.x() + 0.01 * p.y()); }});
  return all;
}

class ClosedForm : public testing::TestWithParam<Case> {};

TEST_P(ClosedForm, LayersHaveThePartsVolumeAndEndOnItsSurface) {
  const Case& c = GetParam();
  const auto d = test::decompositionOf(c.part, 0.8, c.field);
  const auto result =
      curved::curvedLayers(d, c.part, {0.8, 0.2, 3.0, 1.2, true}, base::RunContext({}, 2));
  const double volume = geometry::volume(c.part);
  EXPECT_NEAR(result.volumeMm3 / volume, 1.0, 0.01);
  const geometry::MeshQuery query(c.part);
  const auto boundary = layers::checkBoundaries(result.stack, query, 1e-3, {});
  for (std::size_t p = 0; p < boundary.size(); ++p) {
    EXPECT_LE(boundary[p].farthestMm, 1e-3) << "patch " << p;
    EXPECT_TRUE(boundary[p].simple) << "patch " << p;
  }
}

INSTANTIATE_TEST_SUITE_P(Parts, ClosedForm, testing::ValuesIn(cases()),
                         [](const auto& i) { return i.param.name; });

} // namespace
} // namespace voluta
