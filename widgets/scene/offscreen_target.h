// Pictures of a scene without a window: a surfaceless EGL context of its own, the same with and
// without a display.
#pragma once

#include "scene/scene.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace voluta::scene {

// Rows from the top, three bytes a pixel.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

class OffscreenTarget {
public:
  // Throws Error{UnusableInput} where the machine gives no OpenGL 3.2.
  OffscreenTarget();
  ~OffscreenTarget();
  OffscreenTarget(const OffscreenTarget&) = delete;
  OffscreenTarget& operator=(const OffscreenTarget&) = delete;

  // width, height in [16, 8192]. `placeCamera` is called once the scene knows the picture's
  // proportions (frameAll() and its like need them). Each pixel is the mean of samples x samples
  // (1 or more); text keeps its size. Throws Error{Usage} for a size out of range. Call on the
  // thread that made the target; the scene's renderer must be in no other window.
  Image imageOf(Scene& scene, int width, int height, const std::function<void()>& placeCamera = {},
                int samples = 2);

  // A scene that stays in the target while it lives, to draw many frames of it. As imageOf with
  // one sample a pixel.
  class Session {
  public:
    Session(OffscreenTarget& target, Scene& scene, int width, int height);
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    // Draws a frame to its end.
    void draw();
    Image image() const; // of the last frame

  private:
    OffscreenTarget& target_;
    Scene& scene_;
    int width_, height_;
  };

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// PNG bytes of an image.
std::string pngBytes(const Image& image);

} // namespace voluta::scene
