#pragma once

#include <string>

#include "geometry/mesh.h"

namespace collage {

// What the models are made of, named in their MTL by what it is. Colours are linear-light.

Material glaze(std::string name, const dvec3& color);
Material lacquer(const dvec3& color);
Material cereal(const dvec3& color);
Material carrot_skin();
Material greens();
Material felt();
Material satin();
Material wood();
Material steel();
Material milk();

}  // namespace collage
