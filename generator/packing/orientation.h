#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

namespace collage {

/// The rotation by the smallest angle that takes unit vector `from` to unit vector `to`.
glm::dquat rotation_between(const glm::dvec3& from, const glm::dvec3& to);

/// Turns an element so that its farthest point lies towards the nearest surface (Muhm 2011, IV.1);
/// what that leaves free, the turn about this direction, is `spin_radians`.
glm::dquat orientation(const glm::dvec3& farthest_direction, const glm::dvec3& towards_surface,
                       double spin_radians);

}  // namespace collage
