// Loads scenes beside the running picture: a large mesh takes seconds, and nobody should wait for it with a dead window.
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

    /// Begins to load, or does so when what was asked for before is there, which is then forgotten: the limit of memory is for one.
    void begin(const std::string& nameOrPath);
    /// What is asked for and not there yet; empty: nothing.
    [[nodiscard]] const std::string& loading() const { return wanted_; }
    /// The scene that was asked for last, once.
    std::optional<Result> take();

private:
    void start();

    scene::LoadOptions options_;
    std::string wanted_;
    std::optional<std::future<Result>> running_; ///< its destructor waits: a loader does not outlive its files' limits
};

} // namespace shadowlab::lab
