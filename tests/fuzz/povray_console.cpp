#include "fuzz.h"
#include "render/line_splitter.h"
#include "render/povray.h"

using namespace collage;

/// What POV-Ray writes while it runs, and what it leaves as its fatal error.
COLLAGE_FUZZ_TARGET(input) {
  PovrayConsole console;
  LineSplitter lines([&](std::string_view line) { console.read_line(line); });
  lines.append(input);
  const double fraction = console.fraction();
  if (!(fraction >= 0.0 && fraction <= 1.0)) {
    std::abort();
  }
  povray_error("folder", 1, input, console);
}
