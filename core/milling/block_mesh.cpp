#include "milling/block_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace voluta::milling {

namespace {

// Columns of the block at every `stride`-th cell.
class Columns {
public:
  Columns(const Stock& stock, int stride)
      : stock_(stock), stride_(stride), countX_((stock.grid().countX - 1) / stride + 1),
        countY_((stock.grid().countY - 1) / stride + 1),
        vertex_(static_cast<std::size_t>(countX_) * static_cast<std::size_t>(countY_), -1) {}

  geometry::TriangleMesh mesh() {
    for (int j = 0; j + 1 < countY_; ++j)
      for (int i = 0; i + 1 < countX_; ++i)
        if (isSquare(i, j))
          addSquare(i, j);
    return std::move(mesh_);
  }

private:
  std::size_t cell(int i, int j) const { return stock_.grid().index(i * stride_, j * stride_); }
  bool isSolid(int i, int j) const { return stock_.highAt(cell(i, j)) > stock_.lowAt(cell(i, j)); }
  // Whether the square with its least corner at a column has four of them.
  bool isSquare(int i, int j) const {
    return i >= 0 && j >= 0 && i + 1 < countX_ && j + 1 < countY_ && isSolid(i, j) &&
           isSolid(i + 1, j) && isSolid(i, j + 1) && isSolid(i + 1, j + 1);
  }

  // Returns the vertex at the column's top; the next one is at its bottom.
  int top(int i, int j) {
    int& at = vertex_[static_cast<std::size_t>(j) * static_cast<std::size_t>(countX_) +
                      static_cast<std::size_t>(i)];
    if (at < 0) {
      at = static_cast<int>(mesh_.vertices.size());
      const Eigen::Vector2d middle = stock_.grid().middle(i * stride_, j * stride_);
      mesh_.vertices.emplace_back(middle.x(), middle.y(), stock_.highAt(cell(i, j)));
      mesh_.vertices.emplace_back(middle.x(), middle.y(), stock_.lowAt(cell(i, j)));
    }
    return at;
  }
  void addQuad(int a, int b, int c, int d) {
    mesh_.triangles.push_back({a, b, c});
    mesh_.triangles.push_back({a, c, d});
  }

  void addSquare(int i, int j) {
    const std::array<int, 4> corner{top(i, j), top(i + 1, j), top(i + 1, j + 1), top(i, j + 1)};
    const std::array<bool, 4> isOpen{!isSquare(i, j - 1), !isSquare(i + 1, j), !isSquare(i, j + 1),
                                     !isSquare(i - 1, j)};
    addQuad(corner[0], corner[1], corner[2], corner[3]);
    addQuad(corner[0] + 1, corner[3] + 1, corner[2] + 1, corner[1] + 1);
    for (std::size_t k = 0; k < 4; ++k)
      if (isOpen[k]) {
        const int a = corner[k], b = corner[(k + 1) % 4];
        addQuad(b, a, a + 1, b + 1);
      }
  }

  const Stock& stock_;
  int stride_, countX_, countY_;
  std::vector<int> vertex_; // per column; -1: none yet
  geometry::TriangleMesh mesh_;
};

} // namespace

geometry::TriangleMesh meshOf(const Stock& stock, std::size_t maxColumns) {
  const double share = static_cast<double>(stock.grid().size()) / static_cast<double>(maxColumns);
  const int stride = std::max(1, static_cast<int>(std::ceil(std::sqrt(share))));
  return Columns(stock, stride).mesh();
}

} // namespace voluta::milling
