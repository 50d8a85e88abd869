// tinygltf, compiled here from its packaged header.
// SPDX-License-Identifier: MIT
#include <fstream> // of its functions that write, which nothing here calls

#define TINYGLTF_IMPLEMENTATION
#include "techniques/foundation/scene/gltf/gltf_model.h"

#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/load/message_text.h"

namespace shadowlab::scene {

tinygltf::Model tinygltfModel(const GltfSource& source) {
    tinygltf::TinyGLTF reader;
    tinygltf::Model model;
    std::string error, warning;
    const std::string& text = source.checkedText();
    if (text.size() > 0xffffffffu || // it counts in 32 bits
        !reader.LoadASCIIFromString(&model, &error, &warning, text.c_str(), static_cast<unsigned>(text.size()), "", tinygltf::NO_REQUIRE))
        source.document().fail(0, "tinygltf refuses the file: " + shown(error, 200) + "; export the model again");
    return model;
}

double gltfNumber(const tinygltf::Value& extension, const char* key, double otherwise) {
    if (!extension.IsObject() || !extension.Has(key)) return otherwise;
    const tinygltf::Value& value = extension.Get(key);
    return value.IsNumber() ? value.GetNumberAsDouble() : otherwise;
}

} // namespace shadowlab::scene
