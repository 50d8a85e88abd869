// What a technique says of a small picture of a scene: for the search in this process, and for the process in which a plug-in draws.
// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "app/picture/picture.h"
#include "app/picture/session.h"
#include "techniques/foundation/image/image.h"

namespace shadowlab::student {

/// Of a lesson's shape, so that what is found is seen in the same place there. Small: a picture takes some hundredths of a second.
constexpr int kSearchWidth = 160, kSearchHeight = 90;

/// The view of a picture of the search, or of one that is `scale` times as large on a side.
View foundView(const scene::Scene& scene, int scale = 1);

class SceneDrawer {
public:
    /// `settings`, "PARAM=VALUE", are for parameters that the technique has; others are left out. Needs a current GL context. Throws
    /// Error (usage) for an unknown technique.
    SceneDrawer(std::string_view technique, scene::Snapshot snapshot, const std::vector<std::string>& settings);

    void setScene(scene::Snapshot snapshot) { session_.setScene(std::move(snapshot)); }
    [[nodiscard]] picture::Session& session() { return session_; }
    [[nodiscard]] const TechniqueInfo& info() const { return *slot_.info; }

    /// Grey and alpha of each pixel of the stage `visibility` (judge::judge).
    std::vector<std::uint8_t> visibility(const View& view, int light);
    /// A stage as it is shown; without an id the finished picture.
    image::Image picture(const View& view, const StageKey& stage);

private:
    picture::Session session_;
    picture::Slot slot_;
    picture::PictureEncoder encoder_;
};

/// Fewer patches than a picture of one's own would have: form factors are found for every pair of them.
inline const std::vector<std::string> kSearchSettings = {"patches=160"};

} // namespace shadowlab::student
