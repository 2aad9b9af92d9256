#include "base/error.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace collage {
namespace {

/// One line whatever names from outside hold: control characters become '?'.
std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(),
      [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, '?');
  return text;
}

std::string sentence(const Place& place, const std::string& problem, const std::string& remedy) {
  std::string text;
  if (!place.file.empty()) {
    text += place.file.string();
    text += place.line > 0 ? ":" + std::to_string(place.line) + ": " : ": ";
  }
  text += problem;
  if (!remedy.empty()) {
    text += "; " + remedy;
  }
  return one_line(text);
}

}  // namespace

Error::Error(const std::string& problem, const std::string& remedy)
    : std::runtime_error(sentence({}, problem, remedy)) {}

Error::Error(const Place& place, const std::string& problem, const std::string& remedy)
    : std::runtime_error(sentence(place, problem, remedy)) {}

Error Error::outside_program(const std::string& problem, const std::string& remedy) {
  Error error(problem, remedy);
  error.blame_ = Blame::outside_program;
  return error;
}

std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before_last;
  std::vector<std::size_t> last;
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before_last = std::exchange(last, row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before_last[j - 2] + 1);
      }
    }
  }
  return row[b.size()];
}

}  // namespace collage
