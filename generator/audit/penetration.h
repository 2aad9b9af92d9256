#pragma once

#include "audit/audit_shape.h"

namespace collage {

/// How deep two instances that overlap are in each other, in world units: the greatest distance to
/// the other's surface that a vertex of one has inside the other, or the middle of a piece of an
/// edge that runs inside it. 0 where they only touch. In double, without exact predicates: it
/// measures an overlap that was found and does not look for one.
/// Cost: a walk down the other's hierarchy for each vertex and edge that is near it.
double penetration_depth(const AuditShape& a, const Instance& instance_a, const AuditShape& b,
                         const Instance& instance_b);

}  // namespace collage
