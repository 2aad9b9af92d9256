#include "render/sandbox.h"

#include <cstdlib>
#include <string>
#include <system_error>
#include <vector>

namespace collage {
namespace {

namespace fs = std::filesystem;

/// What programs of the system are made of; some of these are missing on some systems.
constexpr const char* system_places[] = {"/usr",        "/bin",
                                         "/lib",        "/lib64",
                                         "/etc/povray", "/etc/ld.so.cache",
                                         "/etc/fonts",  "/etc/alternatives"};

void append_read_only(std::vector<std::string>& arguments, const fs::path& place) {
  arguments.insert(arguments.end(), {"--ro-bind-try", place.string(), place.string()});
}

}  // namespace

Command sandboxed(const fs::path& bwrap, const Command& command) {
  Command outer = command;
  outer.program = bwrap;
  std::vector<std::string>& arguments = outer.arguments;
  arguments = {"--unshare-all", "--die-with-parent", "--cap-drop", "ALL", "--dev",
               "/dev",          "--tmpfs",           "/tmp"};
  for (const char* place : system_places) {
    append_read_only(arguments, place);
  }
  if (const char* home = std::getenv("HOME"); home != nullptr && fs::path(home).is_absolute()) {
    append_read_only(arguments, fs::path(home) / ".povray");
  }
  append_read_only(arguments, command.program.parent_path());
  if (!command.folder.empty()) {
    std::error_code ignored;  // a folder that is not there is reported by whoever starts it
    const std::string folder = fs::weakly_canonical(command.folder, ignored).string();
    arguments.insert(arguments.end(), {"--bind", folder, folder, "--chdir", folder});
  }
  arguments.insert(arguments.end(), {"--", command.program.string()});
  arguments.insert(arguments.end(), command.arguments.begin(), command.arguments.end());
  return outer;
}

}  // namespace collage
