#include "preview/surface.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/element_look.h"

namespace collage {
namespace {

using glm::vec3;

/// A finish's numbers, and how much of the paint is white or, below zero, black.
struct FinishRow {
  float body;
  float shine;
  float shine_width;
  float mirror_facing;
  float mirror_edge;
  float metal;
  float white;
};

/// In the order of Finish; the first is satin, for materials that say nothing.
constexpr std::array<FinishRow, 10> finish_rows{{
    {0.82F, 0.10F, 0.090F, 0.000F, 0.00F, 0.0F, 0.00F},   // automatic
    {0.85F, 0.03F, 0.020F, 0.045F, 0.90F, 0.0F, 0.00F},   // ceramic
    {0.80F, 0.20F, 0.035F, 0.000F, 0.00F, 0.0F, 0.00F},   // plastic
    {0.85F, 0.00F, 0.100F, 0.000F, 0.00F, 0.0F, 0.00F},   // felt
    {0.80F, 0.05F, 0.060F, 0.060F, 1.00F, 0.0F, -0.30F},  // lacquer
    {0.85F, 0.00F, 0.100F, 0.000F, 0.00F, 0.0F, 0.00F},   // matt
    {0.82F, 0.10F, 0.090F, 0.000F, 0.00F, 0.0F, 0.00F},   // satin
    {0.25F, 0.40F, 0.012F, 0.720F, 0.95F, 1.0F, 0.00F},   // metal
    {0.60F, 0.00F, 0.100F, 0.060F, 1.00F, 0.0F, 0.40F},   // glass
    {0.78F, 0.05F, 0.030F, 0.025F, 0.35F, 0.0F, 0.15F},   // milk
}};

void apply(const FinishRow& row, Surface& surface) {
  surface.body = row.body;
  surface.shine = row.shine;
  surface.shine_width = row.shine_width;
  surface.mirror_facing = row.mirror_facing;
  surface.mirror_edge = row.mirror_edge;
  surface.metal = row.metal;
  surface.color =
      glm::mix(surface.color, vec3(row.white > 0.0F ? 1.0F : 0.0F), std::abs(row.white));
}

/// MTL's Ks and Ns; a high Ns with a strong Ks is metal.
void apply_phong(const Material& material, Surface& surface) {
  const double strength = std::max({material.specular.x, material.specular.y, material.specular.z});
  if (strength == 0.0) {
    return;
  }
  const double polish = std::clamp((material.shininess - 300.0) / 700.0, 0.0, 1.0) * strength;
  surface.body = static_cast<float>(0.82 * (1.0 - 0.8 * polish));
  surface.shine = static_cast<float>(0.35 * strength);
  surface.shine_width =
      static_cast<float>(std::clamp(2.0 / (material.shininess + 2.0), 0.004, 0.2));
  surface.mirror_facing = static_cast<float>(polish > 0.0 ? 0.04 + 0.66 * polish : 0.0);
  surface.mirror_edge = polish > 0.0 ? 0.95F : 0.0F;
  surface.metal = static_cast<float>(polish);
}

/// MTL's Pr, Pm, Ps and Pc.
void apply_physical(const Material& material, double roughness, Surface& surface) {
  const double polish = (1.0 - roughness) * (1.0 - roughness);
  const double mirror = std::max(material.clearcoat, polish);
  surface.body = static_cast<float>(0.85 * (1.0 - 0.8 * material.metallic));
  surface.shine = static_cast<float>((1.0 - material.sheen) * (0.1 + 0.2 * polish));
  surface.shine_width = static_cast<float>(std::max(0.004, 0.2 * roughness * roughness));
  surface.mirror_facing =
      static_cast<float>(std::max(0.045 * mirror, 0.7 * material.metallic * polish));
  surface.mirror_edge = static_cast<float>(0.9 * mirror);
  surface.metal = static_cast<float>(material.metallic);
}

Surface surface_of(const Material& material, Finish finish) {
  Surface surface;
  surface.color = material.color;
  surface.glow = material.emission;
  apply(finish_rows.at(static_cast<std::size_t>(finish)), surface);
  if (finish == Finish::automatic) {
    if (material.roughness) {
      apply_physical(material, *material.roughness, surface);
    } else {
      apply_phong(material, surface);
    }
  }
  return surface;
}

}  // namespace

vec3 Texture::at(const dvec2& uv) const {
  const double x = (uv.x - std::floor(uv.x)) * width - 0.5;
  const double y = (1.0 - (uv.y - std::floor(uv.y))) * height - 0.5;
  const int left = static_cast<int>(std::floor(x));
  const int top = static_cast<int>(std::floor(y));
  const auto texel = [&](int column, int row) {
    const int c = (column + width) % width;
    const int r = (row + height) % height;
    return texels[static_cast<std::size_t>(r) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(c)];
  };
  const auto fx = static_cast<float>(x - left);
  const auto fy = static_cast<float>(y - top);
  return glm::mix(glm::mix(texel(left, top), texel(left + 1, top), fx),
                  glm::mix(texel(left, top + 1), texel(left + 1, top + 1), fx), fy);
}

SurfaceLooks::SurfaceLooks(const Composition& composition, const TextureReader& read_texture) {
  for (const auto* shapes : {&composition.elements, &composition.props}) {
    for (std::size_t k = 0; k < shapes->size(); ++k) {
      append((*shapes)[k], k, read_texture);
    }
  }
}

void SurfaceLooks::append(const Composition::Element& element, std::size_t index,
                          const TextureReader& read_texture) {
  const ElementLook element_look = look_of(element, index);
  Look& look = looks_.emplace_back();
  for (const Material& material : element_look.materials) {
    Surface surface = surface_of(material, element.finish);
    surface.texture = texture(material, element.mesh, read_texture);
    look.surfaces.push_back(surface);
  }
  if (element_look.assignment == ElementLook::Assignment::by_triangle) {
    look.assignment = &element.mesh.triangle_materials;
  }
}

const Texture* SurfaceLooks::texture(const Material& material, const Mesh& mesh,
                                     const TextureReader& read_texture) {
  if (material.texture.empty() || mesh.uv_triangles.empty()) {
    return nullptr;
  }
  const auto [entry, is_new] = textures_.try_emplace(material.texture);
  if (is_new) {
    entry->second = read_texture(material.texture);
  }
  return entry->second ? &*entry->second : nullptr;
}

const Surface& SurfaceLooks::of(std::uint32_t element, std::uint32_t triangle) const {
  const Look& look = looks_[element];
  return look.surfaces[look.assignment == nullptr ? 0 : (*look.assignment)[triangle]];
}

}  // namespace collage
