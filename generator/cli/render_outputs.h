#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "render/shot.h"
#include "render/turntable.h"
#include "scene/scene.h"

namespace collage {

/// The shot that a scene's [render] table asks for, of one view.
Shot still_shot(const Scene& scene, const std::string& view);

/// The turntable that a scene asks for; `frames` may be 0.
Turntable turntable_of(const Scene& scene);

/// <folder>/stills/<view>.png or .exr.
std::filesystem::path still_path(const std::filesystem::path& folder, const Shot& shot);

/// Renders stills one after the other, each by all threads; returns where they are.
std::vector<std::filesystem::path> render_stills(const RenderTools& tools,
                                                 const std::filesystem::path& folder,
                                                 const Scene& scene);

/// The pictures of the stages of the assembly (Muhm 2011, Fig. 10), and their sheet,
/// sheets/stages.png.
std::vector<PictureJob> stage_jobs(const std::filesystem::path& folder, const Scene& scene);
std::filesystem::path write_stage_sheet(const std::filesystem::path& folder, const Scene& scene);

/// Renders the stages of the assembly (Muhm 2011, Fig. 10) and lays them out on sheets/stages.png.
std::filesystem::path render_stage_sheet(const RenderTools& tools,
                                         const std::filesystem::path& folder, const Scene& scene);

/// The films of a turntable that are there.
std::vector<std::filesystem::path> films(const std::filesystem::path& folder);

/// Lays the turntable's frames out on sheets/turntable.png.
std::filesystem::path write_turntable_sheet(const std::filesystem::path& folder,
                                            const Scene& scene);

/// All pictures that a scene asks for, the stills first; returns where they are.
std::vector<std::filesystem::path> render_outputs(const RenderTools& tools,
                                                  const std::filesystem::path& folder,
                                                  const Scene& scene);

}  // namespace collage
