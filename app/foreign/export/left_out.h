// Sentences about what a format does not say of a scene. Each says so only where the scene has it.
// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "app/foreign/export/plain_scene.h"

namespace shadowlab::foreign {

/// Collects the sentences of one format about one scene.
class LeftOut {
public:
    explicit LeftOut(const PlainScene& scene) : scene_(scene) {}

    void add(const std::string& sentence) { sentences_.push_back(sentence); }
    /// With the names of those that have it: `light "lamp", light "bulb": sentence`. Nothing where there is none.
    void lights(const std::function<bool(const scene::Light&)>& has, const std::string& sentence);
    void materials(const std::function<bool(const PlainMaterial&)>& has, const std::string& sentence);
    void meshes(const std::function<bool(const PlainMesh&)>& has, const std::string& sentence);

    // What several formats leave out alike.
    void noCastsShadow();
    void noReceivesShadow();
    void noAmbient();
    void noBackground();
    void noExposure();
    void noNear();
    void soften(const std::string& sentence); ///< of spots with an edge

    [[nodiscard]] std::vector<std::string> take() { return std::move(sentences_); }

private:
    void named(std::vector<std::string> names, const std::string& sentence);

    const PlainScene& scene_;
    std::vector<std::string> sentences_;
};

bool isMirror(const PlainMaterial& material);
bool isGlass(const PlainMaterial& material);
bool shines(const PlainMaterial& material);
bool hasHighlight(const PlainMaterial& material);
bool isBlurred(const PlainMaterial& material); ///< a mirror or glass that spreads rays

} // namespace shadowlab::foreign
