#include "viewer/camera_control.h"

#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

namespace voluta::viewer {
namespace {

using Eigen::Vector3d;

class CameraControlTest : public testing::Test {
protected:
  vtkSmartPointer<vtkRenderer> renderer_ = vtkSmartPointer<vtkRenderer>::New();
  CameraControl camera_{renderer_};
};

TEST_F(CameraControlTest, EverySideIsSeenUpright) {
  const std::pair<Vector3d, Vector3d> sides[] = {{{0, -1, 0}, {0, 0, 1}},
                                                 {{1, 0, 0}, {0, 0, 1}},
                                                 {{0, 0, 1}, {0, 1, 0}},
                                                 {{0, 0, -1}, {0, -1, 0}}};
  for (const auto& [from, up] : sides) {
    camera_.viewFrom(from);
    EXPECT_LT((camera_.axes().col(2) - from).norm(), 1e-9) << from.transpose();
    EXPECT_LT((camera_.axes().col(1) - up).norm(), 1e-9) << from.transpose();
  }
}

TEST_F(CameraControlTest, LeavingThePoleKeepsTheRightDirection) {
  camera_.viewFrom({0, 0, 1});
  camera_.orbit(0.0, 20.0);
  EXPECT_GT(camera_.axes().col(0).x(), 0.99);
  camera_.viewFrom({0, 0, -1});
  camera_.orbit(0.0, -20.0);
  EXPECT_GT(camera_.axes().col(0).x(), 0.99);
}

TEST_F(CameraControlTest, OrbitKeepsClearOfThePole) {
  camera_.viewFrom({0.5, -0.7, 0.4});
  for (int i = 0; i < 100; ++i) {
    camera_.orbit(3.0, -7.0);
    EXPECT_LT(std::abs(camera_.axes().col(2).z()), 0.999);
  }
}

} // namespace
} // namespace voluta::viewer
