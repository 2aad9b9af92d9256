#include "cli/finished_folder.h"

#include <exception>

#include <tbb/parallel_for_each.h>

#include "base/error.h"
#include "base/file.h"
#include "cli/read_mesh.h"
#include "cli/version.h"
#include "scene/sculpture_file.h"

namespace collage {
namespace {

namespace fs = std::filesystem;

Mesh read_input(const fs::path& folder, const Sculpture::Input& input, Repair repair) {
  const fs::path path = folder / input.path;
  if (sha256(read_file(path)) != input.sha256) {
    throw Error({path}, "is not the file that the sculpture was made from",
                "put the original back, or pack the scene again");
  }
  Status silent;  // what there was to say of the mesh was said when it was packed
  return read_mesh(path, repair, silent).mesh;
}

/// Reads meshes at the same time; of several that fail, it is the first one that is heard of.
class MeshReading {
 public:
  explicit MeshReading(const fs::path& folder) : folder_(folder) {}

  void add(const Sculpture::Input& input, Repair repair, Mesh& mesh) {
    jobs_.push_back({&input, repair, &mesh, {}});
  }

  void run() {
    tbb::parallel_for_each(jobs_, [this](Job& job) {
      try {
        *job.mesh = read_input(folder_, *job.input, job.repair);
      } catch (...) {
        job.failure = std::current_exception();
      }
    });
    for (const Job& job : jobs_) {
      if (job.failure) {
        std::rethrow_exception(job.failure);
      }
    }
  }

 private:
  struct Job {
    const Sculpture::Input* input;
    Repair repair;
    Mesh* mesh;
    std::exception_ptr failure;
  };
  const fs::path& folder_;
  std::vector<Job> jobs_;
};

}  // namespace

Sculpture read_finished_sculpture(const fs::path& folder) {
  if (!fs::exists(folder / "sculpture.json")) {
    throw Error({folder}, "holds no sculpture.json",
                "name a folder that `collage pack` or `collage make` has written");
  }
  return read_sculpture(folder / "sculpture.json");
}

FinishedFolder read_finished_folder(const fs::path& folder, Status& status) {
  FinishedFolder finished;
  finished.sculpture = read_finished_sculpture(folder);
  const Sculpture& sculpture = finished.sculpture;
  finished.elements.resize(sculpture.elements.size());
  finished.props.resize(sculpture.props.size());

  MeshReading reading(folder);
  for (std::size_t e = 0; e < finished.elements.size(); ++e) {
    reading.add(sculpture.elements[e], sculpture.options.elements[e].repair, finished.elements[e]);
  }
  for (std::size_t k = 0; k < finished.props.size(); ++k) {
    reading.add(sculpture.props[k], Repair::full, finished.props[k]);
  }
  if (sculpture.options.target.sdf.empty()) {
    reading.add(sculpture.target, sculpture.options.target.repair, finished.target.emplace());
  }
  reading.run();
  if (status.stop_requested()) {
    throw Interrupted();
  }
  return finished;
}

Composition composition_of(const FinishedFolder& finished) {
  const Sculpture& sculpture = finished.sculpture;
  Composition composition;
  composition.name = sculpture.options.name;
  composition.made_by = std::string("collage ") + version;
  for (std::size_t e = 0; e < finished.elements.size(); ++e) {
    const Scene::Element& options = sculpture.options.elements[e];
    composition.elements.push_back(
        {sculpture.elements[e].name, finished.elements[e], options.color, options.finish});
  }
  for (std::size_t k = 0; k < finished.props.size(); ++k) {
    composition.props.push_back({sculpture.props[k].path.stem().string(), finished.props[k]});
  }
  composition.instances = sculpture.instances;
  if (finished.target) {
    composition.target = &*finished.target;
    composition.target_box = bounding_box(*finished.target);
  }
  return composition;
}

}  // namespace collage
