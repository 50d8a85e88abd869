// A checked glTF file as the values that tinygltf makes of it, and the bytes of its buffers.
// SPDX-License-Identifier: MIT
#pragma once
// No file, no image is opened by the library: it would expand names as a shell does, and decode without limits.
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_FS
#include <tiny_gltf.h>

#include "techniques/foundation/scene/gltf/gltf_files.h"

namespace shadowlab::scene {

/// Throws Error (badInput) where tinygltf refuses what was checked.
tinygltf::Model tinygltfModel(const GltfSource& source);

/// The factor of an extension, a number; `otherwise` where there is none.
double gltfNumber(const tinygltf::Value& extension, const char* key, double otherwise);

} // namespace shadowlab::scene
