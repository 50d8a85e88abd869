// The time of a pass: wall-clock time between two calls of glFinish.
//
// GL timer queries are of no use here: a software renderer such as llvmpipe batches the commands of several passes, so its
// timestamps charge all the work to the pass that happens to flush the batch. glFinish serialises the driver and costs a
// graphics card some overlap between passes, so it is called only if times are asked for.
// SPDX-License-Identifier: MIT
#pragma once
#include <glad/gl.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace shadowlab::gl {

class PassTimer {
public:
    struct Result {
        std::string name;
        double elapsedMs;
    };

    /// Runs `draw` and waits for it. Passes of one name are added up.
    template <typename Draw>
    void time(const std::string& name, Draw&& draw) {
        glFinish();
        const auto begin = std::chrono::steady_clock::now();
        draw();
        glFinish();
        const std::chrono::duration<double, std::milli> elapsed = std::chrono::steady_clock::now() - begin;
        const auto known = std::ranges::find(results_, name, &Result::name);
        if (known == results_.end())
            results_.push_back({name, elapsed.count()});
        else
            known->elapsedMs += elapsed.count();
    }

    /// The times since the last call, in the order the passes first ran.
    std::vector<Result> take() { return std::exchange(results_, {}); }

private:
    std::vector<Result> results_;
};

} // namespace shadowlab::gl
