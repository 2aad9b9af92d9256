#include "base/stopwatch.h"
#include "bench/bar.h"
#include "geometry/models.h"
#include "packing/pack.h"
#include "support/meshes.h"

namespace collage::bench {
namespace {

/// A target to be filled more than once.
class Case {
 public:
  Case(const Mesh& target, const Mesh& element) : target_(target), element_(element) {}

  struct Cost {
    double processor_seconds;
    double wall_seconds;
  };
  /// With the sampling of the field, or without it.
  enum class Sampling { with, without };
  Cost pack_at(int voxels, double threshold, std::size_t threads, Sampling sampling) const {
    PackingOptions options;
    options.scaling = Scaling::to_hole;
    options.threshold = threshold;
    Status status;
    const std::vector<Ingredient> ingredients{{element_, {1.0}, 1.0}};
    Stopwatch wall;
    double packing_seconds = 0.0;
    std::optional<ClearanceField> field;
    const double sampling_seconds =
        measure(threads, [&] { field.emplace(target_, target_.voxels(voxels, 0.5, 1), status); });
    if (sampling == Sampling::without) {
      wall = Stopwatch();
    }
    packing_seconds =
        measure(threads, [&] { pack(target_, *field, ingredients, options, status); });
    return {packing_seconds + (sampling == Sampling::with ? sampling_seconds : 0.0),
            wall.seconds()};
  }

 private:
  MeshTarget target_;
  Element element_;
};

std::vector<Bar> resolution() {
  const Case teapot(make_teapot(12), test::torus_mesh(1.0, 0.27, 32, 16));
  const double coarse = teapot.pack_at(128, 0.008, 2, Case::Sampling::with).processor_seconds;
  const double fine = teapot.pack_at(256, 0.004, 2, Case::Sampling::with).processor_seconds;
  return {{"teapot, 256 voxels: 128 voxels, twice the threshold", fine, "CPU s", coarse,
           fine / coarse, Bar::Side::at_most, 9.0}};
}

std::vector<Bar> threads() {
  const Case teapot(make_teapot(12), test::torus_mesh(1.0, 0.27, 32, 16));
  const double one = teapot.pack_at(256, 0.004, 1, Case::Sampling::without).wall_seconds;
  const double two = teapot.pack_at(256, 0.004, 2, Case::Sampling::without).wall_seconds;
  return {{"teapot, 256 voxels: one thread instead of two", two, "s", one, one / two,
           Bar::Side::at_least, 1.7}};
}

std::vector<Bar> faces() {
  const Mesh target = make_teapot(12);
  const Case few(target, test::torus_mesh(1.0, 0.27, 15, 10));
  const Case many(target, test::torus_mesh(1.0, 0.27, 150, 90));
  const double of_few = few.pack_at(200, 0.005, 2, Case::Sampling::without).processor_seconds;
  const double of_many = many.pack_at(200, 0.005, 2, Case::Sampling::without).processor_seconds;
  return {{"teapot, 200 voxels, 27,000 faces an element: 300 faces", of_many, "CPU s", of_few,
           of_many / of_few, Bar::Side::at_most, 1.3}};
}

}  // namespace

std::vector<Group> scaling_bars() {
  return {
      {"scaling-resolution", resolution}, {"scaling-threads", threads}, {"scaling-faces", faces}};
}

}  // namespace collage::bench
