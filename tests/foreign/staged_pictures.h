// The scenes of another renderer (foreign_scenes.h) as the program reads them, and that renderer's pictures as the program judges them.
// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "app/foreign/judged_picture.h"
#include "techniques/foundation/scene/load/load.h"
#include "tests/foreign/foreign_renderer.h"
#include "tests/foundation/scene/scene_files.h"

namespace shadowlab::foreign {

using foreign_renderer::Pictures;
using foreign_renderer::Settings;

inline image::Image imageOf(const foreign_renderer::Picture& picture) {
    image::Image image(picture.width, picture.height);
    for (std::size_t i = 0; i < picture.grey.size(); ++i)
        for (std::size_t channel = 0; channel < 4; ++channel)
            image.rgba[4 * i + channel] = channel == 3 ? 255 : picture.grey[i];
    return image;
}

struct Staged {
    foreign_renderer::Scene own;
    scene::Snapshot scene;
};

/// The scene, loaded by the program from the files that are written for it.
inline Staged stagedScene(const foreign_renderer::Scene& own) {
    const scene::TempFolder folder;
    for (const auto& [name, content] : foreign_renderer::filesOf(own))
        folder.write(name, content);
    return {own, scene::loadScene((folder.path() / "scene.json").string(), {})};
}

inline const std::vector<Staged>& staged() {
    static const std::vector<Staged> all = [] {
        std::vector<Staged> made;
        for (const foreign_renderer::Scene& own : foreign_renderer::scenes())
            made.push_back(stagedScene(own));
        return made;
    }();
    return all;
}

/// The scene whose light is a spot of 30 degrees, which lights a part of the picture. The other renderer's scene stays as it is.
inline Staged underASpot(const Staged& stage) {
    auto spot = std::make_shared<scene::Scene>(*stage.scene);
    scene::Light& light = spot->lights[0];
    light.type = scene::LightType::spot;
    light.directionWorld = glm::normalize(spot->camera.targetWorld - light.positionWorld);
    light.coneDegrees = 30;
    return {stage.own, spot};
}

inline std::string said(const JudgedPicture& judged) {
    const judge::Counts& counts = judged.errors.judgement.counts;
    std::string text = "false lit " + std::to_string(counts.falseLit) + ", false shadow " + std::to_string(counts.falseShadow) + ", core " + std::to_string(judged.core) +
                       ", ties " + std::to_string(counts.ties) + ", not judged " + std::to_string(judged.found.notJudged) + "\n";
    for (const NamedCause& cause : judged.diagnosis.causes)
        text += "  " + cause.id + " (" + std::to_string(cause.explained) + ", " + std::to_string(cause.explainedInRegion) + "): " + cause.what + "\n";
    return text;
}

inline JudgedPicture judgedVisibility(const Staged& stage, const Pictures& pictures) { return judgePicture(stage.scene, 0, truthOfLight(stage.scene->light(0)), imageOf(pictures.visibility), nullptr); }
inline JudgedPicture judgedPair(const Staged& stage, const Pictures& pictures) {
    const image::Image reference = imageOf(pictures.unshadowed);
    return judgePicture(stage.scene, 0, truthOfLight(stage.scene->light(0)), imageOf(pictures.shaded), &reference);
}

} // namespace shadowlab::foreign
