#pragma once

#include <initializer_list>
#include <string>

#include <glm/glm.hpp>

namespace collage {

/// A name from outside as part of a comment: letters, digits, space, '.', '-' and '_' of ASCII, all
/// else as '_', at most 60 characters.
std::string plain_name(const std::string& name);

/// `text` as a string of POV-Ray's, quotes included. What is not printable ASCII becomes '_'.
std::string pov_string(const std::string& text);

/// Appends "<1, -0.5, 2>", each number as the shortest text that reads back the same.
void append_vector(std::string& text, std::initializer_list<double> numbers);
void append_vector(std::string& text, const glm::dvec3& v);
std::string pov_vector(const glm::dvec3& v);

}  // namespace collage
