#include "geometry/inset.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace collage {
namespace {

using Index = std::uint32_t;

constexpr double fastest_reflex_corner = 2.0;
/// Shorter sides have shrunk to nothing: their ends could come to lie on one point of the grid.
constexpr double shortest_side = 2.0 * grid_step;

double cross(const dvec2& a, const dvec2& b) { return a.x * b.y - a.y * b.x; }
dvec2 left_of(const dvec2& direction) { return {-direction.y, direction.x}; }

/// The contours on their way inwards. A side goes by the number of its first point, as does the
/// corner there.
class Front {
 public:
  explicit Front(const Region& region) {
    for (Index c = 0; c < region.size(); ++c) {
      append(region[c], c);
    }
    for (Index i = 0; i < corners_.size(); ++i) {
      sides_alive_ = turn_to(i, 0.0) && sides_alive_;
    }
    for (Index i = 0; i < corners_.size(); ++i) {
      wait(i, 0.0);
    }
  }

  /// Moves all sides in; false where a contour vanishes.
  bool move(double distance) {
    while (sides_alive_ && !waiting_.empty() && waiting_.begin()->first < distance) {
      const auto [time, side] = *waiting_.begin();
      sides_alive_ = take_out(side, time);
    }
    return sides_alive_;
  }

  /// What lies behind the front, once it has moved by `distance`.
  Inset behind(double distance) {
    result_.inner.resize(contour_sizes_.size());
    std::vector<Index> place(corners_.size(), 0);
    for (Index i = 0; i < corners_.size(); ++i) {
      if (corners_[i].alive) {
        place[i] = append_point(on_grid(corners_[i].at(distance)), distance);
      }
    }
    std::vector<char> done(corners_.size(), 0);
    for (Index i = 0; i < corners_.size(); ++i) {
      for (Index k = i; corners_[k].alive && done[k] == 0; k = corners_[k].next) {
        done[k] = 1;
        result_.inner[corners_[k].contour].emplace_back(result_.points[place[k]]);
        result_.inner_points.push_back(place[k]);
        left_[k].push_back(place[k]);
        right_[k].push_back(place[corners_[k].next]);
      }
    }
    append_faces();
    return std::move(result_);
  }

 private:
  /// A corner and the side behind it.
  struct Corner {
    Index contour = 0;
    Index next = 0;
    Index previous = 0;
    bool alive = true;
    /// Where it was at `since`, and its way per distance that the sides move.
    dvec2 base{0.0};
    double since = 0.0;
    dvec2 velocity{0.0};
    /// Of the side.
    dvec2 direction{0.0};

    [[nodiscard]] dvec2 at(double time) const { return base + (time - since) * velocity; }
  };

  void append(const Contour& contour, Index number) {
    const auto first = static_cast<Index>(corners_.size());
    const auto n = static_cast<Index>(contour.size());
    for (Index i = 0; i < n; ++i) {
      Corner corner;
      corner.contour = number;
      corner.next = first + (i + 1) % n;
      corner.previous = first + (i + n - 1) % n;
      corner.base = contour[i];
      corner.direction = glm::normalize(contour[(i + 1) % n] - contour[i]);
      corners_.push_back(corner);
      result_.points.emplace_back(contour[i], 0.0);
      feet_.push_back({first + i, corner.next});
    }
    contour_sizes_.push_back(n);
    left_.resize(corners_.size());
    right_.resize(corners_.size());
    due_.resize(corners_.size(), never);
  }

  /// The way of a corner between its two sides, from `time` on; false where they run back to back.
  bool turn_to(Index i, double time) {
    Corner& corner = corners_[i];
    const dvec2 before = corners_[corner.previous].direction;
    const dvec2 behind = corner.direction;
    const double both = 1.0 + glm::dot(before, behind);
    if (both < 1e-9) {
      return false;
    }
    corner.since = time;
    corner.velocity = left_of(before + behind) / both;
    const double speed = glm::length(corner.velocity);
    if (cross(before, behind) < 0.0 && speed > fastest_reflex_corner) {
      corner.velocity *= fastest_reflex_corner / speed;
    }
    return true;
  }

  /// Enters when a side will have shrunk to nothing.
  void wait(Index side, double now) {
    waiting_.erase({due_[side], side});
    const Corner& from = corners_[side];
    const Corner& to = corners_[from.next];
    const double length = glm::dot(to.at(now) - from.at(now), from.direction);
    const double growth = glm::dot(to.velocity - from.velocity, from.direction);
    due_[side] = growth < 0.0 ? std::max(now, now - (length - shortest_side) / growth) : never;
    waiting_.insert({due_[side], side});
  }

  /// Joins the corners at both ends of a side that has shrunk to nothing.
  bool take_out(Index side, double time) {
    Corner& gone = corners_[side];
    Corner& joint = corners_[gone.next];
    if (--contour_sizes_[gone.contour] < 3) {
      return false;
    }
    const dvec2 place = 0.5 * (gone.at(time) + joint.at(time));
    const Index point = append_point(place, time);
    right_[side].push_back(point);
    right_[gone.previous].push_back(point);
    left_[gone.next].push_back(point);
    waiting_.erase({due_[side], side});
    gone.alive = false;
    joint.previous = gone.previous;
    joint.base = place;
    corners_[gone.previous].next = gone.next;
    if (!turn_to(gone.next, time)) {
      return false;
    }
    wait(gone.previous, time);
    wait(gone.next, time);
    return true;
  }

  Index append_point(const dvec2& place, double height) {
    result_.points.emplace_back(place, height);
    return static_cast<Index>(result_.points.size() - 1);
  }

  /// Each side's face: its foot, up the right side, down the left side.
  void append_faces() {
    for (Index i = 0; i < corners_.size(); ++i) {
      auto& face = result_.faces.emplace_back(feet_[i].begin(), feet_[i].end());
      face.insert(face.end(), right_[i].begin(), right_[i].end());
      face.insert(face.end(), left_[i].rbegin(), left_[i].rend());
    }
  }

  static constexpr double never = std::numeric_limits<double>::infinity();

  std::vector<Corner> corners_;
  std::vector<std::array<Index, 2>> feet_;
  /// The points that each side's ends have passed through.
  std::vector<std::vector<Index>> left_;
  std::vector<std::vector<Index>> right_;
  std::vector<Index> contour_sizes_;
  std::vector<double> due_;
  std::set<std::pair<double, Index>> waiting_;
  bool sides_alive_ = true;
  Inset result_;
};

/// The region itself, without a strip.
Inset no_strip(const Region& region) {
  Inset result;
  result.inner = region;
  for (const dvec2& point : all_points(region)) {
    result.inner_points.push_back(static_cast<Index>(result.points.size()));
    result.points.emplace_back(point, 0.0);
  }
  return result;
}

}  // namespace

std::optional<Inset> inset(const Region& region, double distance) {
  Inset result;
  if (distance > 0.0) {
    Front front(region);
    if (!front.move(distance)) {
      return std::nullopt;
    }
    result = front.behind(distance);
  } else {
    result = no_strip(region);
  }
  const auto cap = triangulated(result.inner);
  if (!cap) {
    return std::nullopt;
  }
  for (const uvec3& t : *cap) {
    result.cap.emplace_back(result.inner_points[t.x], result.inner_points[t.y],
                            result.inner_points[t.z]);
  }
  return result;
}

}  // namespace collage
