#pragma once

#include <string_view>

namespace collage {

/// What the library tells whoever watches: the terminal, a test, nobody. The library itself never
/// prints. All calls but finish_requested() come from the thread that started the work.
class Status {
 public:
  virtual ~Status() = default;

  /// A stage of the work begins, such as "packing"; stages do not nest.
  virtual void begin(std::string_view stage) { (void)stage; }
  /// How much of the stage is done, 0 to 1, and a few words on it ("1,204 instances").
  virtual void update(double fraction, std::string_view detail) {
    (void)fraction;
    (void)detail;
  }
  virtual void end() {}
  /// One line that the user should read, now or in a log, such as a repair made to a mesh.
  virtual void note(std::string_view line) { (void)line; }
  /// True once the user wants to stop; long work then throws Interrupted.
  [[nodiscard]] virtual bool stop_requested() const { return false; }
  /// True once work that can end early with a result of use should; what it has then is whole. From
  /// any thread.
  [[nodiscard]] virtual bool finish_requested() const { return false; }
};

}  // namespace collage
