#include "scene/instance_lines.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <initializer_list>

#include <tbb/parallel_for.h>

#include "base/scan.h"
#include "base/text.h"

namespace collage {
namespace {

void append_numbers(std::string& text, std::initializer_list<double> numbers) {
  char separator = '[';
  for (const double number : numbers) {
    text += separator;
    append_number(text, number);
    separator = ',';
  }
  text += ']';
}

bool is_digit(std::string_view text, std::size_t at) {
  return at < text.size() && text[at] >= '0' && text[at] <= '9';
}

/// A number of JSON, whose grammar from_chars() does not know: no "inf", "01", ".5" or "5.".
bool read_json_number(std::string_view& text, double& value) {
  const std::string_view start = text;
  const std::size_t sign = start.starts_with('-') ? 1 : 0;
  if (!is_digit(start, sign) || (start[sign] == '0' && is_digit(start, sign + 1)) ||
      !read_number(text, value)) {
    return false;
  }
  const std::string_view number = start.substr(0, start.size() - text.size());
  const std::size_t point = number.find('.');
  return std::isfinite(value) && (point == std::string_view::npos || is_digit(number, point + 1));
}

bool read_numbers(std::string_view& text, std::initializer_list<double*> numbers) {
  std::string_view separator = "[";
  for (double* number : numbers) {
    if (!skip(text, separator) || !read_json_number(text, *number)) {
      return false;
    }
    separator = ",";
  }
  return skip(text, "]");
}

bool read_instance(std::string_view line, std::size_t element_count, Instance& instance) {
  glm::dquat& q = instance.rotation;
  glm::dvec3& t = instance.translation;
  if (!skip(line, "{\"element\":") || (line.starts_with('0') && is_digit(line, 1)) ||
      !read_number(line, instance.element) || !skip(line, ",\"scale\":") ||
      !read_json_number(line, instance.scale) || !skip(line, ",\"rotation\":") ||
      !read_numbers(line, {&q.w, &q.x, &q.y, &q.z}) || !skip(line, ",\"translation\":") ||
      !read_numbers(line, {&t.x, &t.y, &t.z}) || line != "}") {
    return false;
  }
  return instance.element < element_count && instance.scale > 0.0 && is_unit(q);
}

/// Without the commas at the ends of all but the last; nothing where one is missing.
std::optional<std::vector<std::string_view>> items(std::string_view lines) {
  std::vector<std::string_view> result;
  while (!lines.empty()) {
    std::string_view line = lines.substr(0, lines.find('\n'));
    lines.remove_prefix(std::min(lines.size(), line.size() + 1));
    if (!lines.empty()) {
      if (!line.ends_with(',')) {
        return std::nullopt;
      }
      line.remove_suffix(1);
    }
    result.push_back(line);
  }
  return result;
}

}  // namespace

bool is_unit(const glm::dquat& rotation) {
  constexpr double tolerance = 1e-6;
  const glm::dquat& q = rotation;
  return std::abs(std::hypot(std::hypot(q.w, q.x), std::hypot(q.y, q.z)) - 1.0) <= tolerance;
}

void append_instance(std::string& text, const Instance& instance) {
  const glm::dquat& q = instance.rotation;
  const glm::dvec3& t = instance.translation;
  text += "{\"element\":" + std::to_string(instance.element) + ",\"scale\":";
  append_number(text, instance.scale);
  text += ",\"rotation\":";
  append_numbers(text, {q.w, q.x, q.y, q.z});
  text += ",\"translation\":";
  append_numbers(text, {t.x, t.y, t.z});
  text += '}';
}

std::optional<std::vector<Instance>> read_instance_lines(std::string_view lines,
                                                         std::size_t element_count) {
  const auto texts = items(lines);
  if (!texts) {
    return std::nullopt;
  }
  std::vector<Instance> instances(texts->size());
  std::atomic<bool> all = true;
  tbb::parallel_for(std::size_t{0}, instances.size(), [&](std::size_t i) {
    if (!read_instance((*texts)[i], element_count, instances[i])) {
      all = false;
    }
  });
  return all ? std::optional(std::move(instances)) : std::nullopt;
}

}  // namespace collage
