// SPDX-License-Identifier: MIT
#include "app/report/part_file.h"

#include "app/session/limits.h"
#include "techniques/foundation/error.h"
#include "techniques/foundation/scene/file_access.h"

namespace shadowlab::report {

std::string partBytes(const std::filesystem::path& file) {
    if (const std::string why = scene::whyUnreadable(file); !why.empty())
        throw Error(ExitStatus::badInput, file.string() + ": " + why + "; look at its permissions, or delete it");
    const scene::Limits& limits = session::limits();
    return file.extension() == ".png" ? scene::readFile(file, limits.imageFileBytes, "image-file")
                                      : scene::readFile(file, limits.sceneFileBytes, "scene-file");
}

bool isText(const std::string& bytes) { return bytes.find('\0') == std::string::npos; }

} // namespace shadowlab::report
