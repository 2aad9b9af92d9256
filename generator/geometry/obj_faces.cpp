#include "geometry/obj_faces.h"

#include <cmath>
#include <istream>
#include <streambuf>
#include <unordered_map>
#include <utility>

#include "geometry/tiny_obj.h"

namespace collage {
namespace {

struct Parse {
  ObjFaces faces;
  std::int64_t positions_so_far = 0;
  int material = -1;
  std::unordered_map<std::string, int> material_indices;
};

/// A stream that reads a text where it lies.
class TextBuffer : public std::streambuf {
 public:
  explicit TextBuffer(const std::string& text) {
    char* start = const_cast<char*>(text.data());  // never written through: there is no put area
    setg(start, start, start + text.size());
  }
};

/// OBJ counts from 1, and below 0 back from what was read so far; 0 means "not given". What reaches
/// back beyond the first must not look like "not given".
std::int64_t resolve(int index, std::int64_t count) {
  if (index == 0) {
    return ObjCorner::none;
  }
  if (index > 0) {
    return std::int64_t{index} - 1;
  }
  return count + index >= 0 ? count + index : ObjCorner::none - 1;
}

void take_face(void* user, tinyobj::index_t* indices, int count) {
  auto& parse = *static_cast<Parse*>(user);
  ObjFaces& faces = parse.faces;
  for (int i = 0; i < count; ++i) {
    faces.corners.push_back({resolve(indices[i].vertex_index, parse.positions_so_far),
                             resolve(indices[i].texcoord_index, std::ssize(faces.uvs)),
                             resolve(indices[i].normal_index, std::ssize(faces.normals))});
  }
  faces.starts.push_back(faces.corners.size());
  faces.materials.push_back(parse.material);
}

void take_material(void* user, const char* text, int) {
  auto& parse = *static_cast<Parse*>(user);
  auto& names = parse.faces.material_names;
  const std::string name(trimmed(text));
  const auto [entry, is_new] =
      parse.material_indices.try_emplace(name, static_cast<int>(names.size()));
  if (is_new) {
    names.push_back(name);
  }
  parse.material = entry->second;
}

}  // namespace

ObjFaces parse_faces(const ObjText& text) {
  tinyobj::callback_t callback;
  callback.vertex_cb = [](void* user, double, double, double, double) {
    ++static_cast<Parse*>(user)->positions_so_far;
  };
  callback.normal_cb = [](void* user, double x, double y, double z) {
    static_cast<Parse*>(user)->faces.normals.emplace_back(x, y, z);
  };
  callback.texcoord_cb = [](void* user, double u, double v, double) {
    const bool finite = std::isfinite(u) && std::isfinite(v);
    static_cast<Parse*>(user)->faces.uvs.push_back(finite ? dvec2(tidy(u), tidy(v)) : dvec2(0.0));
  };
  callback.index_cb = take_face;
  callback.usemtl_cb = take_material;
  Parse parse;
  TextBuffer buffer(text.text);
  std::istream stream(&buffer);
  tinyobj::LoadObjWithCallback(stream, callback, &parse, nullptr, nullptr, nullptr);
  return std::move(parse.faces);
}

}  // namespace collage
