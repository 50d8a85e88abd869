// SPDX-License-Identifier: MIT
#include "app/student/grading/graded_scene.h"

#include "app/context/assets.h"
#include "app/picture/limits.h"
#include "techniques/foundation/scene/load/load.h"

namespace shadowlab::student {

scene::Snapshot loadGradedScene(const std::filesystem::path& file) {
    return scene::loadScene(file.string(), {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = picture::limits()});
}

} // namespace shadowlab::student
