#include "fitting/shape_cache.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string_view>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include "base/error.h"
#include "base/file.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

/// Goes up with every change of what measure_shape() finds, or of the file.
constexpr int version = 1;
/// One shape takes some 4 MB.
constexpr std::uintmax_t largest_file = std::uintmax_t{64} << 20;
constexpr std::size_t digest_digits = 64;

template <class T>
void append(std::string& bytes, const T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  bytes.append(std::bit_cast<std::array<char, sizeof(T)>>(value).data(), sizeof(T));
}

template <class T>
void append_all(std::string& bytes, const std::vector<T>& values) {
  static_assert(std::is_trivially_copyable_v<T>);
  append(bytes, std::uint64_t{values.size()});
  bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

/// Takes values from the front of some bytes; where these end before, all that follow are nothing.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : left_(bytes) {}

  template <class T>
  T one() {
    T value{};
    take(&value, sizeof(T));
    return value;
  }
  template <class T>
  std::vector<T> all() {
    const auto count = one<std::uint64_t>();
    good_ = good_ && count <= left_.size() / sizeof(T);
    std::vector<T> values(good_ ? count : 0);
    take(values.data(), values.size() * sizeof(T));
    return values;
  }
  /// All was there, and no more.
  [[nodiscard]] bool ended_well() const { return good_ && left_.empty(); }

 private:
  void take(void* to, std::size_t size) {
    good_ = good_ && size <= left_.size();
    if (good_ && size > 0) {
      std::memcpy(to, left_.data(), size);
      left_.remove_prefix(size);
    }
  }

  std::string_view left_;
  bool good_ = true;
};

void append_cover(std::string& bytes, const SphereCover& cover) {
  append(bytes, cover.bulge);
  append_all(bytes, cover.spheres);
}

SphereCover read_cover(Reader& reader) {
  SphereCover cover;
  cover.bulge = reader.one<double>();
  cover.spheres = reader.all<Sphere>();
  return cover;
}

std::string file_content(const ShapeData& data) {
  std::string bytes;
  append_cover(bytes, data.coarse);
  append_cover(bytes, data.fine);
  append(bytes, data.distances.first());
  append(bytes, data.distances.spacing());
  append(bytes, data.distances.size());
  append_all(bytes, data.distances.values());
  return sha256(bytes) + bytes;
}

/// Nothing where the content is not what file_content() gives: the digest tells.
std::optional<ShapeData> parse(std::string_view content) {
  const std::string_view bytes = content.substr(std::min(digest_digits, content.size()));
  if (content.substr(0, digest_digits) != sha256(bytes)) {
    return std::nullopt;
  }
  Reader reader(bytes);
  ShapeData data;
  data.coarse = read_cover(reader);
  data.fine = read_cover(reader);
  const auto first = reader.one<dvec3>();
  const auto spacing = reader.one<double>();
  const auto size = reader.one<glm::ivec3>();
  std::vector<float> values = reader.all<float>();
  if (!reader.ended_well()) {
    return std::nullopt;
  }
  data.distances = DistanceField(first, spacing, size);
  data.distances.values() = std::move(values);
  return data;
}

/// Of the mesh and of the numbers that measure_shape() goes by, as this machine writes them.
std::string key_of(const Mesh& mesh) {
  std::string bytes = fmt::format("collage shape {} {} {} {}\n", version, coarse_spheres,
                                  fine_spheres, std::endian::native == std::endian::little);
  append_all(bytes, mesh.positions);
  append_all(bytes, mesh.triangles);
  return sha256(bytes);
}

}  // namespace

fs::path cache_folder() {
  const auto folder = [](const char* variable) {
    const char* value = std::getenv(variable);
    // As the XDG Base Directory Specification has it: a relative path counts as none.
    return value != nullptr && fs::path(value).is_absolute() ? fs::path(value) : fs::path();
  };
  if (const fs::path cache = folder("XDG_CACHE_HOME"); !cache.empty()) {
    return cache / "collage";
  }
  const fs::path home = folder("HOME");
  return home.empty() ? home : home / ".cache" / "collage";
}

ShapeData cached_shape(const Mesh& mesh, const Element& element, const fs::path& folder) {
  if (folder.empty()) {
    return measure_shape(mesh, element);
  }
  const fs::path file = folder / (key_of(mesh) + ".shape");
  try {
    if (fs::exists(file)) {
      if (std::optional<ShapeData> known = parse(read_file(file, largest_file))) {
        return std::move(*known);
      }
    }
  } catch (const std::exception&) {
    // Measured instead.
  }
  ShapeData data = measure_shape(mesh, element);
  try {
    write_file(file, file_content(data));
  } catch (const Error&) {
    // The next run measures again.
  }
  return data;
}

}  // namespace collage
