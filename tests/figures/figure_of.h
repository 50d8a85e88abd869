// A figure of one pixel of a built-in scene, and whether it can be read.
// SPDX-License-Identifier: MIT
#pragma once
#include <gtest/gtest.h>

#include <map>
#include <optional>

#include "app/figures/figures.h"
#include "app/picture/session.h"
#include "techniques/foundation/base/error.h"
#include "techniques/foundation/scene/load/load.h"
#include "tests/figures/written.h"

namespace shadowlab::figures {

struct Setting {
    const char *param, *value;
};

/// What is asked, and what the technique says.
struct FigureOf {
    FigureOf(const std::string& name, std::string technique, ivec2 at, std::vector<Setting> settings = {},
             int whichLight = 0, std::optional<ivec2> partner = {})
        : technique(std::move(technique)), light(whichLight) {
        static std::map<std::string, scene::Snapshot> loaded;
        scene::Snapshot& kept = loaded[name];
        if (!kept) kept = scene::loadScene(name, {.assetsRoot = context::assetsRoot(), .allowed = {}, .limits = {}});
        scene = kept;
        picture::Slot slot = picture::Session::makeSlot(this->technique);
        for (const Setting& setting : settings)
            params::setFromText(params::find(slot.params, setting.param, this->technique), setting.value,
                                this->technique);
        view.camera = scene->camera;
        view.size = {1280, 720};
        view.picked = at;
        view.partner = partner;
        probe = slot.technique->probe(scene, view, at, light);
    }
    [[nodiscard]] Diagram draw(const char* figure, dvec2 room = {930, 800}) const {
        return findFigure(figure).draw({probe, technique, *scene, view, light, testFont(), testBoldFont(), room});
    }
    std::string technique;
    scene::Snapshot scene;
    View view;
    int light;
    Probe probe;
};

/// Type is large enough, no label covers another, all of it lies on the sheet. Returns the number of pairs that were compared.
inline int expectReadable(const Diagram& drawn, const std::string& what) {
    const std::string document = drawn.document();
    EXPECT_EQ(document.find("nan"), std::string::npos) << what;
    EXPECT_EQ(document.find("inf\""), std::string::npos) << what;
    const dvec2 size = drawn.drawing.size();
    std::vector<Written> all = written(document);
    for (Written& one : all) { // widths are measured in whole pixels, and an index follows its letter at once
        one.box.corner.x += 1;
        one.box.size.x -= 2;
    }
    int compared = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        // Indices of a formula are smaller than the letters they belong to.
        EXPECT_GE(all[i].em, 0.69 * 24) << what << ": " << all[i].text;
        EXPECT_GE(all[i].box.corner.x, 0) << what << ": " << all[i].text;
        EXPECT_LE(all[i].box.corner.x + all[i].box.size.x, size.x) << what << ": " << all[i].text;
        EXPECT_LE(all[i].box.corner.y + all[i].box.size.y, size.y) << what << ": " << all[i].text;
        for (std::size_t j = 0; j < i; ++j, ++compared)
            EXPECT_FALSE(all[i].box.overlaps(all[j].box)) << what << ": " << all[i].text << " covers " << all[j].text;
    }
    return compared;
}

/// Circles of a drawing that mark that.
inline std::vector<drawing::Circle> circlesOf(const Diagram& drawn, const std::string& name) {
    std::vector<drawing::Circle> circles;
    for (const drawing::Mark& mark : drawn.drawing.marks())
        if (const auto* circle = std::get_if<drawing::Circle>(&mark); circle && circle->name == name) circles.push_back(*circle);
    return circles;
}

inline bool says(const Diagram& drawn, const std::string& text) {
    for (const drawing::Mark& mark : drawn.drawing.marks())
        if (const auto* line = std::get_if<drawing::TextLine>(&mark); line && line->text.find(text) != std::string::npos)
            return true;
    return false;
}

} // namespace shadowlab::figures
