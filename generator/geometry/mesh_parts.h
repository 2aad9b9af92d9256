#pragma once

#include <cstddef>
#include <functional>

#include "geometry/mesh.h"

namespace collage {

/// Adds another mesh's positions and triangles, of which all get `material`. Of `part` only these
/// are taken; normals are to be set once the whole is there.
void append_part(Mesh& mesh, const Mesh& part, const Material& material);

/// Gives `material` to the triangles from `first` to before `end`.
void paint(Mesh& mesh, const Material& material, std::size_t first, std::size_t end);

/// Moves each position; rounded to_millionths().
void deform(Mesh& mesh, const std::function<dvec3(const dvec3&)>& moved);

/// Moved and scaled to where its smallest enclosing sphere is the unit sphere.
Mesh in_unit_sphere(Mesh mesh);

/// As smooth as can be without normals that point into their triangles.
inline constexpr double all_smooth_degrees = 85.0;

/// A model of one material, with smooth normals but for edges sharper than `crease_degrees`.
Mesh make_model(const Mesh& shape, const Material& material, double crease_degrees);

}  // namespace collage
