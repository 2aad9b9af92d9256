#include "base/error.h"

#include <algorithm>
#include <numeric>
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
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitute = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substitute});
    }
  }
  return row[b.size()];
}

}  // namespace collage
