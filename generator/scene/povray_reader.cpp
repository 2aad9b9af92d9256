#include "scene/povray_reader.h"

#include <algorithm>
#include <string_view>

#include "base/error.h"
#include "base/file.h"
#include "base/scan.h"

namespace collage {
namespace {

/// `<1, 2, 3>` or `<1,2,3>`.
template <class Number>
bool read_vector(std::string_view& text, Number* values, int count) {
  if (!skip(text, "<")) {
    return false;
  }
  for (int i = 0; i < count; ++i) {
    if ((i > 0 && !skip(text, ",")) || (skip(text, " "), !read_number(text, values[i]))) {
      return false;
    }
  }
  return skip(text, ">");
}

class Reader {
 public:
  explicit Reader(const std::filesystem::path& path) : path_(path), text_(read_file(path)) {
    rest_ = text_;
  }

  PovrayScene scene() {
    PovrayScene scene;
    while (next_line()) {
      std::string_view text = line_;
      if (skip(text, "#declare ") && text.ends_with(" = mesh2 {")) {
        const std::string name(text.substr(0, text.find(' ')));
        if (!scene.meshes.emplace(name, mesh2()).second) {
          fail();
        }
      } else if (line_ == "union {") {
        read_union(scene.instances);
      }
    }
    return scene;
  }

 private:
  bool next_line() {
    if (rest_.empty()) {
      return false;
    }
    line_ = rest_.substr(0, rest_.find('\n'));
    rest_.remove_prefix(std::min(rest_.size(), line_.size() + 1));
    line_.remove_prefix(std::min(line_.find_first_not_of(' '), line_.size()));
    ++number_;
    return true;
  }
  void require_line() {
    if (!next_line()) {
      fail();
    }
  }
  [[noreturn]] void fail() const {
    throw Error({path_, number_}, "is not as the program writes it",
                "write the folder anew with `collage pack`");
  }

  Mesh mesh2() {
    Mesh mesh;
    for (require_line(); line_ != "}"; require_line()) {
      if (line_ == "vertex_vectors {") {
        read_list(mesh.positions,
                  [](std::string_view& item, dvec3& v) { return read_vector(item, &v.x, 3); });
      } else if (line_ == "face_indices {") {
        read_list(mesh.triangles, [](std::string_view& item, uvec3& t) {
          if (!read_vector(item, &t.x, 3)) {
            return false;
          }
          std::uint32_t material = 0;  // where each triangle has its own
          skip(item, ",");
          read_number(item, material);
          return true;
        });
      } else if (line_.ends_with("{")) {
        while (line_ != "}") {  // normals, uv and textures, which have no part in the promises
          require_line();
        }
      }
    }
    return mesh;
  }

  /// `count, item, item, … }`, an item a line.
  template <class Item, class ReadItem>
  void read_list(std::vector<Item>& items, ReadItem read_item) {
    std::size_t count = 0;
    require_line();
    if (!read_number(line_, count) || count > text_.size()) {
      fail();
    }
    items.reserve(count);
    for (require_line(); line_ != "}"; require_line()) {
      if (!read_item(line_, items.emplace_back()) || !(line_.empty() || line_ == ",")) {
        fail();
      }
    }
    if (items.size() != count) {
      fail();
    }
  }

  /// A union of instances, props and unions.
  void read_union(std::vector<PovrayScene::Instance>& instances) {
    for (int depth = 1; depth > 0;) {
      require_line();
      if (line_ == "union {") {
        ++depth;
      } else if (line_ == "}") {
        --depth;
      } else if (skip(line_, "#if (")) {
        instances.push_back(read_instance());
      } else if (!line_.starts_with("bounded_by { box { <") && !is_prop(line_) &&
                 line_ != "interior { Element_Interior }" &&
                 line_ != "transform { Place_Sculpture }") {
        fail();
      }
    }
  }

  /// `object { Prop_3 }`, and nothing after it.
  static bool is_prop(std::string_view line) {
    std::uint32_t number = 0;
    return skip(line, "object { Prop_") && read_number(line, number) && line == " }";
  }

  /// The rest of `#if (17 < Shown[3]) object { Element_3 matrix <12 numbers> } #end`.
  PovrayScene::Instance read_instance() {
    PovrayScene::Instance instance;
    instance.line = number_;
    std::uint32_t shown_with = 0;
    const bool known = read_number(line_, instance.number) && skip(line_, " < Shown[") &&
                       read_number(line_, shown_with) && skip(line_, "]) object { Element_") &&
                       read_number(line_, instance.element) && skip(line_, " matrix ") &&
                       read_vector(line_, instance.matrix.data(), 12) && line_ == " } #end";
    if (!known || instance.element != shown_with) {
      fail();
    }
    return instance;
  }

  std::filesystem::path path_;
  std::string text_;
  std::string_view rest_;
  std::string_view line_;
  int number_ = 0;
};

}  // namespace

PovrayScene read_povray(const std::filesystem::path& path) { return Reader(path).scene(); }

}  // namespace collage
