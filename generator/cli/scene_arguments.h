#pragma once

#include <filesystem>
#include <string>

#include "cli/commands.h"
#include "scene/scene.h"

namespace collage {

/// A scene of the user's, else one of those that come with the program: "scenes/teapot", "teapot".
/// Throws Error where there is none.
std::filesystem::path find_scene(const std::string& name);

/// The scene with what the command line says of it.
Scene read_scene_with(const SceneArguments& arguments);

/// What made the sculpture, without what has no part in the result (folders, threads).
std::string command_text(const SceneArguments& arguments, const Scene& scene);

/// Where it goes: out/<name of the scene> unless the command line says otherwise.
std::filesystem::path output_folder(const SceneArguments& arguments, const Scene& scene);

}  // namespace collage
