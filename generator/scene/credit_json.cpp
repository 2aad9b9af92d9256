#include "scene/credit_json.h"

#include "scene/json_text.h"

namespace collage {

std::string credit_json(const Credit& credit) {
  return "{\"title\": " + json_text(credit.title) + ", \"author\": " + json_text(credit.author) +
         ", \"licence\": " + json_text(credit.licence) + ", \"link\": " + json_text(credit.link) +
         "}";
}

Credit credit_from_json(const json_reader::json& value) {
  using json_reader::text;
  using json_reader::within;
  return {within(value, "title", text), within(value, "author", text),
          within(value, "licence", text), within(value, "link", text)};
}

}  // namespace collage
