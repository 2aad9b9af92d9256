#pragma once

namespace collage {

/// Runs `collage` with the given arguments and returns its exit code: 0 success, 1 the answer is
/// "no", 2 usage or bad input, 3 an outside program failed, 130 interrupted. Never throws.
int run_command_line(int argc, char** argv);

}  // namespace collage
