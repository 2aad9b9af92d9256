#include "scene/option_check.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string_view>
#include <system_error>

#include "geometry/font_file.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

bool is_color(std::string_view text) {
  return text.size() == 7 && text[0] == '#' &&
         std::all_of(text.begin() + 1, text.end(),
                     [](char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0; });
}

/// Whether the text is a finite number from -limit to limit, whole or with decimals.
bool is_angle(std::string_view text, double limit) {
  double value = 0.0;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
  return error == std::errc{} && end == text.data() + text.size() && std::abs(value) <= limit;
}

bool is_azimuth_and_elevation(std::string_view text) {
  const std::size_t slash = text.find('/');
  return slash != std::string_view::npos && is_angle(text.substr(0, slash), 360.0) &&
         is_angle(text.substr(slash + 1), 90.0);
}

bool is_plain(std::string_view name) {
  return std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return c < 0x80 && (std::isalnum(c) != 0 || c == '-' || c == '_');
  });
}

/// One value on its way into the scene.
class Check {
 public:
  Check(const Option& option, std::size_t element, const OptionValue& value,
        const OptionSource& source)
      : option_(option), element_(element), value_(value), source_(source) {}

  [[nodiscard]] OptionValue result() const {
    switch (option_.kind) {
      case OptionKind::boolean:
        return get<bool>();
      case OptionKind::whole_number:
        return whole_number();
      case OptionKind::number:
        return number();
      case OptionKind::text:
        return formed(get<std::string>());
      case OptionKind::numbers:
        return numbers();
      case OptionKind::size:
        return size();
      case OptionKind::texts:
        return texts();
    }
    return value_;
  }

 private:
  [[noreturn]] void refuse(const std::string& problem) const {
    throw Error(source_.place, option_.full_key(element_) + " = " + shown(value_) + " " + problem,
                "use " + accepted_values(option_));
  }

  template <class Type>
  [[nodiscard]] const Type& get() const {
    const Type* value = std::get_if<Type>(&value_);
    return value != nullptr ? *value : (refuse("is of the wrong type"), *value);
  }

  [[nodiscard]] double number() const {
    const auto* whole = std::get_if<std::int64_t>(&value_);
    const double value = whole != nullptr ? static_cast<double>(*whole) : get<double>();
    require_range(value);
    return value;
  }

  void require_range(double value) const {
    if (!(value >= option_.minimum && value <= option_.maximum)) {  // NaN is out of range too
      refuse("is out of range");
    }
  }

  [[nodiscard]] std::int64_t whole_number() const {
    const auto value = get<std::int64_t>();
    require_range(static_cast<double>(value));
    return value;
  }

  [[nodiscard]] std::vector<double> numbers() const {
    const auto& list = get<std::vector<double>>();
    require_count(list.size());
    for (const double value : list) {
      require_range(value);
    }
    return list;
  }

  [[nodiscard]] std::vector<double> size() const {
    std::vector<double> list = numbers();
    if (list.size() != 2 || std::floor(list[0]) != list[0] || std::floor(list[1]) != list[1]) {
      refuse("is not a width and a height");
    }
    return list;
  }

  [[nodiscard]] std::vector<std::string> texts() const {
    const auto* none = std::get_if<std::vector<double>>(&value_);
    if (none != nullptr && none->empty()) {
      require_count(0);
      return {};
    }
    std::vector<std::string> list = get<std::vector<std::string>>();
    require_count(list.size());
    for (std::string& text : list) {
      text = formed(text);
    }
    return list;
  }

  void require_count(std::size_t count) const {
    if (count < option_.least_count) {
      refuse("has too few entries");
    }
  }

  [[nodiscard]] std::string formed(const std::string& text) const {
    const bool known =
        std::find(option_.words.begin(), option_.words.end(), text) != option_.words.end();
    switch (option_.form) {
      case TextForm::any:
        break;
      case TextForm::word:
        return known ? text : (refuse("is not available"), text);
      case TextForm::path:
        return existing_file(text);
      case TextForm::color:
        return is_color(text) ? text : (refuse("is not a colour"), text);
      case TextForm::look:
        return known ? text : own_template(text);
      case TextForm::view:
        return known || is_azimuth_and_elevation(text) ? text : (refuse("is not available"), text);
      case TextForm::letters:
        return !text.empty() ? text : (refuse("is empty"), text);
      case TextForm::font:
        return is_font_path(text) ? existing_file(text) : text;
    }
    return text;
  }

  [[nodiscard]] std::string own_template(const std::string& text) const {
    const fs::path path(text);
    if (path.extension() != ".inc") {
      refuse("is not available");
    }
    if (!is_plain(path.stem().string())) {
      refuse("has a file name other than letters, digits, - and _, which POV-Ray needs");
    }
    return existing_file(text);
  }

  [[nodiscard]] std::string existing_file(const std::string& text) const {
    if (text.empty() || text.find('\0') != std::string::npos) {
      refuse("is not a path");
    }
    if (source_.paths == OptionSource::Paths::keep) {
      return text;
    }
    if (names_library(text)) {
      return find_in_library(text, source_.libraries, source_.place, option_.full_key(element_))
          .string();
    }
    const fs::path path = (source_.folder / text).lexically_normal();
    std::error_code ignored;  // what cannot be looked at does not exist for us
    const std::string key = option_.full_key(element_) + ": ";
    const fs::file_status status = fs::status(path, ignored);
    if (!fs::exists(status)) {
      throw Error(source_.place, key + "there is no file " + path.string(),
                  "check the path; it starts from the scene's folder unless it begins with /");
    }
    if (!fs::is_regular_file(status)) {
      throw Error(source_.place, key + path.string() + " is not a regular file",
                  "name a file, not a folder or device");
    }
    return path.string();
  }

  const Option& option_;
  std::size_t element_;
  const OptionValue& value_;
  const OptionSource& source_;
};

}  // namespace

OptionValue checked(const Option& option, std::size_t element, const OptionValue& value,
                    const OptionSource& source) {
  return Check(option, element, value, source).result();
}

}  // namespace collage
