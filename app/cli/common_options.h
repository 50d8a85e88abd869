// What several commands have in common: their options, how their files are loaded, and the limits of the driver.
// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "app/cli/options.h"
#include "app/context/context.h"
#include "techniques/foundation/math/types.h"
#include "techniques/foundation/scene/load/load.h"

namespace shadowlab::cli {

/// The argument SCENE: one scene.
void describeScene(DescribedOptions& add);

/// --view: one of the scene's own cameras, in place of the one it begins with.
void describeView(DescribedOptions& add);
/// The scene, seen from the view of that name; from its own camera where `view` is empty. Throws Error, also for an unknown view (usage).
scene::Snapshot loadSeenFrom(const std::string& scene, const std::string& view, const scene::LoadOptions& loading);
/// The index of the light of that name; of the first where `name` is empty. Truth is visibility of a light: without one, there is nothing to
/// be right or wrong about. `asked`: the scene as it was asked for; `done`: to its shadows, "measured". Throws Error (badInput) where the
/// scene has no light, and for an unknown name.
int lightWithShadows(const scene::Scene& scene, const std::string& asked, const std::string& name, const std::string& done);
/// --normals: those of a mesh that is given by itself, as a scene file says it of its objects.
void describeNormals(DescribedOptions& add);
/// Nothing where the option is not written. Throws Error (usage) where `scene` is no mesh.
std::optional<scene::NormalMode> normalsFrom(const GivenOptions& given, const std::string& scene);

/// --backend: which OpenGL context draws.
void describeBackend(DescribedOptions& add);
/// Throws Error (usage) for an unknown backend.
context::Backend backendFrom(const GivenOptions& given);

/// How scenes, lessons and decks are loaded: with the program's assets and limits, the folders of --allow and what --normals says.
scene::LoadOptions loadOptions(std::vector<std::filesystem::path> allowed, std::optional<scene::NormalMode> normals = {});

/// Throws Error (overLimit) when the driver of the current context draws no pictures of that size, in pixels.
void requireDriverDraws(ivec2 size);

} // namespace shadowlab::cli
