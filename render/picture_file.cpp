#include "render/picture_file.h"

#include "base/error.h"
#include "base/file.h"
#include "render/imaging.h"
#include "render/scratch.h"

namespace collage {
namespace fs = std::filesystem;

Picture read_picture(const fs::path& path) { return imaging().decoded(read_file(path), path); }

void write_picture(const fs::path& path, const Picture& picture) {
  if (path.extension() != extension(picture.format)) {
    throw Error({path}, "is not the name of such a picture",
                "let it end in " + extension(picture.format));
  }
  const std::string bytes = imaging().encoded(picture, path);
  const Scratch scratch(path.has_parent_path() ? path.parent_path() : fs::path("."));
  write_file(scratch.path(".part"), bytes);
  move_into_place(scratch.path(".part"), path);
}

}  // namespace collage
