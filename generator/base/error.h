#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace collage {

/// Where in an input something is wrong. `line` counts from 1; 0: the file as a whole.
struct Place {
  std::filesystem::path file;
  int line = 0;
};

/// Something that the user can mend. Thrown anywhere, caught once, in cli/.
/// what() is one line: "file:line: problem; remedy".
class Error : public std::runtime_error {
 public:
  /// Whose fault it is decides the exit code: 2 for the input, 3 for a program that we run.
  enum class Blame { input, outside_program };

  Error(const std::string& problem, const std::string& remedy);
  Error(const Place& place, const std::string& problem, const std::string& remedy);

  [[nodiscard]] static Error outside_program(const std::string& problem, const std::string& remedy);
  [[nodiscard]] Blame blame() const { return blame_; }

 private:
  Blame blame_ = Blame::input;
};

/// The user asked to stop (Ctrl-C); exit code 130. Nothing half-written is left behind.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

/// "; did you mean 'threshold'?" for the candidate nearest to `word`, or "" where none is near.
template <class Range>
std::string did_you_mean(const std::string& word, const Range& candidates);

/// Characters to insert, remove, replace or swap with their neighbour to make `b` of `a`
/// (Levenshtein with transpositions, each character touched once). Cost: O(|a| |b|).
std::size_t edit_distance(const std::string& a, const std::string& b);

template <class Range>
std::string did_you_mean(const std::string& word, const Range& candidates) {
  std::string best;
  std::size_t best_distance = word.size() / 3 + 2;
  for (const auto& candidate : candidates) {
    const std::size_t distance = edit_distance(word, candidate);
    if (distance < best_distance) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best.empty() ? "" : "did you mean '" + best + "'?";
}

}  // namespace collage
