#include "render/thumbnail.h"

#include "render/imaging.h"

namespace collage {

Picture thumbnail(const std::filesystem::path& path, int side) {
  return imaging().made_smaller(read_picture(path), side);
}

}  // namespace collage
