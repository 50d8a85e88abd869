// Loads scenes on a thread of its own: a large mesh takes seconds, in which the window must still react.
// SPDX-License-Identifier: MIT
#pragma once
#include <future>
#include <optional>
#include <string>

#include "techniques/foundation/scene/load/load.h"

namespace shadowlab::lab {

class SceneLoader {
public:
    struct Result {
        std::string nameOrPath;
        scene::Snapshot scene; ///< null when it could not be loaded
        std::string fault;     ///< then: `FILE:LINE: what is wrong; what to do`
    };

    explicit SceneLoader(scene::LoadOptions options) : options_(std::move(options)) {}

    /// Begins to load; while another scene is still being loaded, waits for that one and discards it, because the limit of memory is for
    /// one scene.
    void begin(const std::string& nameOrPath);
    /// The scene that is being loaded; empty: none.
    [[nodiscard]] const std::string& loading() const { return wanted_; }
    /// The scene that was requested last; returned only once.
    std::optional<Result> take();

private:
    void start();

    scene::LoadOptions options_;
    std::string wanted_;
    std::optional<std::future<Result>> running_; ///< its destructor waits: a loader does not outlive its files' limits
};

} // namespace shadowlab::lab
