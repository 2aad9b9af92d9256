#pragma once

#include <cstdint>
#include <optional>
#include <queue>
#include <unordered_map>
#include <vector>

#include "fitting/free_space.h"
#include "fitting/pose.h"

namespace collage {

/// An element's place in a hole.
struct Vacancy {
  dvec3 hole{0.0};
  /// Where the hole map has it: the hole itself moves as the space round it is filled.
  dvec3 listed_at{0.0};
  double clearance = 0.0;
  std::uint32_t shape = 0;
  /// What the queue is ordered by: the size of the pose or, before one was looked for, a guess.
  double key = 0.0;
  Pose pose;
  /// The pose fitted when this many instances were there.
  std::uint32_t fitted_at = 0;
  bool has_pose = false;
  int openings = 0;
  /// The instance whose ring the pose is to hang in.
  std::optional<std::uint32_t> host;
};

/// Vacancies yet to be filled, for each shape the most promising one first.
class HoleQueue {
 public:
  using Id = std::uint32_t;

  explicit HoleQueue(std::size_t shapes) : queues_(shapes) {}

  Id add(const Vacancy& vacancy);
  [[nodiscard]] Vacancy& operator[](Id id) { return vacancies_[id]; }
  [[nodiscard]] const Vacancy& operator[](Id id) const { return vacancies_[id]; }
  /// Puts a place back, by its key.
  void push(Id id) { queues_[vacancies_[id].shape].emplace(vacancies_[id].key, id); }
  /// Nothing where there is no place left.
  [[nodiscard]] std::optional<Id> top(std::uint32_t shape) const {
    const auto& queue = queues_[shape];
    return queue.empty() ? std::nullopt : std::optional(queue.top().second);
  }
  void pop(std::uint32_t shape) { queues_[shape].pop(); }

 private:
  std::vector<Vacancy> vacancies_;
  std::vector<std::priority_queue<std::pair<double, Id>>> queues_;
};

/// Remembers where holes are, so that none is listed twice.
class HoleMap {
 public:
  explicit HoleMap(double cell) : cell_(cell) {}

  /// False where a hole is there already, nearer than `apart`.
  bool insert(const dvec3& hole, double apart);
  void clear() { cells_.clear(); }
  /// Forgets the hole exactly there.
  void remove(const dvec3& hole);

 private:
  [[nodiscard]] glm::ivec3 cell_at(const dvec3& point) const {
    return glm::ivec3(glm::floor(point / cell_));
  }
  static std::uint64_t key(const glm::ivec3& cell);

  double cell_;
  std::unordered_map<std::uint64_t, std::vector<dvec3>> cells_;
};

}  // namespace collage
