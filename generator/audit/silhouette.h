#pragma once

#include <cstdint>
#include <vector>

#include "audit/instance_index.h"
#include "base/status.h"
#include "geometry/mesh.h"

namespace collage {

/// Outlines of target and sculpture seen from one side, laid over each other.
struct SilhouettePicture {
  enum class Pixel : std::uint8_t { neither, target, both, sculpture };

  int width = 0;
  int height = 0;
  /// Row by row from the top left.
  std::vector<Pixel> pixels;

  /// Intersection over union: pixels in both ÷ pixels in either; 1 where none is.
  [[nodiscard]] double iou() const;
};

/// How well the sculpture's outlines agree with the target's, from all around.
struct Silhouette {
  struct View {
    /// Unit vector towards the viewer, who is infinitely far away.
    dvec3 direction;
    double iou = 0.0;
  };
  std::vector<View> views;
  double mean = 0.0;
  double worst = 0.0;
  dvec3 worst_direction{0.0};
  SilhouettePicture worst_picture;
};

struct SilhouetteOptions {
  int views = 42;
  /// Pixels on a side of the square pictures; at least 1.
  int resolution = 300;
};

/// Evenly spread directions on the half of the sphere above the ground (y > 0), as opposite ones
/// show the same outline: point n of a spiral that turns by the golden angle, at the middle of the
/// n-th of `count` bands of equal area (Swinbank and Purser 2006, "Fibonacci grids").
std::vector<dvec3> view_directions(int count);

/// Orthographic outlines by one ray a pixel, through its centre. +y is up in the pictures, which
/// are just as large as the box of target and sculpture together looks from there. What sticks out
/// counts against the sculpture as what is missing does. With n pixels inside, a pixel centre more
/// or less along the outline moves an iou by about 1 / √n.
/// Runs on all threads; throws Interrupted.
/// Cost: two rays a pixel, some seconds altogether.
Silhouette silhouette(const Mesh& target, const InstanceIndex& sculpture,
                      const SilhouetteOptions& options, Status& status);

}  // namespace collage
