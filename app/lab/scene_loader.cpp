// SPDX-License-Identifier: MIT
#include "app/lab/scene_loader.h"

#include <chrono>
#include <exception>
#include <new>

namespace shadowlab::lab {

void SceneLoader::begin(const std::string& nameOrPath) {
    wanted_ = nameOrPath;
    if (!running_) start();
}

void SceneLoader::start() {
    running_ = std::async(std::launch::async, [nameOrPath = wanted_, options = options_] {
        Result result{nameOrPath, nullptr, ""};
        try {
            result.scene = scene::loadScene(nameOrPath, options);
        } catch (const std::bad_alloc&) {
            result.fault = nameOrPath + ": there is not enough memory for it; use a smaller scene";
        } catch (const std::exception& fault) {
            result.fault = fault.what();
        }
        return result;
    });
}

std::optional<SceneLoader::Result> SceneLoader::take() {
    if (!running_ || running_->wait_for(std::chrono::seconds(0)) != std::future_status::ready) return {};
    Result result = running_->get();
    running_.reset();
    if (result.nameOrPath != wanted_) { // another was asked for meanwhile
        start();
        return {};
    }
    wanted_.clear();
    return result;
}

} // namespace shadowlab::lab
