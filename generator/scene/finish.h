#pragma once

#include <string>
#include <vector>

namespace collage {

/// How an element reflects light, whatever its colour and texture; `automatic`: as its materials
/// say. The words of the scene file, in the same order, are finish_words().
enum class Finish { automatic, ceramic, plastic, felt, lacquer, matt, satin, metal, glass, milk };

inline const std::vector<std::string>& finish_words() {
  static const std::vector<std::string> words{"auto", "ceramic", "plastic", "felt",  "lacquer",
                                              "matt", "satin",   "metal",   "glass", "milk"};
  return words;
}

}  // namespace collage
