// Rendering of a scene to images without a window: uses a surfaceless EGL context, so that the
// result does not depend on a display.
#pragma once

#include "scene/scene.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace voluta::scene {

// Rows from the top, three bytes per pixel.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

class OffscreenTarget {
public:
  // Throws Error{UnusableInput} if the machine does not provide OpenGL 3.2.
  OffscreenTarget();
  ~OffscreenTarget();
  OffscreenTarget(const OffscreenTarget&) = delete;
  OffscreenTarget& operator=(const OffscreenTarget&) = delete;

  // Renders an image; width, height in [16, 8192]. `placeCamera` is called once the scene knows the
  // image's aspect ratio (which frameAll() and similar functions need). Each pixel is the mean of
  // samples x samples (1 or more); text keeps its size. Throws Error{Usage} for a size out of
  // range. Must be called on the thread that created the target; the scene's renderer must not
  // belong to another window.
  Image imageOf(Scene& scene, int width, int height, const std::function<void()>& placeCamera = {},
                int samples = 2);

  // Keeps a scene in the target for drawing many frames. As imageOf with one sample per pixel.
  class Session {
  public:
    Session(OffscreenTarget& target, Scene& scene, int width, int height);
    ~Session();
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    // Draws a frame and waits until it is finished.
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

// Returns the image as PNG data.
std::string pngBytes(const Image& image);

} // namespace voluta::scene
