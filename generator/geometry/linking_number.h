#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/mesh.h"

namespace collage {

/// A closed polyline; the last point is joined to the first.
using Loop = std::vector<dvec3>;

/// How often one loop goes round the other; the sign is the way round. The loops must not meet.
/// Counts where `a` crosses in front of `b`, seen from a direction of no meaning; where it cannot
/// be told for certain which way two pieces cross, by the slow twin. Allocates nothing. Cost: |a|
/// |b| comparisons of intervals.
int linking_number(std::span<const dvec3> a, std::span<const dvec3> b);

/// The slow twin: Gauss's integral, which for straight pieces is a sum of solid angles (Klenin and
/// Langowski 2000, "Computation of writhe in modeling of supercoiled DNA", eq. 14 to 16).
int linking_number_by_solid_angles(std::span<const dvec3> a, std::span<const dvec3> b);

/// Loops on the surface, two for each of its handles, that go round and through them: all other
/// loops come to sums of these. A tree of shortest paths from one vertex and a tree of triangles
/// across the longest remaining edges leave one edge for each loop (Erickson and Whittlesey 2005,
/// "Greedy optimal homotopy and homology generators"). Parts whose edges do not all have two
/// triangles have none. Cost: O(n log n), and the loops' lengths.
///
/// Two solids that do not meet hang in one another where some loop of one links one of the other:
/// a loop that bounds a disc in its solid links nothing outside, so that it does no harm.
std::vector<Loop> handle_loops(const Mesh& mesh);

}  // namespace collage
