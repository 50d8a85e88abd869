// SPDX-License-Identifier: MIT
#include "app/foreign/export/export_scene.h"

#include "app/foreign/calibration_board.h"
#include "app/foreign/export/readme.h"
#include "techniques/foundation/image/output_file.h"

namespace shadowlab::foreign {

void exportScene(const scene::Scene& scene, const ExportRequest& request, const std::filesystem::path& folder) {
    const PlainScene plain = plainScene(scene);
    request.format->write({plain, folder, "scene", request.size, request.threeModule});
    request.format->write({plainScene(calibrationBoard(scene.camera, request.size)), folder, "calibration", request.size, request.threeModule});
    image::writeWhole(folder / "README.md", readmeText(*request.format, plain, request.scene, request.command, request.size));
}

} // namespace shadowlab::foreign
