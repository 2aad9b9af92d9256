#pragma once

#include "base/status.h"
#include "preview/preview.h"
#include "render/picture_file.h"
#include "render/shot.h"

namespace collage {

/// What the shot asks for of a preview; its template and quality play no part.
PreviewShot preview_shot(const Shot& shot);

/// As a PNG shows it: values above 1 are white.
Picture encoded(const PreviewPicture& picture);

/// Reads PNG, JPEG and what else OpenImageIO does, at 512 pixels at most. Notes in `status`, which
/// must outlive it, what cannot be read.
TextureReader texture_reader(Status& status);

}  // namespace collage
