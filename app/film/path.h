// A path: camera and lights at key frames, and straight lines in between. The file behind `--path`
// (docs/scene_format.md, "Camera and light paths").
// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "techniques/foundation/scene/model/scene.h"

namespace shadowlab::film {

/// The camera and all lights of a scene at one moment.
struct CameraAndLights {
    scene::Camera camera;
    std::vector<scene::Light> lights; ///< as many as the scene has, in its order
};

/// What a path says about one frame, made complete: what the file leaves out is as at the key before, or in the scene.
struct PathKey {
    int frame = 1; ///< counted from 1, like the numbers of the pictures
    CameraAndLights state;
};

class Path {
public:
    /// `keys` is not empty, and its frames increase.
    explicit Path(std::vector<PathKey> keys) : keys_(std::move(keys)) {}

    [[nodiscard]] int lastFrame() const { return keys_.back().frame; }
    /// At a key exactly what it says; between two keys every number goes evenly from one to the other, and directions
    /// are made unit vectors again; before the first and after the last key nothing moves. `frame` counts from 1.
    [[nodiscard]] CameraAndLights at(int frame) const;

private:
    std::vector<PathKey> keys_;
};

/// Reads a path for this scene. Throws Error (badInput, overLimit) with FILE:LINE:COLUMN: for what a scene file may not
/// say either, for lights that the scene does not have, and where interpolating between two keys is
/// impossible (opposite directions, a camera at its own target).
Path loadPath(const std::filesystem::path& file, const scene::Scene& scene);

/// The same from a text; `file` is named in errors.
Path parsePath(const std::string& text, const std::filesystem::path& file, const scene::Scene& scene);

} // namespace shadowlab::film
