// An array of numbers that are initially 0. Only pages that are written to take memory: a lattice
// over a box costs only its filled part.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace voluta::base {

template <typename T>
requires std::is_arithmetic_v<T>
class ZeroedArray {
public:
  ZeroedArray() = default;
  // Throws std::bad_alloc.
  explicit ZeroedArray(std::size_t size)
      : size_(size), data_(static_cast<T*>(std::calloc(size, sizeof(T)))) {
    if (size > 0 && !data_)
      throw std::bad_alloc();
  }

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  T& operator[](std::size_t i) { return data_.get()[i]; }
  const T& operator[](std::size_t i) const { return data_.get()[i]; }
  T* begin() { return data_.get(); }
  T* end() { return data_.get() + size_; }
  const T* begin() const { return data_.get(); }
  const T* end() const { return data_.get() + size_; }

  // Call before element i is read and then written, from any thread. If an untouched page is read
  // first, the kernel maps it twice and stops the other threads to take the first mapping back.
  void prepare(std::size_t i) {
    T zero{0};
    std::atomic_ref<T>(data_.get()[i])
        .compare_exchange_strong(zero, T{0}, std::memory_order_relaxed);
  }

  friend bool operator==(const ZeroedArray& a, const ZeroedArray& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
  }

private:
  struct Free {
    void operator()(T* data) const { std::free(data); }
  };
  std::size_t size_ = 0;
  std::unique_ptr<T, Free> data_;
};

} // namespace voluta::base
