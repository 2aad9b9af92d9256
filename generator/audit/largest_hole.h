#pragma once

#include "audit/instance_index.h"
#include "audit/target_shape.h"
#include "base/status.h"

namespace collage {

/// The largest ball that lies inside the target and outside of all instances, wherever its centre
/// is. All lengths in world units.
struct LargestHole {
  dvec3 center{0.0};
  /// A ball of this radius round `center` meets no surface; 0 where no hole was found.
  double radius = 0.0;
  /// No such ball anywhere is larger. At most 1 % above `radius`, and never below the size from
  /// which on holes are looked for.
  double bound = 0.0;
  /// False where distances are too coarse, an instance being thousands of times as large as the
  /// target, and where a surface is open: where such a solid ends across a gap is decided by the
  /// winding number at points half a hole apart, and not proven in between.
  bool proven = true;
};

/// By branch and bound over cubes: the clearance changes by no more than the way one goes
/// (Lipschitz constant 1), so a cube with clearance d in its middle and half diagonal h holds no
/// clearance over d + h; one whose middle is taken, none over h - d. Cubes that may hold more than
/// 1 % above the best found are cut in eight. Holes below 1/1,000 of the target's longest side are
/// not looked for.
/// Runs on all threads; the result does not depend on their number. Throws
/// Interrupted. Cost: some ten to fifty distances for each hole of about that size.
LargestHole find_largest_hole(const TargetShape& target, const InstanceIndex& sculpture,
                              Status& status);

}  // namespace collage
