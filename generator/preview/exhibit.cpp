#include "preview/exhibit.h"

namespace collage {

Exhibit exhibit_of(const Composition& composition, const PreviewShown& shown, const Stand& stand) {
  Exhibit exhibit;
  for (const auto* shapes : {&composition.elements, &composition.props}) {
    for (const Composition::Element& shape : *shapes) {
      exhibit.meshes.push_back(&shape.mesh);
    }
  }
  const double end = shown.stage * static_cast<double>(composition.instances.size());
  for (std::size_t i = 0; static_cast<double>(i) < end; ++i) {
    const Instance& instance = composition.instances[i];
    if (!shown.element || instance.element == *shown.element) {
      exhibit.instances.push_back(stand.studio_from_world(instance));
    }
  }
  for (std::size_t k = 0; k < composition.props.size(); ++k) {
    Instance prop;
    prop.element = static_cast<std::uint32_t>(composition.elements.size() + k);
    exhibit.instances.push_back(stand.studio_from_world(prop));
  }
  return exhibit;
}

}  // namespace collage
