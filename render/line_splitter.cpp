#include "render/line_splitter.h"

#include <utility>

namespace collage {

void LineSplitter::append(std::string_view bytes) {
  for (const char byte : bytes) {
    if (byte == '\n' || byte == '\r') {
      finish();
      continue;
    }
    line_ += byte;
    if (line_.size() >= max_bytes) {
      finish();
    }
  }
}

void LineSplitter::finish() {
  if (!line_.empty()) {
    const std::string line = std::exchange(line_, {});
    on_line_(line);
  }
}

}  // namespace collage
