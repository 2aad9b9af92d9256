#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>

#include <tbb/global_control.h>

#include "geometry/mesh_check.h"
#include "geometry/mesh_file.h"
#include "geometry/models.h"
#include "packing/pack.h"
#include "support/exact_packer.h"
#include "support/meshes.h"
using namespace collage;
struct Cpu {
  clock_t t = clock();
  double seconds() const { return double(clock() - t) / CLOCKS_PER_SEC; }
};
int main(int argc, char** argv) {
  Status status;
  auto load = [&](std::string p) {
    if (p == "torus")
      return test::torus_mesh(1.0, 0.4, 32, 16);
    if (p == "ball")
      return make_sphere(3);
    if (p == "teapot")
      return make_teapot(12);
    if (p == "teacup")
      return make_teacup(argc > 6 ? atoi(argv[6]) : 16);
    Mesh m = read_obj(p, status).mesh;
    orient(m);
    return m;
  };
  const int threads = atoi(argv[5]);
  const bool slow = argc > 7;
  tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  Cpu w;
  const MeshTarget target(load(argv[1]));
  printf("target %.3f\n", w.seconds());
  w = {};
  const Mesh em = load(argv[2]);
  const Element element(em);
  printf("element %.3f faces %zu\n", w.seconds(), em.triangles.size());
  w = {};
  const VoxelGrid grid = target.voxels(atoi(argv[3]), 0.5, 1);
  PackingOptions options;
  options.scaling = Scaling::to_hole;
  options.threshold = atof(argv[4]);
  const std::vector<Ingredient> ingredients{{element, {1.0}, 1.0}};
  ClearanceField field(target, grid, status);
  printf("field %.3f  inside %zu\n", w.seconds(), field.voxels_inside());
  w = {};
  const Packing p = pack(target, field, ingredients, options, status);
  printf("pack %.3f (place %.3f update %.3f) n %zu flagged %zu largest %.9g fill %.4f\n",
         w.seconds(), p.place_seconds, p.update_seconds, p.instances.size(),
         p.voxels_inside_instances, p.largest_hole, fill(target, ingredients, p.instances));
  if (slow) {
    ClearanceField field2(target, grid, status);
    w = {};
    const Packing q = test::exact_pack(target, field2, ingredients, options);
    printf("exact %.3f n %zu flagged %zu largest %.9g\n", w.seconds(), q.instances.size(),
           q.voxels_inside_instances, q.largest_hole);
    size_t diff = 0;
    for (size_t i = 0; i < std::min(p.instances.size(), q.instances.size()); ++i)
      diff += memcmp(&p.instances[i].rotation, &q.instances[i].rotation, 56) != 0 ||
              p.instances[i].scale != q.instances[i].scale;
    printf("different instances %zu\n", diff);
  }
}
