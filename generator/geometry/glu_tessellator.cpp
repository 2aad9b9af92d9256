#include "geometry/glu_tessellator.h"

#include <cstddef>
#include <memory>

#include <GL/glu.h>

namespace collage {
namespace {

struct Deleter {
  void operator()(GLUtesselator* tessellator) const { gluDeleteTess(tessellator); }
};

/// GLU hands back a pointer a point; we let it carry the point's number.
void* pointer_of(std::uintptr_t index) {
  return reinterpret_cast<void*>(index + 1);  // NOLINT: never null, never looked behind
}
std::uint32_t index_of(const void* pointer) {
  return static_cast<std::uint32_t>(reinterpret_cast<std::uintptr_t>(pointer) - 1);
}

struct Run {
  Tessellation result;
  std::size_t points = 0;  // given or added
};

Run& run_of(void* data) { return *static_cast<Run*>(data); }

void on_begin(GLenum, void* run) { run_of(run).result.primitives.emplace_back(); }
void on_vertex(void* vertex, void* run) {
  run_of(run).result.primitives.back().push_back(index_of(vertex));
}
/// Asked for, or GLU makes strips and fans, and a shortcut takes contours that cross themselves for
/// convex ones.
void on_edge_flag(GLboolean, void*) {}
void on_combine(const GLdouble coordinates[3], void* [4], const GLfloat[4], void** vertex,
                void* run) {
  run_of(run).result.added.emplace_back(coordinates[0], coordinates[1]);
  *vertex = pointer_of(run_of(run).points++);
}
void on_error(GLenum, void* run) { run_of(run).result.failed = true; }

template <class Callback>
void set_callback(GLUtesselator* tessellator, GLenum which, Callback* callback) {
  gluTessCallback(tessellator, which, reinterpret_cast<_GLUfuncptr>(callback));
}

enum class Wanted { boundary, triangles };

Tessellation tessellated(const std::vector<Contour>& contours, Wanted wanted) {
  const std::unique_ptr<GLUtesselator, Deleter> owner(gluNewTess());
  GLUtesselator* const tessellator = owner.get();
  const bool boundary = wanted == Wanted::boundary;
  gluTessProperty(tessellator, GLU_TESS_WINDING_RULE,
                  boundary ? GLU_TESS_WINDING_NONZERO : GLU_TESS_WINDING_POSITIVE);
  gluTessProperty(tessellator, GLU_TESS_BOUNDARY_ONLY, boundary ? GL_TRUE : GL_FALSE);
  gluTessNormal(tessellator, 0.0, 0.0, 1.0);
  set_callback(tessellator, GLU_TESS_BEGIN_DATA, on_begin);
  set_callback(tessellator, GLU_TESS_VERTEX_DATA, on_vertex);
  set_callback(tessellator, GLU_TESS_COMBINE_DATA, on_combine);
  set_callback(tessellator, GLU_TESS_ERROR_DATA, on_error);
  set_callback(tessellator, GLU_TESS_EDGE_FLAG_DATA, on_edge_flag);
  Run run;
  run.points = point_count(contours);
  std::size_t index = 0;
  gluTessBeginPolygon(tessellator, &run);
  for (const Contour& contour : contours) {
    gluTessBeginContour(tessellator);
    for (const dvec2& point : contour) {
      GLdouble coordinates[3] = {point.x, point.y, 0.0};
      gluTessVertex(tessellator, coordinates, pointer_of(index++));  // copies the coordinates
    }
    gluTessEndContour(tessellator);
  }
  gluTessEndPolygon(tessellator);
  return std::move(run.result);
}

}  // namespace

Tessellation boundary_by_glu(const std::vector<Contour>& contours) {
  return tessellated(contours, Wanted::boundary);
}

Tessellation triangles_by_glu(const std::vector<Contour>& contours) {
  return tessellated(contours, Wanted::triangles);
}

}  // namespace collage
