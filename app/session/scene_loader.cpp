// SPDX-License-Identifier: MIT
#include "app/session/scene_loader.h"

#include <chrono>
#include <exception>
#include <new>

namespace shadowlab::session {

void SceneLoader::begin(const std::string& nameOrPath) {
    wanted_ = nameOrPath;
    running_.push_back(std::async(std::launch::async, [nameOrPath, options = options_] {
        Result result{nameOrPath, nullptr, ""};
        try {
            result.scene = scene::loadScene(nameOrPath, options);
        } catch (const std::bad_alloc&) {
            result.fault = nameOrPath + ": there is not enough memory for it; use a smaller scene";
        } catch (const std::exception& fault) {
            result.fault = fault.what();
        }
        return result;
    }));
}

std::optional<SceneLoader::Result> SceneLoader::take() {
    std::optional<Result> arrived;
    for (auto one = running_.begin(); one != running_.end();) {
        if (one->wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
            ++one;
            continue;
        }
        Result result = one->get();
        one = running_.erase(one);
        if (result.nameOrPath == wanted_) arrived = std::move(result);
    }
    if (arrived) wanted_.clear();
    return arrived;
}

} // namespace shadowlab::session
